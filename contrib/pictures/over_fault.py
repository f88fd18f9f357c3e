# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Maps over a fault in space."""

import numpy as np
from matplotlib.colors import LogNorm

from .style import say, scaled, time_scale, title

# Lines of the rupture front.
N_FRONTS = 10


def maps_of(fault, window):
    """Labels, values at the nodes and colours of what is drawn of a window of time:
    slip, largest slip rate, change of traction, and largest gap."""
    first, last = fault.ends_of(window)
    if fault.has("slip"):
        before, after = fault.field("slip", [first, last])
        slip = (np.linalg.norm(after - before, axis=1) if after.ndim == 2
                else np.abs(after - before))
        by, unit = scaled(slip.max(), "m")
        yield f"slip [{unit}]", by * slip, "viridis"
    yield ("largest slip rate [m/s]",
           fault.size("slip_rate", slice(first, last + 1)).max(axis=0), "viridis")
    if fault.has("shear_traction"):
        before, after = fault.size("shear_traction", [first, last])
        by, unit = scaled(np.abs(after - before).max(), "Pa")
        yield f"change of shear traction [{unit}]", by * (after - before), "RdBu_r"
    if fault.has("gap"):
        gap = fault.field("gap", slice(first, last + 1)).max(axis=0)
        by, unit = scaled(gap.max(), "m")
        yield f"largest gap [{unit}]", by * gap, "magma_r"


def n_maps(fault, event):
    """The number of maps of an event; None: of the whole run."""
    return (2 + fault.has("slip") + fault.has("shear_traction") + fault.has("gap")
            - (event is None))


def prepare(axis, fault):
    """What positions are multiplied by, on axes with labels."""
    by, unit = scaled(np.ptp(fault.map, axis=0).max(), "m")
    axis.set(xlabel=f"{fault.labels[0]} [{unit}]", ylabel=f"{fault.labels[1]} [{unit}]",
             aspect="auto" if fault.is_long else "equal")
    if fault.labels[1].startswith("down") and not axis.yaxis_inverted():
        axis.invert_yaxis()
    return by


def add_colours(axis, fault, image, label):
    axis.figure.colorbar(image, ax=axis, label=label, pad=0.02,
                         orientation="vertical" if fault.is_long else "horizontal")


def draw_map(axis, fault, label, values, colours):
    limits = {}
    if colours == "RdBu_r":
        size = np.abs(values).max()
        limits = {"vmax": size, "vmin": -size}
    elif label.startswith("largest slip rate") and values.max() > 0:
        values = np.maximum(values, 1e-6 * values.max())
        limits = {"norm": LogNorm(values.min(), values.max() * (1 + 1e-9))}
    by = prepare(axis, fault)
    image = axis.tripcolor(*(by * fault.map).T, fault.triangles(), values,
                           shading="gouraud", cmap=colours, rasterized=True, **limits)
    add_colours(axis, fault, image, label)


def rupture_front(axis, fault, event):
    """Where the front is at equal times, from when nodes are first faster than the
    slip rate at which events begin."""
    times = fault.rupture_times(event)
    factor, unit = time_scale(event.end - event.start)
    label = f"rupture time since the event starts [{unit}]"
    by = prepare(axis, fault)
    values = factor * (times - event.start)
    corners = fault.triangles()
    ruptured = corners[np.isfinite(values[corners]).all(axis=1)]
    if len(ruptured) == 0:
        say(axis, "nothing ruptures")
        return
    known = np.where(np.isfinite(values), values, 0.0)
    x, y = (by * fault.map).T
    image = axis.tripcolor(x, y, ruptured, known, shading="gouraud", cmap="plasma",
                           rasterized=True)
    if np.ptp(known[np.unique(ruptured)]) > 0:
        axis.tricontour(x, y, ruptured, known, N_FRONTS, colors="black", linewidths=0.6)
    axis.set(xlim=(x.min(), x.max()))
    axis.set_ylim(*((y.max(), y.min()) if axis.yaxis_inverted() else (y.min(), y.max())))
    add_colours(axis, fault, image, label)


def maps(axes, fault, window):
    """As many maps of a window of time as there are axes."""
    first = axes[0]
    for axis, one in zip(axes, maps_of(fault, window)):
        draw_map(axis, fault, *one)
    begin, end = fault.ends_of(window)
    title(first, f"{fault.name} from t = {fault.time[begin]:.6g} s "
                 f"to {fault.time[end]:.6g} s")
