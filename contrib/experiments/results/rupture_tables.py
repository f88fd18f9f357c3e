# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables of events in space and time."""

import numpy as np

from common import page

from . import ruptures
from .history import FaultHistory

# s: how long before its start an event is looked for, at most half an interval.
BEFORE = 0.8


def describe_all(run):
    """What ruptures.describe says of each event of the top fault."""
    fault = run.case.top_fault()
    events = run.events(fault)
    history = FaultHistory(run.history(), fault)
    rates = history.rate()
    rows = []
    for k, (start, end) in enumerate(zip(events["start"], events["end"])):
        last = events["end"][k - 1] if k else 0.0
        before = max(start - BEFORE, (start + last) / 2)
        end = end if np.isfinite(end) else history.time[-1]
        row = ruptures.describe(history, rates, start, end, before)
        row["peak"] = events["peak_mean_slip_rate"][k]
        row["bursts"] = ruptures.peaks_within(run.series(), fault, start, end)
        rows.append(row)
    return rows


def small_ones(run):
    fault = run.case.top_fault()
    return ruptures.small_ones(run.series(), fault, run.events(fault))


def values(rows, name):
    numbers = np.array([row.get(name, np.nan) for row in rows], dtype=float)
    return numbers[np.isfinite(numbers)]


def spread(numbers, form="{:.2g}"):
    if len(numbers) == 0:
        return "–"
    return (f"{form.format(np.median(numbers))}"
            f" ({form.format(numbers.min())} to {form.format(numbers.max())})")


QUANTITIES = (
    ("distance of the first fast node from the centre, m",
     lambda rows, _: spread(np.abs(values(rows, "site")))),
    ("events whose first fast node is within 1.25 m of the centre",
     lambda rows, _: f"{np.sum(np.abs(values(rows, 'site')) < 1.25)} of {len(rows)}"),
    ("from there to the event's start, s",
     lambda rows, _: spread(values(rows, "start") - values(rows, "begin"))
     if len(values(rows, "begin")) == len(rows) else "–"),
    ("zone faster than 0.4 mm/s at the event's start: length, m",
     lambda rows, _: spread(values(rows, "zone_right") - values(rows, "zone_left"))),
    ("its middle, distance from the centre, m",
     lambda rows, _: spread(np.abs(middles(rows)))),
    ("where 2 mm/s is exceeded first, distance from the centre, m",
     lambda rows, _: spread(np.abs(values(rows, "front_site")))),
    ("speed of the fronts that leave the zone, m/s",
     lambda rows, _: spread(np.concatenate(
         (values(rows, "speed_left"), values(rows, "speed_right"))))),
    ("share of the fault that exceeds 2 mm/s",
     lambda rows, _: spread(values(rows, "reached"))),
    ("events whose zone has grown to both sides of its first node, by 0.2 m at least",
     lambda rows, _: f"{both_sides(rows)} of {len(rows)}"),
    ("events of several bursts; of these, with the largest not the first",
     lambda rows, _: several(rows)),
    ("foreshocks, aftershocks, others apart from events",
     lambda _, bursts: ", ".join(
         str(sum(b["kind"] == kind for b in bursts))
         for kind in ("foreshock", "aftershock", "between"))),
)


def middles(rows):
    return (values(rows, "zone_left") + values(rows, "zone_right")) / 2


def both_sides(rows):
    return sum(
        row["zone_left"] < row["site"] - 0.2 and row["zone_right"] > row["site"] + 0.2
        for row in rows
        if "zone_left" in row
    )


def several(rows):
    own = [row["bursts"] for row in rows if len(row["bursts"]) > 1]
    return f"{len(own)}; {sum(max(peaks) > peaks[0] for peaks in own)}"


def text(runs):
    """The table, and a row for each event."""
    described = [(run, describe_all(run), small_ones(run)) for run in runs]
    table = page.table(
        ("top fault; median (least to largest)", *(r.case.title for r in runs)),
        [
            (name, *(tell(rows, bursts) for _, rows, bursts in described))
            for name, tell in QUANTITIES
        ],
    )
    names = ("start end peak site begin zone_left zone_right front_site front_begin "
             "speed_left speed_right reached").split()
    data = [
        {"run": run.case.title,
         **{name: page.rounded(row.get(name, "")) for name in names}}
        for run, rows, _ in described
        for row in rows
    ]
    return table, data


def examples(runs):
    """Events to be drawn, as (title, run, fault, index): the spring slider's with the
    highest slip rate, and of each experiment the first with an aftershock."""
    slider, layered = runs["slider_default"], runs["layered_default"]
    fault = slider.case.top_fault()
    peaks = slider.events(fault)["peak_mean_slip_rate"]
    chosen = [("Spring slider", slider, fault, int(np.argmax(peaks)))] if len(peaks) else []
    for title, run in (("Spring slider", slider), ("Five bodies", layered)):
        fault = run.case.top_fault()
        starts = run.events(fault)["start"]
        times = [one["begin"] for one in small_ones(run) if one["kind"] == "aftershock"]
        if times:
            index = int(np.searchsorted(starts, times[0])) - 1
            chosen.append((title, run, fault, index))
    return chosen
