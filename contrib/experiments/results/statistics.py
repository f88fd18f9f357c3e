# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Numbers that describe a run: its events, steps and iterations."""

import numpy as np

# s: no step is counted before, while the load still grows.
RAMP_END = 1.0
# Of the median slip in an event: those with less are no main events.
MAIN_FRACTION = 0.4


def intervals(events):
    """Between the starts of events, in s."""
    return np.diff(events["start"])


def is_main(events):
    """For each event whether it is not small beside the others."""
    slip = events["mean_slip"]
    return slip >= MAIN_FRACTION * np.median(slip) if len(slip) else slip > 0


def select(events, chosen):
    return {name: values[chosen] for name, values in events.items()}


def during_events(time, events):
    """For each time whether the fault is in an event."""
    inside = np.zeros(len(time), dtype=bool)
    for start, end in zip(events["start"], events["end"]):
        inside |= (time >= start) & (time <= (end if np.isfinite(end) else np.inf))
    return inside


def step_sizes(series, events):
    """Median, shortest and longest step in s, in events and outside of them."""
    time, size = series["time"], series["step_size"]
    inside = during_events(time, events)
    outside = ~inside & (time > RAMP_END)
    return {
        name: spread(size[chosen])
        for name, chosen in (("events", inside), ("loading", outside))
        if chosen.any()
    }


def shrinking(series, events):
    """For each event but the first the longest step since the one before over the
    shortest in it."""
    time, size = series["time"], series["step_size"]
    ratios = []
    for last_end, start, end in zip(events["end"], events["start"][1:],
                                    events["end"][1:]):
        before, inside = (time > last_end) & (time < start), (time >= start) & (time <= end)
        if before.any() and inside.any():
            ratios.append(size[before].max() / size[inside].min())
    return np.array(ratios)


def spread(values):
    return {
        "median": float(np.median(values)),
        "least": float(values.min()),
        "largest": float(values.max()),
    }


def histogram(counts):
    """Share of the steps that took each number."""
    numbers, how_often = np.unique(counts.astype(int), return_counts=True)
    return dict(zip(numbers.tolist(), (how_often / len(counts)).tolist()))


def dependence_on_rate(series, fault, name):
    """Mean of a number of iterations by decade of the fault's largest slip rate."""
    decade = np.floor(np.log10(np.maximum(series[f"{fault}.max_slip_rate"], 1e-30)))
    return {
        int(d): float(series[name][decade == d].mean())
        for d in np.unique(decade)
        if d >= -12
    }


def rates_after(series, fault, from_time):
    """Least and largest mean slip rate of a fault after a time, in m/s."""
    chosen = series["time"] > from_time
    rate = series[f"{fault}.mean_slip_rate"][chosen]
    return (float(rate.min()), float(rate.max())) if len(rate) else (np.nan, np.nan)


def quantiles(series, fault, from_time, levels=(0.0, 0.05, 0.5, 0.95, 1.0)):
    """Of the mean slip rate after a time, weighted by the lengths of the steps."""
    chosen = series["time"] > from_time
    rate = series[f"{fault}.mean_slip_rate"][chosen]
    if len(rate) == 0:
        return [np.nan] * len(levels)
    order = np.argsort(rate)
    part = np.cumsum(series["step_size"][chosen][order])
    part = (part - part[0]) / (part[-1] - part[0]) if len(part) > 1 else part * 0
    return [float(rate[order][np.searchsorted(part, q)]) for q in levels]
