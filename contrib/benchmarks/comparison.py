# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""TNNMG against the multigrid methods of libraries at the linear limit."""

from common import page, programs

from . import measuring
from .scenes import MESHES, STATES

SECTION = "linear"
LIBRARIES = {
    "geometric": "deal.II's multigrid",
    "algebraic": "ML",
    "coupled": "our cycle",
    "tnnmg": "TNNMG, welded",
    "umfpack": "UMFPACK, with factorisation",
    "umfpack-solve": "UMFPACK, without",
    "mumps": "MUMPS, with factorisation",
    "mumps-solve": "MUMPS, without",
}
ITERATIVE = ("geometric", "coupled", "tnnmg", "algebraic")


def cases(quick):
    """Meshes, step sizes, states at each, and repetitions of a solve."""
    every = tuple(STATES)
    four = ("1e-5", "1e-3", "1e-1", "1")
    result = [
        ("uniform-1e4", dict.fromkeys(("1e-3", "1e-1"), ("nucleating",)), 3),
        ("uniform-1e5", dict.fromkeys(("1e-3",) if quick else four, every), 3),
        ("graded-1e5", dict.fromkeys(("1e-3",) if quick else four, every), 3),
    ]
    if not quick:
        result += [
            ("blocks-1e5", {"1e-3": every}, 2),
            ("uniform-1e6", {"1e-3": every, "1e-1": ("nucleating", "slipping")}, 2),
            ("graded-1e6", {"1e-3": every}, 2),
        ]
    return result


def measure(quick, log):
    """The libraries before and after the rate problems, so that what else the
    machine does meets both."""
    records = {}
    for name, taus, repetitions in cases(quick):
        mesh = MESHES[name]

        def libraries(solvers, *options):
            for tau in taus:
                try:
                    rows = measuring.linear_rows(
                        mesh, tau, solvers, repetitions, options
                    )
                except programs.Failed as reason:
                    for solver in solvers:
                        record = measuring.failed_record(
                            SECTION, mesh, solver, "welded", tau, reason
                        )
                        records.setdefault(measuring.key(record), record)
                    continue
                for row in rows:
                    record = measuring.linear_record(SECTION, mesh, row)
                    measuring.keep_shortest(records, record)

        libraries(ITERATIVE)
        for tau, states in taus.items():
            try:
                rows = measuring.rate_rows(
                    mesh,
                    {state: STATES[state] for state in states},
                    [tau],
                    ["--repetitions", repetitions],
                )
            except programs.Failed as reason:
                for state in states:
                    record = measuring.failed_record(
                        SECTION, mesh, "TNNMG", state, tau, reason
                    )
                    records[measuring.key(record)] = record
                continue
            for row in rows:
                record = measuring.rate_record(SECTION, mesh, "TNNMG", row)
                measuring.keep_shortest(records, record)
        libraries(("geometric", "coupled"), "--times-only")
        if not quick and "1e-3" in taus:
            libraries_once(mesh, records)
        log(f"{name} measured")
    return list(records.values()), None


def libraries_once(mesh, records):
    """The factorisations, for one step size: it changes nothing for them."""
    for solver in ("umfpack", "mumps"):
        try:
            (row,) = measuring.linear_rows(mesh, "1e-3", [solver], 1, timeout=60)
            alone = measuring.linear_record(SECTION, mesh, row)
            alone["solver"] = f"{solver}-solve"
            record = dict(alone, solver=solver)
            factorisation = float(row["preconditioner_s"])
            record["setup_s"] -= factorisation
            record["solve_s"] = float(row["solve_s"]) + factorisation
            records[measuring.key(alone)] = alone
        except programs.Failed as reason:
            record = measuring.failed_record(
                SECTION, mesh, solver, "welded", "1e-3", reason
            )
        records[measuring.key(record)] = record


def text(records, _):
    lines = []
    meshes = list(dict.fromkeys(record["problem"] for record in records))
    for name in meshes:
        rows = [record for record in records if record["problem"] == name]
        lines += mesh_tables(MESHES[name], rows)
    return "\n".join(lines)


def mesh_tables(mesh, rows):
    unknowns = max(float(row["unknowns"] or 0) for row in rows)
    yield f"### {mesh.description.capitalize()}, {unknowns:,.0f} unknowns\n"
    yield "At the linear limit:\n"
    yield page.table(
        (
            "tau, s",
            "solver",
            "iterations",
            "set-up, s",
            "solve, s",
            "µs an unknown",
            "bytes an unknown",
            "error",
        ),
        [
            (
                page.number(row["tau"]),
                LIBRARIES[row["solver"]],
                row["iterations"] or row["note"].split(":")[0],
                page.number(row["setup_s"]),
                page.number(row["solve_s"]),
                page.number(
                    float(row["solve_s"]) / float(row["unknowns"]) * 1e6
                    if row["solve_s"]
                    else ""
                ),
                page.number(row["bytes_per_unknown"], 4),
                page.number(row["error"], 1),
            )
            for row in rows
            if row["state"] == "welded"
        ],
    )
    yield "Rate problems by TNNMG, and their time over that of the linear limit:\n"
    linear = {
        (row["solver"], float(row["tau"])): row
        for row in rows
        if row["state"] == "welded"
    }

    def ratio(row, solver):
        other = linear.get((solver, float(row["tau"])))
        if not other or not other["solve_s"] or not row["solve_s"]:
            return "–"
        return f"{float(row['solve_s']) / float(other['solve_s']):.2f}"

    yield page.table(
        (
            "tau, s",
            "state",
            "iterations",
            "cycles",
            "solve, s",
            "bytes an unknown",
            "error",
            "over deal.II's multigrid",
            "over ML",
            "over our cycle",
        ),
        [
            (
                page.number(row["tau"]),
                row["state"],
                row["iterations"] or row["note"].split(":")[0],
                row["cycles"],
                page.number(row["solve_s"]),
                page.number(row["bytes_per_unknown"], 4),
                page.number(row["error"], 1),
                ratio(row, "geometric"),
                ratio(row, "algebraic"),
                ratio(row, "coupled"),
            )
            for row in rows
            if row["state"] != "welded"
        ],
    )
