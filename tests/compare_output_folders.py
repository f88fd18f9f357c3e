#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the output folders of two runs say the same.

Usage: compare_output_folders.py FOLDER FOLDER

The runs are those of the same scene on different numbers of processes. They
must have the same files, columns, nodes in the same order and steps; values may
differ as solvers stopped at a tolerance do. Prints one line for each difference
and returns 1 if there are any.
"""

import csv
import pathlib
import sys
import xml.etree.ElementTree

import h5py
import numpy

# Of the largest value of a column or field.
PRECISION = 1e-5


def differ(a, b):
    a, b = numpy.asarray(a, float), numpy.asarray(b, float)
    if a.shape != b.shape:
        return True
    if not numpy.array_equal(numpy.isnan(a), numpy.isnan(b)):
        return True
    largest = numpy.nanmax(numpy.abs(a), initial=0.0)
    return bool((numpy.abs(a - b) > PRECISION * largest).any())


def compare_tables(first, second):
    tables = []
    for path in (first, second):
        with open(path, newline="") as file:
            tables.append(list(csv.reader(file)))
    (header, *a), (other_header, *b) = tables
    if header != other_header or len(a) != len(b):
        yield f"{first.name} has other columns or rows"
        return
    for i, column in enumerate(header):
        # Iterations may differ by the way the processes share the work, and errors
        # of steps are small differences of what iterations leave an error in.
        if column.endswith(("iterations", "cycles", "_error")):
            continue
        values = [[row[i] for row in table] for table in (a, b)]
        if column == "fault":
            if values[0] != values[1]:
                yield f"{first.name}: other faults"
        elif differ(*values):
            yield f"{first.name}: {column} differs"


def compare_histories(first, second):
    with h5py.File(first) as a, h5py.File(second) as b:
        if sorted(a) != sorted(b) or dict(a.attrs) != dict(b.attrs):
            yield f"{first.name} has other groups or attributes"
            return
        for group in a:
            if sorted(a[group]) != sorted(b[group]):
                yield f"{first.name}: {group} has other data sets"
                continue
            for name in a[group]:
                x, y = a[group][name], b[group][name]
                if name == "coordinates":
                    if not numpy.array_equal(x[...], y[...]):
                        yield f"{first.name}: {group} has other nodes"
                elif differ(x[...], y[...]):
                    yield f"{first.name}: {group}/{name} differs"
                if dict(x.attrs) != dict(y.attrs):
                    yield f"{first.name}: {group}/{name} has other attributes"


def pieces(path):
    """What the start tags of a VTU file say, but for offsets into the data."""
    tree = xml.etree.ElementTree.fromstring(path.read_bytes())
    for element in tree.iter():
        yield element.tag, sorted(element.attrib.items())


def main(first, second):
    first, second = pathlib.Path(first), pathlib.Path(second)
    problems = []
    names = [sorted(p.name for p in folder.iterdir()) for folder in (first, second)]
    if names[0] != names[1]:
        problems.append(f"files {names[0]} and {names[1]}")
    else:
        for name in ("time_series.csv", "events.csv"):
            problems += compare_tables(first / name, second / name)
        problems += compare_histories(first / "faults.h5", second / "faults.h5")
        if (first / "solution.pvd").exists():
            for name in names[0]:
                if name.endswith(".vtu"):
                    a, b = first / name, second / name
                    if list(pieces(a)) != list(pieces(b)):
                        problems.append(f"{name} has other pieces")
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
