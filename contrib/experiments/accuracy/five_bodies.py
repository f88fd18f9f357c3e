# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The runs of the five bodies over meshes and tolerances."""

from .cases import DEFAULT_TOLERANCE, TOLERANCE, pairs
from .mesh_and_time import CHECKS, PUBLISHED, STEPS
from .mesh_search import ENTRY
from .slider import ACCURATE_FIVE_BODIES, FIVE_BODIES, LONG, Case

SECTION = "five bodies"


def accurate(value):
    return f"accuracy {value}", ACCURATE_FIVE_BODIES, {ENTRY: value}


def case_of(mesh, tolerance, reference, family=""):
    """To 40.5 s, after four events of the uppermost fault."""
    name, scene, entries = mesh
    if tolerance != DEFAULT_TOLERANCE:
        entries = entries | {TOLERANCE: tolerance}
    return Case(SECTION, family, tolerance, pairs(entries), name, reference,
                end_time=LONG, scene=scene)


REFERENCE = case_of(accurate("8e-4"), "4.5e-7", None, CHECKS)
# With the tolerances of each.
MESHES = (
    ((PUBLISHED, FIVE_BODIES, {}), (DEFAULT_TOLERANCE,)),
    (accurate("1.5e-2"), ("4.5e-6", DEFAULT_TOLERANCE)),
    (accurate("7.5e-3"), ("4.5e-6", DEFAULT_TOLERANCE, "4.5e-7")),
    (accurate("5e-3"), ("4.5e-6", DEFAULT_TOLERANCE, "4.5e-7")),
    (accurate("3e-3"), (DEFAULT_TOLERANCE,)),
)


def all_cases():
    grid = [case_of(mesh, tolerance, REFERENCE)
            for mesh, tolerances in MESHES for tolerance in tolerances]
    checks = [
        case_of(accurate("1.5e-3"), "4.5e-7", REFERENCE, CHECKS),
        case_of(accurate("7.5e-3"), "1.3e-7",
                case_of(accurate("7.5e-3"), "4.5e-7", None), STEPS),
        REFERENCE,
    ]
    return grid + checks
