# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The table of hard cases as CSV file and as a page."""

from hard.run import PROJECT
from measure import csv_file

DATA = PROJECT / "doc" / "data" / "hard_cases.csv"
PAGE = PROJECT / "doc" / "hard_cases.md"
COLUMNS = "case holds steps iterations error note".split()
BEGIN, END = "<!-- begin of the table -->", "<!-- end of the table -->"


def write_data(rows):
    csv_file.write(DATA, COLUMNS, rows)


def read_data():
    return csv_file.read(DATA)


def table(rows):
    lines = ["| " + " | ".join(COLUMNS) + " |", "|---" * len(COLUMNS) + "|"]
    for row in rows:
        cells = [str(row[column]).replace("|", "\\|") for column in COLUMNS]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def write_page(rows):
    """Replace the table between the marks of the page."""
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(f"{before}{BEGIN}\n\n{table(rows)}\n\n{END}{after}", encoding="utf-8")
