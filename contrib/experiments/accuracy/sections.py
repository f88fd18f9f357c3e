# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The sections of doc/accuracy.md: what each runs and how it is told."""

import dataclasses
import math
from typing import Callable

from common import page, programs

from . import (
    cases, drawings, five_bodies, front, independent_reference, mesh_and_time,
    mesh_and_time_text,
)
from .tables import by_family, table, tables, value

PAGE = programs.PROJECT / "doc/accuracy.md"
MESHES_PAGE = programs.PROJECT / "doc/meshes.md"
COST = ["steps", "cycles", "cpu"]
ERRORS = ["first", "error", "largest", "share", "slip", "rate", "median", "note"]


@dataclasses.dataclass
class Section:
    """Cases to run, the text that tells their records, and what a case is compared
    with, if that is not the run that it names."""

    all_cases: Callable
    text: Callable
    quick_cases: Callable = lambda: []
    reference: Callable | None = None

    def cases(self, quick):
        return self.quick_cases() if quick else self.all_cases()


def time_text(records):
    """But for the reference, which has no error to tell."""
    compared = [record for record in records if record["reference"]]
    return tables(compared, "tolerance", COST + ERRORS)


def late_text(records):
    return tables(
        records,
        "tolerance",
        COST + ["events", "matched", "all", "all_largest", "slip", "rate", "median",
                "note"],
    )


def algebra_text(records):
    return tables(records, "tolerance", COST + ERRORS)


def space_text(records):
    """Beside the differences from the finest mesh their limit and order."""
    parts = []
    for family, own in by_family(records).items():
        columns = ["vertices", "nodes", *COST, *ERRORS]
        parts.append(f"*{family}*\n\n" + table(own, "mesh", columns, "mesh"))
        parts.append(order_text(own))
    return "\n".join(parts)


def order_text(records):
    """Order and limit of the first event, from the three finest meshes."""
    # All are shifts from the same run, which itself has none.
    shifts = [value(record, "shift_first_event_s") for record in records]
    shifts = [0.0 if math.isnan(shift) else shift for shift in shifts]
    if len(shifts) < 4:
        return ""
    before, last = shifts[-3] - shifts[-2], shifts[-2] - shifts[-1]
    if before * last <= 0 or abs(last) >= abs(before):
        return "The shifts of the first event are no power of the cells' size.\n"
    ratio = before / last
    left = last / (ratio - 1)
    return (
        f"The first event moves by {1e3 * abs(before):.2g} ms and then by "
        f"{1e3 * abs(last):.2g} ms on the three finest meshes: order "
        f"{math.log2(ratio):.2f}, and another {1e3 * abs(left):.2g} ms from the finest "
        "one to the limit.\n"
    )


def quick_time():
    """Coarse tolerances of the default and the published control, beside the default
    tolerance."""
    runs = {(case.family, case.tolerance): case for case in cases.time_cases()}
    chosen = (cases.DEFAULT, "3e-4"), (cases.PUBLISHED, "1e-2")
    to = runs[cases.DEFAULT, cases.DEFAULT_TOLERANCE]
    return [dataclasses.replace(runs[key], reference=to) for key in chosen]


def quick_independent():
    return [
        dataclasses.replace(case, end_time=independent_reference.QUICK_END)
        for case in cases.independent_cases()[1:3]
    ]


SECTIONS = {
    "time": Section(cases.time_cases, time_text, quick_time),
    "front": Section(cases.front_cases, front.text),
    "late": Section(cases.late_cases, late_text),
    "space": Section(cases.space_cases, space_text),
    mesh_and_time.SECTION: Section(mesh_and_time.all_cases, mesh_and_time_text.text),
    five_bodies.SECTION: Section(five_bodies.all_cases, mesh_and_time_text.text),
    "independent": Section(
        cases.independent_cases,
        lambda records: tables(
            records, "tolerance", COST + ["first", "error", "largest", "note"]
        ),
        quick_independent,
        independent_reference.events,
    ),
    "law": Section(cases.law_cases, time_text),
    "algebra": Section(cases.algebra_cases, algebra_text),
}


def publish(records):
    """Write what the records say into the page and the figures; their paths."""
    for name, section in SECTIONS.items():
        own = [record for record in records if record["section"] == name]
        # That of the front looks at the others as well.
        if own:
            text = section.text(records if name == "front" else own)
            page.replace_section(name, text, PAGE, "contrib/accuracy")
    for name in (mesh_and_time.SECTION, five_bodies.SECTION):
        own = [record for record in records if record["section"] == name]
        if own:
            text = mesh_and_time_text.mesh_table(own)
            page.replace_section(name, text, MESHES_PAGE, "contrib/accuracy")
    return [PAGE, MESHES_PAGE, *drawings.draw(records)]
