# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables of doc/accuracy.md."""

from common import page

# s: mean between two of the first four events, of five bodies and of the spring slider.
INTERVALS = {"five bodies": 2.54}
INTERVAL = 1.81


def interval(record):
    """s between two events of the scene of a row."""
    return INTERVALS.get(record["section"], INTERVAL)


def value(record, name):
    """A number of a row, nan where there is none."""
    try:
        return float(record.get(name, "nan"))
    except ValueError:
        return float("nan")


def cell(record, name, factor=1.0, digits=2):
    text = page.number(factor * value(record, name), digits)
    return "–" if text == "nan" else text


def count(record, name):
    number = value(record, name)
    return f"{number:,.0f}" if number == number else "–"


COLUMNS = {
    "steps": ("steps solved", lambda r: count(r, "steps")),
    "cycles": ("cycles", lambda r: count(r, "cycles")),
    "cpu": ("CPU, s", lambda r: cell(r, "cpu_seconds", digits=3)),
    "vertices": ("vertices", lambda r: count(r, "vertices")),
    "nodes": ("on the fault", lambda r: count(r, "fault_nodes")),
    "events": ("events", lambda r: count(r, "events")),
    "matched": ("of the reference", lambda r: count(r, "events_matched")),
    "first": ("first event, ms", lambda r: cell(r, "shift_first_event_s", 1e3)),
    "error": ("four events, rms, ms", lambda r: cell(r, "error_event_time_s", 1e3)),
    "largest": ("largest, ms", lambda r: cell(r, "error_event_time_max_s", 1e3)),
    "share": (
        "rms, % of an interval",
        lambda r: cell(r, "error_event_time_s", 100 / interval(r)),
    ),
    "all": ("all events, rms, ms", lambda r: cell(r, "error_all_events_s", 1e3)),
    "all_largest": (
        "all events, largest, ms",
        lambda r: cell(r, "error_all_events_max_s", 1e3),
    ),
    "slip": ("slip, %", lambda r: cell(r, "error_slip", 100)),
    "rate": ("log10 V, rms", lambda r: cell(r, "error_log10_slip_rate")),
    "median": (
        "log10 V, median", lambda r: cell(r, "error_log10_slip_rate_median")
    ),
    "note": ("note", lambda r: r["note"]),
}


def table(records, label, names, first="tolerance"):
    """A row for each record, under the given columns; no empty column of notes."""
    if not any(record["note"] for record in records):
        names = [name for name in names if name != "note"]
    titles = [label] + [COLUMNS[name][0] for name in names]
    rows = [
        [record[first]] + [COLUMNS[name][1](record) for name in names]
        for record in records
    ]
    return page.table(titles, rows)


def by_family(records):
    families = {}
    for record in records:
        families.setdefault(record["family"], []).append(record)
    return families


def tables(records, label, names):
    """A table for each family, under its name."""
    return "\n".join(
        f"*{family}*\n\n{table(own, label, names)}"
        for family, own in by_family(records).items()
    )
