# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Fields along a fault in the plane: over position and time, and at single times."""

import numpy as np
from matplotlib.colors import LogNorm

from .style import BLUE, GREY, ORANGE, VERMILION
from .style import edges, rate_limits, say, scaled, time_scale, title

# Contours of slip: about so many over the run, and in an event.
N_BETWEEN, N_WITHIN = 25, 8


def position_axis(fault):
    """By what to multiply positions, and the label of their axis."""
    factor, unit = scaled(np.ptp(fault.along), "m")
    return factor, f"{fault.label} [{unit}]"


def nice(size):
    """A number of one digit of about this size."""
    power = 10 ** np.floor(np.log10(size))
    return power * min((1, 2, 5, 10), key=lambda digit: abs(digit - size / power))


class TimeOfMap:
    """The time axis of a map: the whole run, or an event from its start on."""

    def __init__(self, fault, event):
        self.records = (np.arange(len(fault.time)) if event is None
                        else fault.within(event.window))
        time = fault.time[self.records]
        self.start = 0.0 if event is None else event.start
        self.factor, unit = time_scale(
            np.ptp(time) if event is not None and len(time) else fault.time[-1])
        self.values = self.factor * (time - self.start)
        self.label = (f"time [{unit}]" if event is None
                      else f"time since the event starts [{unit}]")


def draw_map(axis, fault, event, values_of, label, **options):
    """A picture of what VALUES_OF makes of some records, over position and time."""
    time = TimeOfMap(fault, event)
    if len(time.records) < 2 or len(fault.along) < 2:
        say(axis, "no records")
        return None
    along, along_label = position_axis(fault)
    image = axis.pcolormesh(
        edges(time.values), edges(along * fault.along), values_of(time.records).T,
        shading="flat", rasterized=True, **options)
    axis.set(xlim=time.values[[0, -1]], xlabel=time.label, ylabel=along_label)
    axis.figure.colorbar(image, ax=axis, label=label, pad=0.01)
    return image


def slip_rates(axis, fault, event=None, limits=None):
    """Slip rates; of an event with its rupture front."""
    records = TimeOfMap(fault, event).records
    limits = limits or rate_limits([fault.size("slip_rate", records)])
    title(axis, f"Slip rate along {fault.name}" if event is None
          else f"Slip rate in event {event.number}, from t = {event.start:.8g} s on")
    image = draw_map(axis, fault, event,
                     lambda r: np.clip(fault.size("slip_rate", r), *limits),
                     "slip rate [m/s]", cmap="viridis", norm=LogNorm(*limits))
    if event is not None and image is not None:
        front = fault.rupture_times(event)
        axis.plot(TimeOfMap(fault, event).factor * (front - event.start),
                  position_axis(fault)[0] * fault.along, color="white", linewidth=0.8,
                  linestyle="--")


def shear_tractions(axis, fault, event=None):
    title(axis, f"Shear traction along {fault.name}"
          + ("" if event is None else f", event {event.number}"))
    if not fault.has("shear_traction"):
        say(axis, "no shear_traction")
        return
    records = TimeOfMap(fault, event).records
    values = fault.first_component("shear_traction", records)
    by, unit = scaled(np.abs(values).max(initial=0), "Pa")
    # The ends of a fault, where it sticks for good, do not set the limits.
    low, high = np.percentile(by * values, (0.5, 99.5)) if values.size else (0, 1)
    draw_map(axis, fault, event, lambda r: by * values, f"shear traction [{unit}]",
             cmap="magma", vmin=low, vmax=high if high > low else low + 1)


def gaps(axis, fault, event=None):
    """Gaps; closed nodes stay white."""
    records = TimeOfMap(fault, event).records
    gap = fault.field("gap", records)
    by, unit = scaled(gap.max(initial=0), "m")
    title(axis, f"Gap along {fault.name}"
          + ("" if event is None else f", event {event.number}"))
    image = draw_map(axis, fault, event, lambda r: np.where(gap > 0, by * gap, np.nan),
                     f"gap [{unit}]", cmap="magma_r")
    if image is not None and not (gap > 0).any():
        image.set_clim(0, 1)
        say(axis, "closed")


def slip_contours(axis, fault, events):
    """The slip at equal times: one spacing between events, a small one within them."""
    title(axis, f"Slip of {fault.name} at equal times")
    if not fault.has("slip") or len(fault.time) < 2:
        say(axis, "no slip")
        return
    extent = fault.time[-1] - fault.time[0]
    between = nice(extent / N_BETWEEN)
    times = np.arange(np.ceil(fault.time[0] / between), fault.time[-1] / between) * between
    lengths = events["end"] - events["start"]
    lengths = lengths[np.isfinite(lengths) & (lengths > 0)]
    sets = [(times, BLUE, between)]
    if len(lengths):
        within = nice(np.median(lengths) / N_WITHIN)
        # An event that never ended is drawn up to the last record.
        ends = np.where(np.isfinite(events["end"]), events["end"], fault.time[-1])
        in_events = [np.arange(start, min(end, start + 40 * within), within)
                     for start, end in zip(events["start"], ends)]
        slow = [t for t in times
                if not ((events["start"] <= t) & (t <= ends)).any()]
        sets = [(np.concatenate(in_events), ORANGE, within),
                (np.array(slow), BLUE, between)]
    slip = [fault.at_times("slip", times) for times, _, _ in sets]
    by, unit = scaled(max(np.abs(s).max(initial=0) for s in slip), "m")
    along, along_label = position_axis(fault)
    for (times, colour, spacing), values in zip(sets, slip):
        factor, time_unit = time_scale(spacing if spacing < 1 else 2 * spacing)
        name = "in events" if colour == ORANGE else "between them"
        for number, line in enumerate(by * values):
            axis.plot(along * fault.along, line, color=colour, linewidth=0.5,
                      label=f"{name}, every {factor * spacing:.3g} {time_unit}"
                      if number == 0 else None)
    axis.set(xlabel=along_label, ylabel=f"slip [{unit}]")
    axis.margins(x=0)
    axis.legend(loc="lower right", bbox_to_anchor=(1, 0.98), ncol=2)


def profiles(axes, fault, window):
    """Slip within a window, and shear tractions at its ends; if the fault may open, its
    gap when that is largest."""
    records = list(fault.ends_of(window))
    along, along_label = position_axis(fault)
    x = along * fault.along
    for axis, field, unit in ((axes[0], "slip", "m"), (axes[1], "shear_traction", "Pa")):
        name = field.replace("_", " ")
        axis.grid(alpha=0.3)
        if not fault.has(field):
            say(axis, f"no {name}")
            continue
        before, after = fault.first_component(field, records)
        if field == "slip":
            by, unit = scaled(np.abs(after - before).max(), unit)
            axis.plot(x, by * (after - before), color=BLUE, linewidth=0.9)
        else:
            by, unit = scaled(max(np.abs(before).max(), np.abs(after).max()), unit)
            axis.plot(x, by * before, color=GREY, linewidth=0.9, label="before")
            axis.plot(x, by * after, color=VERMILION, linewidth=0.9, label="after")
            axis.legend()
        axis.set(xlabel=along_label, ylabel=f"{name} [{unit}]")
    if fault.has("gap"):
        gap = fault.field("gap", slice(records[0], records[1] + 1))
        widest = gap.max(axis=1).argmax()
        by, unit = scaled(gap.max(), "m")
        axes[2].plot(x, by * gap[widest], color=VERMILION, linewidth=0.9)
        axes[2].set(xlabel=along_label, ylabel=f"gap [{unit}]")
        title(axes[2], f"t = {fault.time[records[0] + widest]:.5g} s")
        axes[2].grid(alpha=0.3)
    title(axes[0], f"What {fault.name} slips from t = {fault.time[records[0]]:.6g} s "
                   f"to {fault.time[records[1]]:.6g} s")
