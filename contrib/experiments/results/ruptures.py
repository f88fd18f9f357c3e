# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Events in space and time: where they begin, how their fronts run, and the small
ones before and after them."""

import numpy as np
from scipy.signal import find_peaks

from . import statistics

# m/s: twice the loading velocity, at which the program begins an event, and the rate
# behind a rupture front.
EVENT_RATE, FRONT_RATE = 4e-4, 2e-3
# m/s: what slips slower between events is the acceleration towards one, on which the
# waves in the bodies ride.
BURST_RATE = 1e-3
# Of log10 of the mean slip rate: by how much bursts within an event stand out.
PROMINENCE = 0.3
# m: a front that runs less is not timed.
SHORTEST_FRONT = 0.4
# Of the interval between events: how far foreshocks and aftershocks are at most.
NEIGHBOURHOOD = 0.25


def first_passage(history, rates, start, end, threshold):
    """When each node first exceeds a rate in a window, by linear interpolation of the
    rate's logarithm between records; nan where it never does."""
    first, last = np.searchsorted(history.time, [start, end])
    first = max(first - 1, 0)
    window = np.log(np.maximum(rates[first:last + 1], 1e-30))
    time = history.time[first:last + 1]
    above = window > np.log(threshold)
    passage = np.full(len(history.x), np.nan)
    for node in np.flatnonzero(above.any(axis=0)):
        i = int(np.argmax(above[:, node]))
        if i == 0:
            passage[node] = time[0]
            continue
        low, high = window[i - 1, node], window[i, node]
        part = (np.log(threshold) - low) / (high - low)
        passage[node] = time[i - 1] + part * (time[i] - time[i - 1])
    return passage


def nucleation(history, passage):
    """Position and time of the first node."""
    node = int(np.nanargmin(passage))
    return float(history.x[node]), float(passage[node])


def front_speed(history, passage, edge, side):
    """Speed in m/s of the front from an edge of the nucleation zone outwards to one
    side (-1, 1), by least squares through the times of the nodes; nan if it did not
    come SHORTEST_FRONT far."""
    distance = side * (history.x - edge)
    chosen = (distance > 0) & np.isfinite(passage)
    if chosen.sum() < 5 or np.ptp(distance[chosen]) < SHORTEST_FRONT:
        return float("nan")
    slowness = np.polyfit(distance[chosen], passage[chosen], 1)[0]
    return float(1.0 / slowness) if slowness > 0 else float("nan")


def describe(history, rates, start, end, before):
    """What one event looks like; it is looked for from a time before its start."""
    creep = first_passage(history, rates, before, end, EVENT_RATE)
    front = first_passage(history, rates, before, end, FRONT_RATE)
    result = {"start": start, "end": end}
    if np.isfinite(creep).any():
        result["site"], result["begin"] = nucleation(history, creep)
        zone = zone_at(history, rates, start)
        result["zone_left"], result["zone_right"] = zone
    if np.isfinite(creep).any() and np.isfinite(front).any():
        site, time = nucleation(history, front)
        result |= {
            "front_site": site,
            "front_begin": time,
            "speed_left": front_speed(history, front, zone[0], -1),
            "speed_right": front_speed(history, front, zone[1], 1),
            "reached": float(history.weight[np.isfinite(front)].sum()
                             / history.weight.sum()),
        }
    return result


def zone_at(history, rates, time):
    """Left and right end in m of what slips faster than EVENT_RATE at a time."""
    record = min(int(np.searchsorted(history.time, time)), len(history.time) - 1)
    fast = history.x[rates[record] > EVENT_RATE]
    return (float(fast[0]), float(fast[-1])) if len(fast) else (np.nan, np.nan)


def bursts(series, fault, events):
    """Times when some node is faster than EVENT_RATE while the fault in the mean is
    in no event: lists of (begin, end, largest rate)."""
    time, rate = series["time"], series[f"{fault}.max_slip_rate"]
    inside = statistics.during_events(time, events)
    fast = (rate > EVENT_RATE) & ~inside
    edges = np.flatnonzero(np.diff(np.concatenate(([0], fast.astype(int), [0]))))
    result = []
    for first, last in zip(edges[::2], edges[1::2]):
        touches = inside[max(first - 1, 0)] or inside[min(last, len(inside) - 1)]
        result.append({
            "begin": float(time[first]),
            "end": float(time[last - 1]),
            "rate": float(rate[first:last].max()),
            # What goes over into an event without a pause is a part of it.
            "separate": not touches,
        })
    return result


def small_ones(series, fault, events):
    """What is smaller than a main event: those of the catalogue with little slip, and
    bursts in which a node reaches BURST_RATE; each with its kind."""
    main = statistics.is_main(events)
    found = [
        {"begin": start, "end": end, "rate": rate, "whole": True}
        for start, end, rate, large in zip(
            events["start"], events["end"], events["peak_slip_rate"], main
        )
        if not large
    ]
    found += [
        burst | {"whole": False}
        for burst in bursts(series, fault, events)
        if burst["separate"] and burst["rate"] > BURST_RATE
    ]
    large = statistics.select(events, main)
    for one in found:
        one["kind"] = classify(one, large)
    return sorted(found, key=lambda one: one["begin"])


def peaks_within(series, fault, start, end):
    """The largest mean slip rate in m/s in each of the bursts that an event is made of."""
    time = series["time"]
    chosen = (time >= start - 0.1) & (time <= end + 0.1)
    rate = series[f"{fault}.mean_slip_rate"][chosen]
    found, _ = find_peaks(np.log10(np.maximum(rate, 1e-30)), prominence=PROMINENCE)
    return [float(rate[k]) for k in found if rate[k] > EVENT_RATE]


def classify(burst, events):
    """foreshock, aftershock or between, by the place in the interval between two
    events; the nearer one counts where both are near."""
    starts, ends = events["start"], events["end"]
    following = starts[starts > burst["begin"]]
    preceding = ends[ends < burst["end"]]
    to_next = following[0] - burst["end"] if len(following) else np.inf
    from_last = burst["begin"] - preceding[-1] if len(preceding) else np.inf
    interval = np.median(np.diff(starts)) if len(starts) > 1 else np.inf
    if min(to_next, from_last) > NEIGHBOURHOOD * interval:
        return "between"
    return "foreshock" if to_next < from_last else "aftershock"
