# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""TNNMG against other solvers of the rate problem."""

from common import page, programs

from . import measuring
from .scenes import MESHES, STATES

SECTION = "newton"
# An iteration that ends farther away has not found the solution.
LARGEST_ERROR = 1e-6
CORRECTION = "TNNMG/Linear correction"

# Entries of the scene and options of the program for each solver.
SOLVERS = {
    "TNNMG": ({}, ()),
    "exact, UMFPACK": ({CORRECTION: "UMFPACK"}, ()),
    "exact, MUMPS": ({CORRECTION: "MUMPS"}, ()),
    "CG with ML": ({}, ("--amg",)),
    "Newton, UMFPACK": ({CORRECTION: "UMFPACK"}, ("--without-smoother",)),
    "condensed": ({"Time/Rate solver": "condensed Newton"}, ()),
}


def cases(quick):
    """Mesh, step size, states, solvers, and the longest time of a run of the
    program in s."""
    every, two, one = tuple(STATES), ("nucleating", "random"), ("nucleating",)
    # Where they are measured for some other state, and take long.
    less = [s for s in SOLVERS if s not in ("exact, MUMPS", "Newton, UMFPACK")]
    if quick:
        return [("uniform-1e5", "1e-3", one, SOLVERS, 8)]
    return [
        ("uniform-1e4", "1e-3", every, SOLVERS, 30),
        ("uniform-1e4", "1e-1", every, SOLVERS, 30),
        ("graded-1e4", "1e-3", every, SOLVERS, 30),
        ("uniform-1e5", "1e-3", every, less, 15),
        ("uniform-1e5", "1e-1", two, SOLVERS, 15),
        ("graded-1e5", "1e-3", one, SOLVERS, 30),
        (
            "uniform-1e6",
            "1e-3",
            one,
            ("TNNMG", "exact, UMFPACK", "exact, MUMPS", "CG with ML"),
            100,
        ),
    ]


def measure(quick, log):
    records = []
    for name, tau, states, solvers, timeout in cases(quick):
        mesh = MESHES[name]
        # One run for all states, where none can use up the time of another.
        groups = [states] if name.endswith("1e4") else [(s,) for s in states]
        for group in groups:
            for solver in solvers:
                records += measure_states(mesh, tau, group, solver, timeout)
        log(f"{name}, tau = {tau} s measured")
    return records, None


def measure_states(mesh, tau, states, solver, timeout):
    extra, options = SOLVERS[solver]
    repetitions = 3 if solver == "TNNMG" else 1
    try:
        rows = measuring.rate_rows(
            mesh,
            {state: STATES[state] for state in states},
            [tau],
            ["--repetitions", repetitions, *options],
            extra,
            timeout,
        )
        return [measuring.rate_record(SECTION, mesh, solver, row) for row in rows]
    except programs.Failed as reason:
        return [
            measuring.failed_record(SECTION, mesh, solver, state, tau, reason)
            for state in states
        ]


def cell(row, tnnmg):
    """Iterations, seconds, and the ratio to TNNMG in one cell."""
    if row is None:
        return ""
    if not row["solve_s"]:
        return row["note"].split(":")[0]
    count = row["iterations"]
    if row["note"]:
        size = page.number(row["error"], 1)
        return f"{count} without convergence, error {size}"
    text = f"{count}: {page.number(row['solve_s'])} s"
    if tnnmg and tnnmg["solve_s"] and row is not tnnmg:
        text += f" ({page.number(float(row['solve_s']) / float(tnnmg['solve_s']))})"
    if float(row["error"]) > LARGEST_ERROR:
        text += f", error {page.number(row['error'], 1)}"
    return text


def text(records, _):
    lines = [
        "Iterations, time, and in brackets the ratio of the time to that of TNNMG:\n"
    ]
    for name, tau in dict.fromkeys((r["problem"], r["tau"]) for r in records):
        rows = {
            (row["state"], row["solver"]): row
            for row in records
            if (row["problem"], row["tau"]) == (name, tau)
        }
        lines += problem_table(MESHES[name], tau, rows)
    return "\n".join(lines)


def problem_table(mesh, tau, rows):
    unknowns = max(float(row["unknowns"] or 0) for row in rows.values())
    solvers = [s for s in SOLVERS if any(key[1] == s for key in rows)]
    yield (
        f"### {mesh.description.capitalize()}, {unknowns:,.0f} unknowns, "
        f"tau = {page.number(tau)} s\n"
    )
    yield page.table(
        ("state", *solvers),
        [
            (
                state,
                *(
                    cell(rows.get((state, s)), rows.get((state, "TNNMG")))
                    for s in solvers
                ),
            )
            for state in dict.fromkeys(key[0] for key in rows)
        ],
    )
