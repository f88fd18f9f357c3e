# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Which settings give the smallest error for their cost."""

import numpy as np

from common import page

from . import cases
from .tables import by_family, count, tables, value

ERROR = "error_event_time_s"
# Compared with one reference, on one mesh, up to one time.
SECTIONS = ("time", "front")
# For lines through logarithms: how many runs, and to what error, in s.
FITTED = 4
GOAL = 4e-3


def points(records):
    """The runs that can be compared."""
    return [
        record
        for record in records
        if record["section"] in SECTIONS
        and record["family"] != "as the reference"
        and record["mesh"] == "published"
        and value(record, ERROR) > 0
    ]


def efficient(records, cost):
    """Those that no other one beats in both cost and error, by cost."""
    front = []
    for record in sorted(
        (r for r in records if value(r, cost) > 0), key=lambda r: value(r, cost)
    ):
        if not front or value(record, ERROR) < value(front[-1], ERROR):
            front.append(record)
    return front


def default(records):
    """The run with default settings, None if it is missing."""
    return next(
        (
            record
            for record in records
            if record["section"] == "time"
            and record["family"] == cases.DEFAULT
            and not record["settings"]
        ),
        None,
    )


def line_of(records, cost):
    """Power and factor of error = factor * cost^power through the finest runs; None
    where the error does not fall with each of them."""
    finest = sorted(records, key=lambda r: value(r, "steps"))[-FITTED:]
    costs = np.array([value(r, cost) for r in finest])
    errors = np.array([value(r, ERROR) for r in finest])
    if len(finest) < 3 or not (costs > 0).all() or (np.diff(errors) >= 0).any():
        return None
    power, offset = np.polyfit(np.log(costs), np.log(errors), 1)
    return (power, np.exp(offset)) if power < 0 else None


def cost_cells(records, cost):
    """The factor for half of the error, and the cost of an error of GOAL."""
    line = line_of(records, cost)
    if line is None:
        return "–", "–"
    power, factor = line
    needed = (GOAL / factor) ** (1 / power)
    rounded = f"{needed:.1f}" if needed < 1000 else f"{100 * round(needed / 100):,}"
    return f"{0.5 ** (1 / power):.2f}", rounded


def halving_table(records):
    """What each family costs, from lines through its finest runs."""
    costs = (("steps", "steps"), ("cycles", "cycles"), ("CPU, s", "cpu_seconds"))
    titles = ["family"]
    for name, _ in costs:
        titles += [f"{name}: to halve the error", f"for {1e3 * GOAL:g} ms"]
    rows = []
    for family, own in by_family(records).items():
        row = [family]
        for _, cost in costs:
            row += cost_cells(own, cost)
        rows.append(row)
    return page.table(titles, rows)


def front_table(records):
    return page.table(
        ("family", "tolerance", "cycles", "CPU, s", "four events, rms, ms"),
        [
            (
                record["family"],
                record["tolerance"],
                count(record, "cycles"),
                page.number(record["cpu_seconds"], 3),
                page.number(1e3 * value(record, ERROR)),
            )
            for record in efficient(records, "cycles")
        ],
    )


def text(records):
    """What halving costs, the front by cycles, and the runs of this section."""
    own = points(records)
    extra = [record for record in own if record["section"] == "front"]
    return (
        f"A line through the logarithms of cost and error of the {FITTED} finest runs "
        "of each family (three where that is all) gives what halving the error "
        f"costs, as a factor, and what an error of {1e3 * GOAL:g} ms costs; a dash "
        "where the error does not fall from run to run:\n\n"
        + halving_table(own)
        + "\nThe front by multigrid cycles (condensed Newton has none):\n\n"
        + front_table(own)
        + "\nRuns that are found in no other section:\n\n"
        + tables(extra, "tolerance", ["steps", "cycles", "cpu", "error", "largest"])
    )
