# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The table of all results, doc/data/speed_against_error.csv."""

from common import csv_file, page, programs

from . import errors
from .slider import TOP_FAULTS, summary_number

DATA = programs.PROJECT / "doc/data/speed_against_error.csv"
COLUMNS = (
    "section family mesh tolerance settings reference end_time_s vertices "
    "fault_nodes events steps cycles cpu_seconds search_cpu_seconds "
    "shift_first_event_s "
    "error_event_time_s error_event_time_max_s events_matched error_all_events_s "
    "error_all_events_max_s slip_time_s error_slip error_log10_slip_rate "
    "error_log10_slip_rate_median note"
).split()
KEY = ("section", "family", "mesh", "tolerance")


def make_record(case, result, reference):
    """A row: what was run, what it cost, and how far it is from its reference."""
    values, note = errors.compare(result, reference) if reference else ({}, "")
    notes = [text for text in (result["note"], note) if text]
    if reference and reference.get("note"):
        notes.append(f"reference {reference['note']}")
    return {
        "section": case.section,
        "family": case.family,
        "mesh": case.mesh,
        "tolerance": case.tolerance,
        "settings": "; ".join(f"{k}={v}" for k, v in case.settings),
        "reference": case.reference.title if case.reference else "",
        "end_time_s": summary_number(result, "Run/simulated time"),
        "vertices": summary_number(result, "Mesh of all bodies/vertices"),
        "fault_nodes": summary_number(
            result, f"Fault {TOP_FAULTS[case.scene]}/nodes"),
        "events": len(result["events"]),
        "steps": summary_number(result, "Steps/solved"),
        "cycles": summary_number(result, "Iterations/multigrid cycles, all steps"),
        "cpu_seconds": result["cpu_seconds"],
        "search_cpu_seconds": result.get("search_cpu_seconds", ""),
        "note": "; ".join(notes),
        **values,
    }


def read():
    return csv_file.read(DATA)


def write(records):
    csv_file.write(DATA, COLUMNS, [{c: cell(r, c) for c in COLUMNS} for r in records])


def cell(record, column):
    """Numbers are cut to what can be told apart, names stay as they are."""
    value = record.get(column, "")
    return value if column in KEY else page.rounded(value)


def put(records, record):
    """Replace the row of the same run, or add it."""
    for i, other in enumerate(records):
        if all(other[name] == record[name] for name in KEY):
            records[i] = record
            return
    records.append(record)
