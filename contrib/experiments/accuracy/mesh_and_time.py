# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The runs over meshes and tolerances of the steps together."""

from .cases import DEFAULT_TOLERANCE, TOLERANCE, bodies, pairs
from .mesh_search import ENTRY
from .slider import ACCURATE, SCENE, Case

SECTION = "mesh and time"
PUBLISHED = "published"
TOLERANCES = ("1.3e-5", "4.5e-6", DEFAULT_TOLERANCE, "4.5e-7", "1.3e-7")


def accurate(value):
    return f"accuracy {value}", ACCURATE, {ENTRY: value}


def halved(n_times):
    """From 20 x 4 cells: the coarsest mesh is factorised, and had better be small."""
    return (f"{20 * 2**n_times} x {4 * 2**n_times} cells, 1 pass", SCENE,
            bodies(Coarse_cells="20, 4", Uniform_refinements=n_times,
                   Refinement_passes=1))


MESHES = (
    (PUBLISHED, SCENE, {}),
    halved(1),
    halved(2),
    *map(accurate,
         ("3e-2", "1.5e-2", "1e-2", "7.5e-3", "6e-3", "5e-3", "3e-3", "2e-3")),
)
# Nobody takes long steps on the finest meshes.
OF_FINE_MESHES = (DEFAULT_TOLERANCE, "4.5e-7", "1.3e-7")
FINE_MESHES = ("80 x 16 cells, 1 pass", "accuracy 3e-3", "accuracy 2e-3")
BODY_TOLERANCES = ("1e-5", "1e-4", "1e30")
CHECKS = "check of the reference"
STEPS = "error of the steps of the reference"


def case_of(mesh, tolerance, reference, family="", settings=None):
    name, scene, entries = mesh
    all_settings = entries | (settings or {})
    if tolerance != DEFAULT_TOLERANCE:
        all_settings = all_settings | {TOLERANCE: tolerance}
    return Case(SECTION, family, tolerance, pairs(all_settings), name, reference,
                scene=scene)


REFERENCE = case_of(accurate("5e-4"), "1.3e-8", None, CHECKS)


def checks():
    """Runs that tell how far the reference can be trusted: with half as many
    vertices, with longer steps, and on cells of one size."""
    return [
        case_of(accurate("1e-3"), "1.3e-8", REFERENCE, CHECKS),
        case_of(accurate("5e-4"), "1.3e-7", REFERENCE, CHECKS),
        *(case_of(halved(n), "1.3e-7", REFERENCE, CHECKS) for n in (2, 3)),
        REFERENCE,
    ]


def tolerances_of(mesh):
    return OF_FINE_MESHES if mesh[0] in FINE_MESHES else TOLERANCES


def all_cases():
    grid = [case_of(mesh, tolerance, REFERENCE)
            for mesh in MESHES for tolerance in tolerances_of(mesh)]
    of_bodies = [
        case_of(accurate("5e-3"), DEFAULT_TOLERANCE, REFERENCE,
                f"body tolerance {tolerance}", {"Time/Body tolerance": tolerance})
        for tolerance in BODY_TOLERANCES
    ]
    return grid + of_bodies + checks()
