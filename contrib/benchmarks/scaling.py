#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Measure one rate problem on several numbers of processes.

Usage: contrib/scaling [--quick | --large | --weak]

Writes
doc/data/scaling.csv and the tables between the marks in doc/parallel.md; with
--quick the small problems are measured and shown, and nothing is written. Takes some
minutes and 3 GiB of memory, with --quick one minute. The machine should have
nothing else to do.

--large measures problems in three dimensions of up to 1e7 unknowns on two processes,
in ten minutes and 22 GiB of memory, and writes doc/data/large.csv and their table.

--weak measures problems that grow with the number of processes, 1 to 16, in five
minutes and 15 GiB of memory, and writes doc/data/weak_scaling.csv, their table, and
that of a model of many processes, which takes its times from doc/data/large.csv.
"""

import csv
import dataclasses
import subprocess
import sys

from benchmarks import weak_scaling
from common import csv_file, page, programs

PAGE = programs.PROJECT / "doc/parallel.md"
DATA = programs.PROJECT / "doc/data/scaling.csv"
LARGE_DATA = programs.PROJECT / "doc/data/large.csv"
WEAK_DATA = programs.PROJECT / "doc/data/weak_scaling.csv"


@dataclasses.dataclass
class Problem:
    """A rate problem of the spring slider on some mesh."""

    name: str
    description: str
    overrides: dict
    processes: tuple
    is_small: bool = True
    scene: str = "parameters/spring_slider.prm"


def bodies(**entries):
    return {
        f"Bodies/{body}/{entry.replace('_', ' ')}": value
        for body in ("lower", "upper")
        for entry, value in entries.items()
    }


# Half of the fault strength as shear traction; a patch in the middle is as weak
# as while it nucleates, the rest is stuck.
NUCLEATING = {
    "Output/Event start slip rate": "1e-4",
    "Boundary conditions/upper top/x condition": "traction",
    "Boundary conditions/upper top/x value": "28e3",
    "Boundary conditions/upper top/Ramp length": "0",
    "Faults/fault/Initial state": "if(abs(x) < 0.8, 1e-5, 1e6)",
    "Time/Initial step": "1e-3",
}
PROBLEMS = [
    Problem(
        "uniform-1e5",
        "Cells of one size",
        bodies(
            Coarse_cells="12, 2", Refinement_passes="0", Uniform_refinements="5"
        ),
        (1, 2, 4, 8, 16),
    ),
    Problem(
        "graded-1e5",
        "Cells that grow with the distance from the fault",
        bodies(Coarse_cells="12, 2", Refinement_passes="9"),
        (1, 2, 4, 8, 16),
    ),
    Problem(
        "blocks-1e5",
        "Three dimensions, cells of one size",
        bodies(Refinement_passes="0", Uniform_refinements="2"),
        (1, 2, 4, 8),
        scene="contrib/benchmarks/scaling_blocks.prm",
    ),
    Problem(
        "uniform-1e6",
        "Cells of one size",
        bodies(
            Coarse_cells="35, 7", Refinement_passes="0", Uniform_refinements="5"
        ),
        (1, 2),
        is_small=False,
    ),
]


def inviscid_blocks(coarse_cells, refinements):
    return Problem(
        f"blocks-{coarse_cells}-{refinements}",
        "",
        bodies(
            Coarse_cells=coarse_cells,
            Refinement_passes="0",
            Uniform_refinements=str(refinements),
        )
        | {
            f"Bodies/{body}/Material/{kind} viscosity": "0"
            for body in ("lower", "upper")
            for kind in ("Shear", "Bulk")
        },
        (2,),
        scene="contrib/benchmarks/scaling_blocks.prm",
    )


LARGE = [
    inviscid_blocks("10, 10, 2", 2),
    inviscid_blocks("10, 10, 2", 3),
    inviscid_blocks("10, 10, 2", 4),
    inviscid_blocks("14, 14, 2", 4),
]


def measure(problem, n_processes, *options):
    command = ["mpirun", "-np", str(n_processes)]
    command += [str(programs.PROJECT / "build/rate_problem"), problem.scene]
    command += [*programs.options(NUCLEATING | problem.overrides), *options]
    output = subprocess.run(
        command, cwd=programs.PROJECT, check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    (row,) = csv.DictReader(output.splitlines())
    if row["converged"] != "1":
        sys.exit(f"{problem.name} on {n_processes}: no convergence")
    return {"problem": problem.name} | row


COLUMNS = [
    ("processes", "processes", "{:.0f}"),
    ("tnnmg_iterations", "TNNMG iterations", "{:.0f}"),
    ("cycles", "cycles", "{:.0f}"),
    ("equilibrium_iterations", "CG at the start", "{:.0f}"),
    ("meshes_s", "meshes, s", "{:.2f}"),
    ("matrices_and_contact_s", "matrices, contact, levels, s", "{:.2f}"),
    ("contact_s", "new contact mapping, s", "{:.2f}"),
    ("operator_s", "new step size, s", "{:.4f}"),
    ("solve_s", "rate problem, s", "{:.3f}"),
    ("speed-up", "speed-up", "{:.2f}"),
    ("largest_MiB", "memory of a process, MiB", "{:.0f}"),
    ("memory", "over that of one", "{:.2f}"),
]


def table(problem, rows):
    """The rows of one problem, in Markdown."""
    first = rows[0]
    yield f"{problem.description}, {int(first['unknowns']):,} unknowns, "
    yield f"{first['levels']} levels, {int(first['fault_nodes']):,} fault nodes:\n"
    cells = []
    for row in rows:
        values = {key: row[key] for key in row if key != "problem"}
        values["speed-up"] = float(first["solve_s"]) / float(row["solve_s"])
        values["memory"] = float(row["largest_MiB"]) / float(first["largest_MiB"])
        cells.append(values)
    yield "\n" + page.table_of(COLUMNS, cells)


LARGE_COLUMNS = [
    ("unknowns", "unknowns", "{:,.0f}"),
    ("levels", "levels", "{:.0f}"),
    ("fault_nodes", "fault nodes", "{:,.0f}"),
    ("tnnmg_iterations", "TNNMG iterations", "{:.0f}"),
    ("equilibrium_iterations", "CG at the start", "{:.0f}"),
    ("meshes_s", "meshes, s", "{:.1f}"),
    ("matrices_and_contact_s", "matrices, contact, s", "{:.1f}"),
    ("equilibrium_s", "start, s", "{:.1f}"),
    ("solve_s", "rate problem, s", "{:.2f}"),
    ("bytes_per_unknown", "bytes an unknown", "{:,.0f}"),
    ("meshes_MiB", "MiB of a process, meshes made", "{:,.0f}"),
    ("largest_MiB", "at most", "{:,.0f}"),
]


def measure_large():
    rows = []
    for problem in LARGE:
        rows.append(measure(problem, 2, "--repetitions", "1"))
        print(f"{rows[-1]['unknowns']} unknowns: {rows[-1]['solve_s']} s", flush=True)
    csv_file.write(LARGE_DATA, rows[0].keys(), rows)
    write_large_table(rows)


def write_large_table(rows):
    text = page.table_of(LARGE_COLUMNS, rows)
    page.replace_section("large problems", text, PAGE, "contrib/scaling --large")
    print(f"{PAGE} and {LARGE_DATA} are written.")


def measure_weak():
    rows = []
    for coarse_cells, refinements, n_processes in weak_scaling.SEQUENCE:
        problem = inviscid_blocks(coarse_cells, refinements)
        rows.append(measure(problem, n_processes, "--repetitions", "1"))
        print(f"{n_processes} processes: {rows[-1]['largest_MiB']} MiB", flush=True)
    csv_file.write(WEAK_DATA, rows[0].keys(), rows)
    write_weak_tables(rows)


def write_weak_tables(rows):
    large = csv_file.read(LARGE_DATA)
    page.replace_section(
        "growing problems", weak_scaling.table(rows), PAGE, "contrib/scaling --weak"
    )
    # Two with the same coarse cells.
    text = weak_scaling.prediction(rows, large[1:3])
    page.replace_section("many processes", text, PAGE, "contrib/scaling --weak")
    print(f"{PAGE} and {WEAK_DATA} are written.")


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--large", action="store_true")
    parser.add_argument("--weak", action="store_true")
    arguments = parser.parse_args()
    if arguments.large:
        measure_large()
        return 0
    if arguments.weak:
        measure_weak()
        return 0

    measured, text = [], [f"\nMeasured on: {programs.machine()}.\n"]
    for problem in PROBLEMS:
        if arguments.quick and not problem.is_small:
            continue
        rows = []
        for n_processes in problem.processes:
            rows.append(measure(problem, n_processes))
            print(
                f"{problem.name} on {n_processes}: "
                f"{rows[-1]['tnnmg_iterations']} iterations, "
                f"{rows[-1]['solve_s']} s",
                flush=True,
            )
        measured += rows
        text += ["\n", *table(problem, rows)]

    if arguments.quick:
        print("".join(text))
        return 0
    csv_file.write(DATA, measured[0].keys(), measured)
    page.replace_section("tables", "".join(text), PAGE, "contrib/scaling")
    print(f"{PAGE} and {DATA} are written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
