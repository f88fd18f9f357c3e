# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables as CSV files: lists of dictionaries, from column to text or number."""

import csv


def read(path):
    """The rows of a file; none if it does not exist."""
    if not path.is_file():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(path, columns, rows):
    """In one piece, so that breaking off loses nothing."""
    path.parent.mkdir(exist_ok=True)
    temporary = path.with_suffix(".csv.new")
    with temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    temporary.rename(path)
