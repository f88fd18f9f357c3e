#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Count the iterations of contact with bounds, from right and wrong starts.

Usage: contrib/contact_iterations [--tables]

Runs the tests LongOpening of build/tests/long_tests (minutes), which solve rate
problems whose faults open at about half of their nodes, and the same ones with sides
that stay together. Writes doc/data/contact_iterations.csv and the tables between the
marks in doc/solver.md. With --tables nothing is run; the tables are written anew.
"""

import re
import subprocess

from common import csv_file, page, programs

PAGE = programs.PROJECT / "doc/solver.md"
DATA = programs.PROJECT / "doc/data/contact_iterations.csv"
PROGRAM = programs.PROJECT / "build/tests/long_tests"
TESTS = {
    "IterationsAreLevelOverFiveRefinements": "refinements",
    "IterationsAreLevelOverOneToEightFaults": "faults",
    "IterationsAreLevelInThreeDimensions": "refinements, three dimensions",
}
STARTS = ("zero", "all open", "random", "1e6 times too fast", "1 % off")
COLUMNS = ("table", "mesh", "tau", "open", "nodes", *STARTS,
           *(f"{start}, bilateral" for start in STARTS))
LINE = re.compile(r"(.*), tau = (\S+), (\d+) of (\d+) nodes open:((?: \d+ \(\d+\))+)$")


def measure():
    """A row for each line that the tests print; their order tells the meshes."""
    rows = []
    for test, table in TESTS.items():
        process = subprocess.run(
            [PROGRAM, f"--gtest_filter=LongOpening.{test}"],
            capture_output=True, text=True,
        )
        if process.returncode != 0:
            raise SystemExit(f"LongOpening.{test} fails:\n{process.stdout}")
        seen = {}
        for line in process.stdout.splitlines():
            match = LINE.match(line)
            if not match:
                continue
            mesh, tau, n_open, n_nodes, counts = match.groups()
            # Numbers of faults come twice: meshes that match, and others.
            if table == "faults":
                key = (mesh, tau)
                seen[key] = seen.get(key, 0) + 1
                mesh += ", matching" if seen[key] == 1 else ", not matching"
            pairs = re.findall(r"(\d+) \((\d+)\)", counts)
            rows.append(
                {"table": table, "mesh": mesh, "tau": tau, "open": n_open,
                 "nodes": n_nodes}
                | {start: pair[0] for start, pair in zip(STARTS, pairs, strict=True)}
                | {f"{start}, bilateral": pair[1]
                   for start, pair in zip(STARTS, pairs, strict=True)}
            )
    return rows


def tables(rows):
    """One for each test: a row for a mesh, in a cell one number for each step size."""
    for name in TESTS.values():
        own = [row for row in rows if row["table"] == name]
        taus = list(dict.fromkeys(row["tau"] for row in own))
        lines = []
        for mesh in sorted(dict.fromkeys(row["mesh"] for row in own), key=order):
            of_mesh = [row for row in own if row["mesh"] == mesh]
            lines.append(
                [mesh, of_mesh[0]["nodes"],
                 ", ".join(row["open"] for row in of_mesh)]
                + [
                    ", ".join(row[start] for row in of_mesh)
                    + ("" if start == "all open" else
                       " (" + ", ".join(row[f"{start}, bilateral"]
                                        for row in of_mesh) + ")")
                    for start in STARTS
                ]
            )
        steps = " / ".join(taus)
        yield f"Over {name}, steps of {steps} s:\n"
        yield page.table(["mesh", "nodes", "open", *STARTS], lines)


def order(mesh):
    """Meshes of one kind stand together, coarse ones and few faults first."""
    return re.sub(r"\d+$", "", mesh) if "faults" not in mesh else mesh.split(",")[1]


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--tables", action="store_true")
    if not parser.parse_args().tables:
        csv_file.write(DATA, COLUMNS, measure())
    page.replace_section("contact", "\n".join(tables(csv_file.read(DATA))), PAGE,
                         "contrib/contact_iterations")


if __name__ == "__main__":
    main()
