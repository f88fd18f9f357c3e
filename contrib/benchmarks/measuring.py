# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Rows that the measuring programs print, and the table of all of them."""

import csv
import subprocess

from common import csv_file, page, programs
from common.programs import PROJECT, Failed

COLUMNS = (
    "problem state dim bodies unknowns tau solver iterations cycles "
    "setup_s solve_s bytes_per_unknown error section note"
).split()
DATA = PROJECT / "doc/data/performance.csv"


def run(program, arguments, timeout):
    """The rows that a program prints, as dictionaries."""
    command = [str(PROJECT / "build" / program), *map(str, arguments)]
    try:
        result = subprocess.run(
            command,
            cwd=PROJECT,
            timeout=timeout,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
    except subprocess.TimeoutExpired:
        raise Failed(f"more than {timeout:.0f} s") from None
    if result.returncode != 0:
        lines = [line.strip() for line in result.stderr.splitlines() if line.strip()]
        begin = f"{program}: "
        reason = next((line for line in lines if line.startswith(begin)), "")
        reason = reason.removeprefix(begin) or f"exit status {result.returncode}"
        raise Failed(f"failed: {reason}")
    return list(csv.DictReader(result.stdout.splitlines()))


def scene_arguments(mesh, extra=None):
    return [mesh.scene, *programs.options(mesh.settings() | (extra or {}))]


def rate_rows(mesh, states, taus, options=(), extra=None, timeout=300):
    """The measured rate problems, one for each state and step size."""
    arguments = scene_arguments(mesh, extra) + ["--taus", ",".join(taus), *options]
    for name, expression in states.items():
        arguments += ["--state", f"{name}:{expression}"]
    return run("rate_problem", arguments, timeout)


def linear_rows(mesh, tau, solvers, repetitions=3, options=(), timeout=300):
    extra = {"Time/Initial step": tau}
    options = [
        *("--solvers", ",".join(solvers), "--repetitions", repetitions), *options
    ]
    return run("linear_problem", scene_arguments(mesh, extra) + options, timeout)


def make_record(section, mesh, state, tau, solver, **results):
    """A row of the table of all results; columns not named stay empty."""
    return {
        **dict.fromkeys(COLUMNS, ""),
        "section": section,
        "problem": mesh.name,
        "state": state,
        "dim": mesh.dim,
        "bodies": mesh.bodies,
        "tau": tau,
        "solver": solver,
        **results,
    }


def rate_record(section, mesh, solver, row):
    """A row of rate_problem in the columns of the table of all results."""
    return make_record(
        section,
        mesh,
        row["state"],
        row["tau"],
        solver,
        unknowns=row["unknowns"],
        iterations=row["tnnmg_iterations"],
        cycles=row["cycles"],
        setup_s=sum(
            float(row[part])
            for part in ("meshes_s", "matrices_and_contact_s", "operator_s")
        ),
        solve_s=row["solve_s"],
        bytes_per_unknown=row["bytes_per_unknown"],
        error=row["error"],
        note="" if row["converged"] == "1" else "not converged",
    )


def linear_record(section, mesh, row):
    """A row of linear_problem in those columns."""
    return make_record(
        section,
        mesh,
        "welded",
        row["tau"],
        row["solver"],
        unknowns=row["unknowns"],
        iterations=row["iterations"],
        cycles=row["cycles"],
        setup_s=sum(
            float(row[part])
            for part in ("meshes_s", "assembly_s", "preconditioner_s")
        ),
        solve_s=row["solve_s"],
        bytes_per_unknown=row["bytes_per_unknown"],
        error=row.get("error", ""),
    )


def failed_record(section, mesh, solver, state, tau, reason):
    """The row of a measurement that failed."""
    return make_record(
        section, mesh, state, f"{float(tau):g}", solver, note=str(reason)
    )


def key(record):
    """What is measured, whatever came out."""
    names = ("section", "problem", "state", "tau", "solver")
    return tuple(
        float(record[n]) if n == "tau" else record[n] for n in names
    )


def keep_shortest(records, record):
    """Of repeated measurements the shortest times stay."""
    other = records.setdefault(key(record), record)
    if not other["solve_s"]:
        records[key(record)] = record
        return
    for part in ("setup_s", "solve_s"):
        other[part] = min(float(other[part]), float(record[part]))


def read():
    return csv_file.read(DATA)


def write(records):
    rows = [{c: page.rounded(r.get(c, "")) for c in COLUMNS} for r in records]
    csv_file.write(DATA, COLUMNS, rows)
