# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""How far a run is from its reference, in numbers."""

import numpy as np

from . import reduced

# The events before the small ones, one every 1.8 s: their order is the same in all
# runs, and the error of one has not yet grown into that of the next.
FIRST_EVENTS = 4
# s: an event farther from every one of the reference is another event.
FARTHEST = 0.45
# s: what is left out before and after an event of either run, where a shift in
# time is all that a difference of slip rates shows.
MARGIN = 0.1


def compare(run, reference):
    """All errors; what cannot be said is left out. Also a note, often empty."""
    errors, notes = {}, []
    errors |= first_event_errors(run["events"], reference["events"])
    matched, notes_of_events = event_errors(
        run["events"], reference["events"], last_time(run)
    )
    errors |= matched
    notes += notes_of_events
    if "x" in run and "x" in reference:
        errors |= slip_error(run, reference)
        errors |= slip_rate_error(run, reference)
    return errors, "; ".join(notes)


def last_time(run):
    """The time in s up to which events are compared."""
    end = float(run["summary"].get("Run/simulated time", "0").split()[0])
    return min(end, reduced.SLIP_TIMES[-1])


def first_event_errors(times, reference):
    """The shift of the first event, and of all four where there are as many."""
    n = min(len(times), len(reference), FIRST_EVENTS)
    if n == 0:
        return {}
    shift = np.subtract(times[:n], reference[:n])
    errors = {"shift_first_event_s": shift[0]}
    if n == FIRST_EVENTS:
        errors["error_event_time_s"] = np.sqrt(np.mean(shift**2))
        errors["error_event_time_max_s"] = np.abs(shift).max()
    return errors


def event_errors(times, reference, end):
    """Shifts of all events that both have, and of how many that can be said."""
    times = np.array([t for t in times if t <= end])
    reference = np.array([t for t in reference if t <= end])
    pairs = matching(times, reference)
    notes = []
    if len(times) > len(pairs):
        notes.append(f"events too many: {len(times) - len(pairs)}")
    if len(reference) > len(pairs):
        notes.append(f"events missing: {len(reference) - len(pairs)}")
    errors = {"events_matched": len(pairs)}
    if pairs:
        shift = np.array([times[i] - reference[j] for i, j in pairs])
        errors["error_all_events_s"] = np.sqrt(np.mean(shift**2))
        errors["error_all_events_max_s"] = np.abs(shift).max()
    return errors, notes


def matching(times, reference):
    """Pairs of events, each the nearest to the other and not too far away."""
    if len(times) == 0 or len(reference) == 0:
        return []
    distance = np.abs(times[:, None] - reference[None, :])
    return [
        (i, j)
        for i, j in enumerate(distance.argmin(axis=1))
        if distance[:, j].argmin() == i and distance[i, j] <= FARTHEST
    ]


def slip_error(run, reference):
    """The L2 norm on the fault of the difference, over that of the reference, at
    the last of the times that both have reached."""
    weight = reference["weight"]
    errors = {}
    for time, slip, other in zip(
        reduced.SLIP_TIMES, run["slip"], reference["slip"]
    ):
        slip = np.interp(reference["x"], run["x"], slip)
        if np.isfinite(slip).all() and np.isfinite(other).all():
            difference = weight @ (slip - other) ** 2 / (weight @ other**2)
            errors = {"slip_time_s": time, "error_slip": np.sqrt(difference)}
    return errors


def slip_rate_error(run, reference):
    """Root mean square and median of the difference of log10 V over the quiet
    times and the fault, where one of the two slips at all."""
    rate = run["log10_rate"].astype(float)
    if not np.array_equal(run["x"], reference["x"]):
        rate = np.array([np.interp(reference["x"], run["x"], row) for row in rate])
    other = reference["log10_rate"].astype(float)
    quiet = is_quiet(run, reference) & np.isfinite(rate).all(axis=1)
    quiet &= np.isfinite(other).all(axis=1)
    rate, other = rate[quiet], other[quiet]
    lowest = np.log10(reduced.SMALLEST_RATE) + 1e-3
    slips = np.maximum(rate, other) > lowest
    weight = slips * reference["weight"]
    if not slips.any():
        return {}
    difference = np.abs(rate - other)
    return {
        "error_log10_slip_rate": np.sqrt(
            (weight * difference**2).sum() / weight.sum()
        ),
        "error_log10_slip_rate_median": np.median(difference[slips]),
    }


def is_quiet(run, reference):
    """Which of the sample times lie in no event of either run."""
    time = reduced.SAMPLE_TIMES
    quiet = np.ones(len(time), dtype=bool)
    for events in (run["event_times"], reference["event_times"]):
        for start, end in events:
            quiet &= (time < start - MARGIN) | (time > end + MARGIN)
    return quiet
