# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""How many vertices meshes would need that follow the fronts during a run, beside one
mesh that is good at all times."""

import functools

import numpy as np

from common import page, programs

from . import mesh_and_time, mesh_search, quadtrees, records
from .cases import DEFAULT_TOLERANCE, bodies
from .moving_fields import LEVELS, Fields, FieldsCase
from .slider import OUTPUT, SCENE
from .tables import value

PAGE = programs.PROJECT / "doc/meshes.md"
# Relative errors of the energy of displacements, and of that of velocities.
ALLOWED = (
    (7.5e-3, None), (2e-3, None),
    (7.5e-3, 0.2), (7.5e-3, 0.05), (7.5e-3, 7.5e-3), (2e-3, 0.05),
)
# Steps for which a mesh stays.
KEPT = (1, 30, 100, 300)
# Of the scene; the energy is needed in proportion only.
MATERIAL = 4.12e7, 0.3


def levels_of(fields):
    """Errors of each body's cells relative to the energy of both bodies, and those on
    the mesh before the finest one."""
    matrix = quadtrees.element_matrix(*MATERIAL)
    parts, energies = zip(*(quadtrees.errors(f, matrix, LEVELS) for f in fields))
    whole = sum(energies)
    if whole == 0:
        return None
    return [[of_cells / whole for of_cells in part] for part in parts]


def needed(errors, allowed):
    """Cells to be refined at one time, closed to edges that are halved once."""
    meshes = None
    for field, limit in zip(("displacement", "velocity"), allowed):
        if limit is None or errors[field] is None:
            continue
        own = quadtrees.smallest(errors[field], limit)
        meshes = own if meshes is None else list(map(quadtrees.union, meshes, own))
    return list(map(quadtrees.balanced, meshes))


def size(meshes):
    return sum(map(quadtrees.vertices, meshes))


def joined(many):
    return functools.reduce(
        lambda a, b: list(map(quadtrees.union, a, b)), many)


def groups(weights, n_steps):
    """Runs of sets that together have at most so many steps, or are one set."""
    result, sum_of_last = [], n_steps
    for i, weight in enumerate(weights):
        if sum_of_last + weight > n_steps or not result:
            result.append([])
            sum_of_last = 0
        result[-1].append(i)
        sum_of_last += weight
    return result


def mean_kept(meshes, weights, n_steps):
    """Mean number of vertices over the steps, and of meshes, if each is good for so
    many steps to come."""
    total, own = 0, groups(weights, n_steps)
    for group in own:
        total += size(joined(meshes[i] for i in group)) * weights[group].sum()
    return total / weights.sum(), len(own)


def percent(part):
    return f"{100 * part:.2g} %"


def row(errors, weights, times, in_events, allowed):
    meshes = [needed(e, allowed) for e in errors]
    sizes = np.array(list(map(size, meshes)))
    fixed = size(joined(meshes))
    kept = [mean_kept(meshes, weights, n) for n in KEPT]

    def mean(chosen):
        return np.average(sizes[chosen], weights=weights[chosen])

    lengths = np.gradient(times)
    return [
        *("–" if a is None else percent(a) for a in allowed), f"{fixed:,}",
        f"{np.average(sizes, weights=lengths):,.0f}", f"{mean(~in_events):,.0f}",
        f"{mean(in_events):,.0f}", f"{sizes[weights > 0].max():,}",
        *(f"{n:,.0f} ({fixed / n:.2f})" for n, _ in kept),
    ], kept


def outcome(store):
    """The table, and what is said about the run."""
    fields = Fields(store.run(FieldsCase()))
    weights, times, in_events = fields.weights(), fields.times, fields.in_events()
    errors = [
        {name: levels_of(values) for name, values in fields.at(i).items()}
        for i in range(len(times))
    ]
    finest = {
        name: max(sum(part[-1].sum() for part in e[name]) for e in errors if e[name])
        for name in ("displacement", "velocity")
    }
    rows = []
    for allowed in ALLOWED:
        cells, kept = row(errors, weights, times, in_events, allowed)
        rows.append(cells)
    table = page.table(
        ["displacement", "velocity", "one mesh", "mean over time", "steps of loading",
         "steps of events", "most",
         *(f"a mesh for {n} steps" if n > 1 else "a mesh for each set" for n in KEPT)],
        rows)
    changes = ", ".join(f"{number:,}" for _, number in kept)
    return (
        f"{len(times)} sets of fields from 1 s on, {weights.sum():,} steps, of them "
        f"{weights[in_events].sum():,} in the two events. Interpolated from cells twice "
        "as large as those of the run, the energy of displacements has an error of at "
        f"most {percent(finest['displacement'])}, that of velocities of "
        f"{percent(finest['velocity'])}.\n\n" + table
        + f"\nThe last columns are means over all steps, in brackets the number of one "
        f"mesh over them; they take {changes} meshes.\n"
    )


def setup_text(program):
    """What beginning on a mesh costs, from two sizes, in steps on that mesh."""
    sizes = {}
    for n_times in (3, 4):
        settings = bodies(Refinement_passes=0, Uniform_refinements=n_times)
        rows, columns = 2 * 2**n_times + 1, 10 * 2**n_times + 1
        sizes[2 * rows * columns] = mesh_search.fastest(
            program, SCENE, OUTPUT | settings | mesh_search.END)
    (small, fast), (large, slow) = sizes.items()
    for_setup = (slow - fast) / (large - small)
    run = next((r for r in records.read() if r["section"] == mesh_and_time.SECTION
                and r["mesh"] == mesh_and_time.MESHES[-1][0]
                and r["tolerance"] == DEFAULT_TOLERANCE), {})
    for_step = value(run, "cpu_seconds") / value(run, "steps") / value(run, "vertices")
    return (
        f"\nTo set up a mesh takes {1e6 * for_setup:.2g} microseconds a vertex, and a step "
        f"of the spring slider {1e6 * for_step:.2g}: as much as {for_setup / for_step:.0f} "
        "steps.\n")


def measure(store, quick):
    text = outcome(store) + setup_text(store.program)
    if quick:
        print("\n" + text, flush=True)
    else:
        page.replace_section("moving", text, PAGE, "contrib/accuracy")
