#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the solver can be used by other projects.

Usage: check_solver_package.py CMAKE PROJECT_DIRECTORY BUILD_DIRECTORY

Installs the solver alone into a temporary directory, builds the programs of
contrib/examples against it, runs them on small meshes and compares the two
methods of each. Then installs the rest as well, and does the same with the
example that uses all of it, whose result is known.
Prints one line for each fault and returns 1 if there are any.
"""

import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

# Largest number of TNNMG iterations on each mesh, a few more than were found, and
# the largest difference of the solutions in the energy norm, relative. TNNMG
# stops at 1e-8.
EXAMPLES = {"obstacle": 7, "tresca": 9}
LARGEST_DIFFERENCE = 1e-7
REFINEMENTS = "4"

# Relative difference of the friction coefficient after forty characteristic
# slips from that at steady state, of which exp(-40) should be left.
LARGEST_ERROR_OF_FRICTION = 1e-3


def run(*command, folder=None):
    """The output of a command, which must succeed."""
    result = subprocess.run(
        [str(word) for word in command],
        cwd=folder,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
    )
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{result.stdout}")
    return result.stdout


def cache_entry(build, name):
    """The value of an entry of CMakeCache.txt."""
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    return re.search(rf"^{name}:\w+=(.*)$", cache, re.MULTILINE).group(1)


def missing_symbols(library):
    """Yield a sentence for each function of this project that the library uses
    and does not have."""
    undefined, defined = set(), set()
    for line in run("nm", "-C", library).splitlines():
        match = re.match(r"[0-9a-f ]* (\w) (.*StickSlip::.*)", line)
        if match:
            (undefined if match.group(1) == "U" else defined).add(match.group(2))
    if not defined:
        yield f"{library.name} has no functions of this project"
    for symbol in sorted(undefined - defined):
        yield f"{library.name} lacks {symbol}"


def references_to(directories, prefix):
    """Yield a sentence for each installed CMake file that names a directory."""
    for path in sorted(prefix.rglob("*.cmake")):
        text = path.read_text(encoding="utf-8")
        for directory in directories:
            if str(directory) in text:
                yield f"{path.relative_to(prefix)} refers to {directory}"


def read_table(text):
    """The rows of a table of an example, each as a dictionary."""
    rows = [
        [cell.strip() for cell in line.strip().strip("|").split("|")]
        for line in text.splitlines() if line.startswith("|")
    ]
    return [dict(zip(rows[0], map(float, row))) for row in rows[1:]]


def check_example(name, text):
    """Yield a sentence for each fault in the table of an example."""
    rows = read_table(text)
    if len(rows) != int(REFINEMENTS):
        yield f"{name} printed {len(rows)} lines:\n{text}"
    for row in rows:
        where = f"{name} with {row['unknowns']:.0f} unknowns"
        if not row["difference"] <= LARGEST_DIFFERENCE:
            yield f"{where}: the methods differ by {row['difference']:g}"
        if row["TNNMG"] > EXAMPLES[name]:
            yield f"{where} took {row['TNNMG']:.0f} iterations"
    # From the second mesh on, both begin at the result of the mesh before.
    if rows[-1]["TNNMG"] > rows[1]["TNNMG"] + 1:
        yield f"{name}: iterations grow with the mesh:\n{text}"


def check_friction(text):
    """Yield a sentence for each fault in the table of velocity_dependence."""
    rows = read_table(text)
    if len(rows) != 4:
        yield f"velocity_dependence printed {len(rows)} lines:\n{text}"
    for row in rows:
        error = row["friction"] / row["steady state"] - 1
        if not abs(error) <= LARGEST_ERROR_OF_FRICTION:
            yield f"at {row['velocity']} m/s friction is off by {error:g}"


def main():
    cmake = sys.argv[1]
    source, build = (pathlib.Path(name).resolve() for name in sys.argv[2:4])
    settings = [
        "-G", cache_entry(build, "CMAKE_GENERATOR"),
        f"-DCMAKE_BUILD_TYPE={cache_entry(build, 'CMAKE_BUILD_TYPE')}",
    ]
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        prefix = folder / "prefix"
        settings.append(f"-DCMAKE_PREFIX_PATH={prefix}")
        run(cmake, "--install", build, "--component", "solver", "--prefix", prefix)
        faults += missing_symbols(next(prefix.rglob("libstickslip_solver.a")))

        def table_of(name, *arguments):
            binary = folder / name
            run(cmake, "-S", source / "contrib" / "examples" / name, "-B", binary,
                *settings)
            run(cmake, "--build", binary)
            return run(binary / name, *arguments, folder=binary)

        def table_of_solver(name):
            return table_of(name, REFINEMENTS)

        with concurrent.futures.ThreadPoolExecutor() as pool:
            for name, table in zip(EXAMPLES, pool.map(table_of_solver, EXAMPLES)):
                faults += check_example(name, table)

        run(cmake, "--install", build, "--prefix", prefix)
        faults += references_to((source, build), prefix)
        faults += check_friction(table_of("velocity_dependence"))
    print("\n".join(faults) or "What is installed serves the examples.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
