# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scenes listric_thrust.prm and thrust_sequence.prm: events on faults that dip."""

import h5py
import numpy as np
from matplotlib.collections import PolyCollection

from common import page
from common.figures import BLUE, GREY, ORANGE, VERMILION, new_figure, title
from experiments.results.history import FaultHistory

from . import cases
from .volume import Volume, volumes

YEAR = 365 * 86400.0
# m/s: what counts as seismic.
SEISMIC = 1e-3
LISTRIC, SEQUENCE = "listric_thrust", "thrust_sequence"


class Sequence:
    """A run, with distances down the dip from the surface."""

    def __init__(self, run):
        self.run = run
        self.series = run.series()
        self.events = run.events("fault")
        self.history = FaultHistory(run.history(), "fault")
        with h5py.File(run.history(), "r") as file:
            points = np.array(file["fault"]["coordinates"])[self.history.nodes]
        self.points = points
        pieces = np.linalg.norm(np.diff(points, axis=0), axis=1)
        self.distance = np.concatenate([[0.0], np.cumsum(pieces)])

    def depth(self, x):
        return -np.interp(x, self.points[:, 0], self.points[:, 1])

    def window(self, event):
        """Records of an event, from before to after it."""
        time = self.history.time
        begin = np.searchsorted(time, self.events["start"][event]) - 1
        return max(begin, 0), np.searchsorted(time, self.events["end"][event])


def event_rows(sequence):
    events = sequence.events
    rows = []
    for k, start in enumerate(events["start"]):
        begin, end = sequence.window(k)
        slip = sequence.history.field("slip")
        change = -(slip[min(end, len(slip) - 1)] - slip[begin])
        normal = sequence.history.field("normal_stress")
        rows.append((
            f"{start / YEAR:.0f}",
            f"{(start - events['start'][k - 1]) / YEAR:.0f}" if k > 0 else "–",
            f"{change.max():.1f}", f"{change[0]:.1f}",
            f"{events['peak_slip_rate'][k]:.1f}",
            f"{sequence.depth(events['nucleation_x'][k]) / 1e3:.0f}",
            f"{normal[begin:end].min() / 1e6:.1f} to "
            f"{normal[begin:end].max() / 1e6:.1f}",
        ))
    return page.table(
        ("year", "since the last", "largest slip, m", "slip at the surface, m",
         "largest slip rate, m/s", "depth where it begins, km",
         "normal stress during it, MPa"), rows)


def outcome(store, name):
    sequence = Sequence(store.run(cases.case(name.replace("_", " "), name)))
    text = (event_rows(sequence) + "\n"
            + page.table(cases.COST_TITLES, [cases.cost(sequence.run)]))
    return cases.Outcome(text, {name: lambda: draw(sequence)})


def listric(store):
    return outcome(store, LISTRIC)


def sequence(store):
    return outcome(store, SEQUENCE)


def coseismic(sequence, event):
    """Cells, and their displacement between the files before and after an event."""
    time, paths = volumes(sequence.run.files)
    before = np.searchsorted(time, sequence.events["start"][event], "right") - 1
    after = min(np.searchsorted(time, sequence.events["end"][event] + 60),
                len(paths) - 1)
    first, last = Volume(paths[before]), Volume(paths[after])
    # Corners go round the cell.
    from_centre = first.points - first.points.mean(axis=1, keepdims=True)
    order = np.argsort(np.arctan2(from_centre[..., 1], from_centre[..., 0]), axis=1)
    moved = last.displacement() - first.displacement()
    return (np.take_along_axis(values, order[..., None], axis=1)
            for values in (first.points, moved))


def draw_displacement(axes, sequence, event):
    points, moved = coseismic(sequence, event)
    limit = np.abs(moved[..., 1]).max()
    image = axes.add_collection(PolyCollection(
        points / 1e3, array=moved[..., 1].mean(axis=1), cmap="RdBu_r",
        edgecolors="#00000030", linewidths=0.2))
    image.set_clim(-limit, limit)
    axes.plot(*(sequence.points.T / 1e3), color="black", linewidth=1)
    axes.set(xlim=(-20, 45), ylim=(-26, 2), aspect="equal", xlabel="x [km]",
             ylabel="y [km]")
    return image


def draw_slip(axes, sequence):
    """Slip every 50 years, and every 5 s of events."""
    history = sequence.history
    distance = sequence.distance / 1e3
    slip = -history.field("slip")
    for year in np.arange(0, history.time[-1] / YEAR, 50):
        k = np.searchsorted(history.time, year * YEAR)
        axes.plot(slip[k], distance, color=BLUE, linewidth=0.5)
    fast = history.rate().max(axis=1) >= SEISMIC
    last = -np.inf
    for k in np.flatnonzero(fast):
        if history.time[k] > last + 5:
            axes.plot(slip[k], distance, color=VERMILION, linewidth=0.4)
            last = history.time[k]
    axes.plot([], [], color=BLUE, linewidth=0.8, label="every 50 years")
    axes.plot([], [], color=VERMILION, linewidth=0.8, label="every 5 s of events")
    axes.set(ylim=(min(distance[-1], 30), 0), xlim=(0, None), xlabel="slip [m]",
             ylabel="down the dip [km]")
    axes.legend(loc="upper right")
    title(axes, "Slip of the hanging wall up the dip")


def draw_rate(axes, sequence):
    time = sequence.series["time"] / YEAR
    axes.semilogy(time, sequence.series["fault.max_slip_rate"], color=ORANGE,
                  linewidth=0.7)
    axes.axhline(SEISMIC, color=GREY, linewidth=0.5)
    axes.set(xlim=(0, time[-1]), xlabel="time [years]",
             ylabel="largest slip rate [m/s]")
    title(axes, "Events")


def draw(sequence):
    figure, axes = new_figure(3, height=10.0, ratios=(1.3, 1.2, 0.8))
    event = len(sequence.events["start"]) - 1
    image = draw_displacement(axes[0], sequence, event)
    figure.colorbar(image, ax=axes[0], label="uplift [m]", pad=0.01)
    title(axes[0], "Uplift in the last event")
    draw_slip(axes[1], sequence)
    draw_rate(axes[2], sequence)
    return figure
