# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Errors and costs over meshes and tolerances together, in words and tables."""

from common import page

from . import front, mesh_and_time
from .cases import DEFAULT_TOLERANCE
from .tables import cell, count, interval, value

# The published scene's error is to fall to this part of an interval, in %.
GOAL = 0.5
# Between a held and a free side with nu = 0.3.
ORDER = 1.42
COSTS = (("cpu_seconds", "CPU seconds"), ("work", "cycles times vertices"))


def with_work(records):
    """Records with the cycles times the vertices, which no other program changes."""
    return [r | {"work": value(r, "cycles") * value(r, "vertices")} for r in records]


def grid_of(records):
    """The runs over meshes and tolerances."""
    return [r for r in with_work(records)
            if not r["family"] and value(r, front.ERROR) > 0]


def percent(record):
    return value(record, front.ERROR) * 100 / interval(record)


def find(records, mesh, tolerance=DEFAULT_TOLERANCE):
    return next((r for r in records
                 if r["mesh"] == mesh and r["tolerance"] == tolerance), None)


def mesh_names(records):
    return list(dict.fromkeys(r["mesh"] for r in records))


def overview(grid):
    """A row for each mesh, a column for each tolerance; what is on the front is bold."""
    best = front.efficient(grid, "cpu_seconds")

    def entry(mesh, tolerance):
        record = find(grid, mesh, tolerance)
        if record is None:
            return "–"
        text = f"{page.number(percent(record))} in {cell(record, 'cpu_seconds', digits=2)}"
        return f"**{text}**" if record in best else text

    tolerances = sorted({r["tolerance"] for r in grid}, key=float, reverse=True)
    return page.table(
        ["mesh", "vertices", *tolerances],
        [[mesh, count(find(grid, mesh) or {}, "vertices"),
          *(entry(mesh, tolerance) for tolerance in tolerances)]
         for mesh in mesh_names(grid)],
    )


def front_table(grid):
    """The runs that no other one beats, by one cost or by both."""
    fronts = {cost: front.efficient(grid, cost) for cost, _ in COSTS}
    chosen = [r for r in grid if any(r in own for own in fronts.values())]
    rows = [
        [r["mesh"], r["tolerance"], count(r, "vertices"), count(r, "steps"),
         count(r, "cycles"), cell(r, "cpu_seconds", digits=3), search_share(r),
         cell(r, "shift_first_event_s", 1e3), cell(r, front.ERROR, 1e3),
         cell(r, "error_event_time_max_s", 1e3), page.number(percent(r)),
         " and ".join(name for cost, name in COSTS if r in fronts[cost])]
        for r in sorted(chosen, key=lambda r: -percent(r))
    ]
    return page.table(
        ["mesh", "tolerance", "vertices", "steps solved", "cycles", "CPU, s",
         "of it the search, %", "first event, ms", "four events, rms, ms",
         "largest, ms", "rms, % of an interval", "on the front by"], rows)


def search_share(record):
    search = value(record, "search_cpu_seconds")
    if search != search:
        return "–"
    return f"{100 * search / value(record, 'cpu_seconds'):.1f}"


def mesh_table(records):
    """All meshes at the default tolerance, with what the search for each takes."""
    grid = grid_of(records)
    own = [r for r in grid if r["tolerance"] == DEFAULT_TOLERANCE]
    return page.table(
        ["mesh", "vertices", "on the fault", "CPU, s", "of it the search",
         "first event, ms", "four events, rms, ms", "largest, ms",
         "rms, % of an interval"],
        [[r["mesh"], count(r, "vertices"), count(r, "fault_nodes"),
          cell(r, "cpu_seconds", digits=3), cell(r, "search_cpu_seconds"),
          cell(r, "shift_first_event_s", 1e3), cell(r, front.ERROR, 1e3),
          cell(r, "error_event_time_max_s", 1e3), page.number(percent(r))]
         for r in own])


def goal_text(grid):
    """The cheapest run below the goal, beside the published mesh."""
    published = find(grid, mesh_and_time.PUBLISHED)
    within = [r for r in grid if percent(r) <= GOAL]
    if not (published and within):
        return ""
    best = min(within, key=lambda r: value(r, "cpu_seconds"))
    cheapest = min(within, key=lambda r: r["work"])
    return (
        f"{GOAL:g} % of an interval and less take at least "
        f"{cell(best, 'cpu_seconds', digits=3)} s ({best['mesh']}, tolerance "
        f"{best['tolerance']}: {page.number(percent(best))} %), and as cycles times "
        f"vertices at least {cheapest['work'] / 1e6:.0f} million ({cheapest['mesh']}, "
        f"tolerance {cheapest['tolerance']}: {page.number(percent(cheapest))} %). The "
        f"published mesh at the default tolerance takes "
        f"{cell(published, 'cpu_seconds', digits=3)} s and "
        f"{published['work'] / 1e6:.0f} million for "
        f"{page.number(percent(published))} %.\n"
    )


def body_table(records, grid):
    """Other tolerances of the bodies, beside the run with the default one."""
    own = [r for r in with_work(records) if r["family"].startswith("body tolerance")]
    if not own:
        return ""
    default = find(grid, own[0]["mesh"])
    own = ([default | {"family": "body tolerance 1e-3 (default)"}] if default else []) + own
    return page.table(
        [f"{own[0]['mesh']}, tolerance {DEFAULT_TOLERANCE}", "steps solved", "cycles",
         "CPU, s", "four events, rms, ms"],
        [[r["family"], count(r, "steps"), count(r, "cycles"),
          cell(r, "cpu_seconds", digits=3), cell(r, front.ERROR, 1e3)] for r in own])


def check_table(records):
    """How far other fine runs are from the reference, and a limit of two of them."""
    own = [r for r in records if r["family"] == mesh_and_time.CHECKS]
    table = page.table(
        ["mesh", "tolerance", "vertices", "cycles", "CPU, s", "first event, ms",
         "four events, rms, ms", "largest, ms"],
        [[r["mesh"], r["tolerance"], count(r, "vertices"), count(r, "cycles"),
          cell(r, "cpu_seconds", digits=3), cell(r, "shift_first_event_s", 1e3),
          cell(r, front.ERROR, 1e3), cell(r, "error_event_time_max_s", 1e3)]
         for r in own])
    for r in records:
        if r["family"] == mesh_and_time.STEPS:
            table += (
                f"\nOn the mesh {r['mesh']} events with the tolerance of the reference "
                f"and with {r['tolerance']} are {cell(r, front.ERROR, 1e3)} ms apart "
                "(root of the mean square).\n")
    shifts = [value(r, "shift_first_event_s") for r in own if "1 pass" in r["mesh"]]
    if len(shifts) != 2:
        return table
    limit = shifts[1] + (shifts[1] - shifts[0]) / (2**ORDER - 1)
    return table + (
        "\nExtrapolated with the order 1.42 of the corners, the two meshes of cells of "
        f"one size have their first event {1e3 * limit:.2g} ms from the reference.\n")


def text(records):
    grid = grid_of(records)
    return "\n".join(part for part in (
        "Error of the four events in % of an interval, and CPU seconds; bold what no "
        "other run beats in both:\n",
        overview(grid),
        goal_text(grid),
        "The front:\n",
        front_table(grid),
        body_table(records, grid),
        "How far others are from the reference, the last row:\n",
        check_table(records),
    ) if part)
