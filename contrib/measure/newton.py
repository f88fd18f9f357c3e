# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""TNNMG against other solvers of the rate problem."""

from . import page, programs
from .scenes import MESHES, STATES

SECTION = "newton"
TAU = "1e-3"
CORRECTION = "TNNMG/Linear correction"
LIMIT = "TNNMG/Largest number of iterations"

# Entries of the scene and options of the program for each solver.
SOLVERS = {
    "TNNMG": ({}, ()),
    "exact, UMFPACK": ({CORRECTION: "UMFPACK"}, ()),
    "exact, MUMPS": ({CORRECTION: "MUMPS"}, ()),
    "CG with ML": ({CORRECTION: "AMG"}, ()),
    "Newton, UMFPACK": ({CORRECTION: "UMFPACK"}, ("--without-smoother",)),
    "condensed": ({"Time/Rate solver": "condensed Newton"}, ()),
    "Gauss-Seidel": ({LIMIT: 200}, ("--gauss-seidel",)),
}
DIRECT = ("exact, UMFPACK", "exact, MUMPS", "Newton, UMFPACK")


def cases(quick):
    """Mesh, states, solvers, and the longest time of a measurement in s."""
    every, two = tuple(STATES), ("nucleating", "random")
    all_solvers = tuple(SOLVERS)
    without_mumps = tuple(s for s in SOLVERS if s != "exact, MUMPS")
    if quick:
        return [("uniform-1e5", ("nucleating",), all_solvers, 8)]
    return [
        ("uniform-1e4", every, all_solvers, 10),
        ("graded-1e4", every, all_solvers, 10),
        ("uniform-1e5", every, without_mumps, 12),
        ("graded-1e5", two, all_solvers, 20),
        ("uniform-1e6", ("nucleating",), ("TNNMG", "exact, UMFPACK", "CG with ML"), 90),
    ]


def measure(quick, log):
    records = []
    for name, states, solvers, timeout in cases(quick):
        mesh = MESHES[name]
        for state in states:
            for solver in solvers:
                records.append(measure_one(mesh, state, solver, timeout))
        log(f"{name} measured")
    return records, None


def measure_one(mesh, state, solver, timeout):
    extra, options = SOLVERS[solver]
    repetitions = 3 if solver == "TNNMG" else 1
    try:
        (row,) = programs.rate_rows(
            mesh,
            {state: STATES[state]},
            [TAU],
            ["--repetitions", repetitions, *options],
            extra,
            timeout,
        )
        return programs.rate_record(SECTION, mesh, solver, row)
    except programs.Failed as reason:
        return programs.failed_record(SECTION, mesh, solver, state, TAU, reason)


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
    return text


def text(records, _):
    lines = [
        f"Step size {TAU} s. Iterations, time, and in brackets the ratio of the "
        "time to that of TNNMG:\n"
    ]
    for name in dict.fromkeys(record["problem"] for record in records):
        rows = {
            (row["state"], row["solver"]): row
            for row in records
            if row["problem"] == name
        }
        mesh = MESHES[name]
        unknowns = max(float(row["unknowns"] or 0) for row in rows.values())
        solvers = [s for s in SOLVERS if any(key[1] == s for key in rows)]
        lines.append(
            f"### {mesh.description.capitalize()}, {unknowns:,.0f} unknowns\n"
        )
        lines.append(
            page.table(
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
        )
    return "\n".join(lines)
