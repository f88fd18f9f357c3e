# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The runs over meshes and tolerances of the steps together."""

from .cases import DEFAULT_TOLERANCE, TOLERANCE, bodies, pairs
from .mesh_search import ENTRY
from .slider import Case

SECTION = "mesh and time"
PUBLISHED = "published"
TOLERANCES = ("1.3e-5", "4.5e-6", DEFAULT_TOLERANCE, "4.5e-7", "1.3e-7")


def accurate(value, **entries):
    """The mesh that the program finds from the coarse cells on."""
    return f"accuracy {value}", {ENTRY: value} | bodies(Refinement_passes=0, **entries)


def bounded(cells, value):
    """An accuracy, from cells of one size on. The mesh that a search ends with has all
    cells of another one halved."""
    across, along = cells
    name, entries = accurate(
        value, Coarse_cells=f"{across}, {along}", Uniform_refinements=1)
    return f"at least {4 * across} x {4 * along} cells, {name}", entries


def halved(n_times):
    """From 20 x 4 cells: the coarsest mesh is factorised, and had better be small."""
    return (f"{20 * 2**n_times} x {4 * 2**n_times} cells, 1 pass",
            bodies(Coarse_cells="20, 4", Uniform_refinements=n_times,
                   Refinement_passes=1))


# Not run with the smallest tolerances, which change little elsewhere.
FINE_MESHES = bounded((16, 3), "2e-3"), bounded((20, 4), "2e-3")
OF_FINE_MESHES = TOLERANCES[:3]
MESHES = (
    (PUBLISHED, {}),
    halved(1),
    halved(2),
    *map(accurate,
         ("3e-2", "1.5e-2", "1e-2", "7.5e-3", "6e-3", "5e-3", "3e-3", "2e-3")),
    bounded((10, 2), "3e-3"),
    bounded((16, 3), "3e-3"),
    *FINE_MESHES,
)
BODY_TOLERANCES = ("1e-5", "1e-4", "1e30")
CHECKS = "check of the reference"
STEPS = "error of the steps of the reference"


def case_of(mesh, tolerance, reference, family="", settings=None):
    name, entries = mesh
    all_settings = entries | (settings or {})
    if tolerance != DEFAULT_TOLERANCE:
        all_settings = all_settings | {TOLERANCE: tolerance}
    return Case(SECTION, family, tolerance, pairs(all_settings), name, reference)


# Cells of one size for the waves, smaller ones where energies have their errors.
FINEST = ("160 x 32 cells and accuracy 2e-4",
          accurate("2e-4", Coarse_cells="20, 4", Uniform_refinements=2)[1])
REFERENCE = case_of(FINEST, "1.3e-7", None, CHECKS)


def checks():
    """Runs that tell how far the reference can be trusted: on cells of one size, on
    meshes of the program's choice alone, with smaller steps."""
    return [
        *(case_of(halved(n), "1.3e-7", REFERENCE, CHECKS) for n in (2, 3)),
        case_of(accurate("1e-3"), "1.3e-8", REFERENCE, CHECKS),
        *(case_of(accurate("5e-4"), tolerance, REFERENCE, CHECKS)
          for tolerance in ("1.3e-7", "1.3e-8")),
        REFERENCE,
    ]


def all_cases():
    grid = [case_of(mesh, tolerance, REFERENCE)
            for mesh in MESHES for tolerance in TOLERANCES
            if mesh not in FINE_MESHES or tolerance in OF_FINE_MESHES]
    of_bodies = [
        case_of(accurate("5e-3"), DEFAULT_TOLERANCE, REFERENCE,
                f"body tolerance {tolerance}", {"Time/Body tolerance": tolerance})
        for tolerance in BODY_TOLERANCES
    ]
    return grid + of_bodies + checks()
