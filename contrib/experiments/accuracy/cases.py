# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The runs of the study: what is varied, and what each is compared with."""

from .slider import LONG, Case

# Far below what is studied. The iterations have to be as exact as the steps.
FINEST = {
    "Time/Tolerance": "1.3e-10",
    "TNNMG/Tolerance": "1e-12",
    "Time/Rate-state tolerance": "4.5e-12",
}
# All corrections alike; it is the mesh and the steps that are studied with it.
TWO_CYCLES = {"TNNMG/Single-cycle corrections": "0"}
EULER = {"Time/State update": "implicit Euler"}
NESTED = {"Time/Rate-state method": "nested"}
DOUBLING = {"Time/Step size control": "step doubling"}
TOLERANCE, THRESHOLD = "Time/Tolerance", "Time/Doubling threshold"
ARCSINH = {"Faults/fault/Regularisation": "arcsinh"}
CONDENSED = {"Time/Rate solver": "condensed Newton"}
DEFAULT = "embedded, exponential, interleaved (default)"
PUBLISHED = "step doubling, implicit Euler, nested (published)"
DEFAULT_TOLERANCE = "1.3e-6"


def pairs(settings):
    """Settings in a form that cannot change."""
    return tuple(sorted(settings.items()))


def bodies(**entries):
    """Settings of the meshes of both bodies."""
    return {
        f"Bodies/{body}/{entry.replace('_', ' ')}": str(value)
        for body in ("lower", "upper")
        for entry, value in entries.items()
    }


REFERENCE = Case("time", "reference", "1.3e-10", pairs(FINEST), end_time=LONG)


def series(section, family, entry, values, settings=None, to=REFERENCE, **more):
    """A run for each value of an entry."""
    return [
        Case(
            section,
            family,
            value,
            pairs((settings or {}) | ({} if is_default(entry, value)
                                      else {entry: value})),
            reference=to,
            **more,
        )
        for value in values
    ]


def is_default(entry, value):
    """Whether it need not be set: the same run then serves several families."""
    return (entry, value) in (
        ("Time/Tolerance", "1.3e-6"),
        ("TNNMG/Tolerance", "1e-6"),
        ("Time/Rate-state tolerance", "4.5e-7"),
        ("Time/Doubling threshold", "4.5e-6"),
    )


# What is varied, at which values, and what it sets.
TIME_FAMILIES = (
    (DEFAULT, TOLERANCE,
     ("1.3e-4", "1.3e-5", "4.5e-6", "1.3e-6", "4.5e-7", "1.3e-7", "1.3e-8"), {}),
    ("embedded, implicit Euler, interleaved", TOLERANCE,
     ("1.3e-4", "1.3e-5", "4.5e-6", "1.3e-6", "1.3e-7"), EULER),
    ("embedded, exponential, nested", TOLERANCE,
     ("1.3e-4", "1.3e-5", "4.5e-6", "1.3e-6", "1.3e-7"), NESTED),
    ("step doubling, exponential, interleaved", THRESHOLD,
     ("4.5e-3", "1.3e-3", "4.5e-4", "1.3e-4", "4.5e-5"), DOUBLING),
    (PUBLISHED, THRESHOLD,
     ("4.5e-3", "1.3e-3", "4.5e-4", "1.3e-4", "4.5e-5", "4.5e-6"),
     DOUBLING | EULER | NESTED),
)


def time_cases():
    runs = [run for family in TIME_FAMILIES for run in series("time", *family)]
    # How far the reference itself can be trusted.
    check = series("time", "as the reference", TOLERANCE, ("1.3e-9",), FINEST)
    return [*runs, *check, REFERENCE]


def late_cases():
    """To 40 s, where each event carries the errors of all before it."""
    chosen = {
        DEFAULT: ("1.3e-4", "1.3e-5", "1.3e-6", "1.3e-7"),
        PUBLISHED: ("4.5e-4",),
    }
    return [
        run
        for family, entry, _, settings in TIME_FAMILIES
        for run in series(
            "late", family, entry, chosen.get(family, ()), settings, end_time=LONG
        )
    ]


def law_cases():
    """Against the truncated law in the limit and at the same tolerance: the former
    is the error if the models differ by less, which the latter shows."""
    tolerances = ("1.3e-4", "1.3e-5", "1.3e-6")
    beside = [
        Case("law", "arcsinh beside truncated", run.tolerance, run.settings,
             reference=other)
        for run, other in zip(
            series("law", "", TOLERANCE, tolerances, ARCSINH),
            series("law", "truncated", TOLERANCE, tolerances),
        )
    ]
    return series("law", "arcsinh", TOLERANCE, tolerances, ARCSINH) + beside


def algebra_cases():
    """At the default tolerance in time, beside nearly exact iterations."""
    exact = Case("algebra", "reference", "1e-12", pairs({"TNNMG/Tolerance": "1e-12"}))
    return [
        *series("algebra", "TNNMG tolerance", "TNNMG/Tolerance",
                ("1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10"), to=exact),
        *series("algebra", "rate-state tolerance", "Time/Rate-state tolerance",
                ("4.5e-4", "4.5e-5", "4.5e-7", "4.5e-9"), to=exact),
        *series("algebra", "condensed Newton", "TNNMG/Tolerance", ("1e-6", "1e-9"),
                CONDENSED, to=exact),
        exact,
    ]


def front_cases():
    """What else might cost less, with its whole error."""
    return [
        *series("front", "two cycles in all corrections", TOLERANCE,
                ("1.3e-4", "1.3e-5", "1.3e-6", "1.3e-7"),
                {"TNNMG/Single-cycle corrections": "0"}),
        *series("front", "one cycle in all corrections", TOLERANCE,
                ("1.3e-5", "1.3e-6", "1.3e-7"), {"TNNMG/Cycles per correction": "1"}),
        *series("front", "TNNMG tolerance 1e-9", TOLERANCE,
                ("1.3e-5", "1.3e-6", "1.3e-7"), {"TNNMG/Tolerance": "1e-9"}),
        *series("front", "condensed Newton", TOLERANCE,
                ("1.3e-4", "1.3e-5", "1.3e-6", "1.3e-7"), CONDENSED),
    ]


def independent_cases():
    """On the mesh of independent.py; its events are the reference."""
    coarse = ARCSINH | TWO_CYCLES | bodies(Refinement_passes=0)
    exact = {k: v for k, v in FINEST.items() if k != TOLERANCE}
    return [
        *series("independent", "embedded, exponential", TOLERANCE,
                ("1.3e-4", "1.3e-5", "1.3e-6", "1.3e-7", "1.3e-8"), coarse | exact,
                to=None, mesh="10 x 2 cells a body"),
        *series("independent", "step doubling, implicit Euler, nested", THRESHOLD,
                ("4.5e-3", "4.5e-4", "4.5e-5"),
                coarse | exact | DOUBLING | EULER | NESTED,
                to=None, mesh="10 x 2 cells a body"),
    ]


# Names and settings of meshes, from coarse to fine.
ALL_CELLS = [
    ("h = 1", {}),
    ("h = 1/2", bodies(Uniform_refinements=1)),
    ("h = 1/4", bodies(Uniform_refinements=2)),
    ("h = 1/8", bodies(Uniform_refinements=3)),
]
# The faces on the fault stay as they are.
BULK = [
    ("bulk 1", {}),
    ("bulk 1/2", bodies(Coarse_cells="20, 4", Refinement_passes=3)),
    ("bulk 1/4", bodies(Coarse_cells="40, 8", Refinement_passes=2)),
    ("bulk 1/8", bodies(Coarse_cells="80, 16", Refinement_passes=1)),
]
# All but the cells next to the fault stay as they are.
FAULT = [
    ("fault 4", bodies(Refinement_passes=2)),
    ("fault 2", bodies(Refinement_passes=3)),
    ("fault 1", {}),
    ("fault 1/2", bodies(Refinement_passes=5)),
    ("fault 1/4", bodies(Refinement_passes=6)),
]
# As fine away from the fault, with faces on the fault twice as long.
BALANCED = [
    ("20 x 4 cells, 2 passes", bodies(Coarse_cells="20, 4", Refinement_passes=2)),
    ("40 x 8 cells, 1 pass", bodies(Coarse_cells="40, 8", Refinement_passes=1)),
]


def mesh_series(family, meshes, to=None):
    """Runs on meshes, each compared with that on the last one if not with another."""
    solver = TWO_CYCLES | {"TNNMG/Tolerance": "1e-7"}
    *others, (finest, settings) = meshes
    last = Case("space", family, DEFAULT_TOLERANCE, pairs(settings | solver), finest, to)
    return [
        Case("space", family, DEFAULT_TOLERANCE, pairs(settings | solver), mesh,
             to or last)
        for mesh, settings in others
    ] + [last]


def space_cases():
    all_cells = mesh_series("all cells", ALL_CELLS)
    finest = all_cells[-1]
    return [
        *all_cells,
        *mesh_series("bulk", BULK, finest),
        *mesh_series("balanced", BALANCED, finest),
        *mesh_series("fault", FAULT),
    ]
