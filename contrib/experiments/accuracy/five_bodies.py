# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The runs of the five bodies over meshes and tolerances."""

from .cases import DEFAULT_TOLERANCE, TOLERANCE, pairs
from .mesh_and_time import CHECKS, PUBLISHED, STEPS
from .mesh_search import ENTRY
from .slider import FIVE_BODIES, LONG, Case

SECTION = "five bodies"


BODIES = ("bottom", "lower", "core", "upper", "top")


def accurate(value):
    passes = {f"Bodies/{body}/Refinement passes": "0" for body in BODIES}
    return f"accuracy {value}", {ENTRY: value} | passes


def bounded(outer, inner, value):
    """An accuracy, from cells of one size on, halved so many times in the bodies of 1 m
    and in those of 0.3 m. The mesh that a search ends with has all cells of another
    one halved."""
    name, entries = accurate(value)
    times = {"bottom": outer, "top": outer, "lower": inner, "upper": inner}
    return (
        f"at least {20 * 2**outer} x {4 * 2**outer} cells in the outer bodies, {name}",
        entries | {f"Bodies/{body}/Uniform refinements": str(n)
                   for body, n in times.items()})


def case_of(mesh, tolerance, reference, family=""):
    """To 40.5 s, after four events of the uppermost fault."""
    name, entries = mesh
    if tolerance != DEFAULT_TOLERANCE:
        entries = entries | {TOLERANCE: tolerance}
    return Case(SECTION, family, tolerance, pairs(entries), name, reference,
                end_time=LONG, scene=FIVE_BODIES)


REFERENCE = case_of(bounded(2, 1, "7e-4"), DEFAULT_TOLERANCE, None, CHECKS)
MESHES = (
    (PUBLISHED, {}),
    *map(accurate, ("1.5e-2", "7.5e-3", "5e-3", "3e-3")),
    bounded(1, 0, "5e-3"),
    bounded(2, 1, "3e-3"),
)


def all_cases():
    """At one tolerance, whose error drops out, and on one mesh with another."""
    grid = [case_of(mesh, DEFAULT_TOLERANCE, REFERENCE) for mesh in MESHES]
    other = case_of(MESHES[2], DEFAULT_TOLERANCE, None)
    checks = [
        *(case_of(mesh, DEFAULT_TOLERANCE, REFERENCE, CHECKS)
          for mesh in (bounded(2, 1, "1.5e-3"), bounded(3, 1, "7e-4"))),
        case_of(MESHES[2], "4.5e-7", other, STEPS),
        REFERENCE,
    ]
    return grid + checks
