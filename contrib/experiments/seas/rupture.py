# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Ruptures of a fault in three dimensions: moments, arrival times, pictures."""

import dataclasses

import h5py
import numpy as np

from common import figures
from experiments.seas import stations
from experiments.seas.benchmarks import SHORTEST_INTERVAL, THRESHOLD, YEAR

RIGIDITY = 2670. * 3464.**2
# Frictional part, along strike from the middle and in depth, m.
HALF_LENGTH, DEPTH = 50e3, 40e3


@dataclasses.dataclass
class GridHistory:
    """Records of the frictional part: values by time, strike and depth."""

    time: np.ndarray
    # m.
    strike: np.ndarray
    depth: np.ndarray
    # m, m/s, Pa, of the component along strike.
    slip: np.ndarray
    rate: np.ndarray
    traction: np.ndarray


def read(folder):
    with h5py.File(folder / "faults.h5") as file:
        fault = file["fault"]
        x, y = fault["coordinates"][:, 0], fault["coordinates"][:, 1]
        inside = np.flatnonzero((np.abs(x) < HALF_LENGTH + 1.) & (y < DEPTH + 1.))
        order = inside[np.lexsort((y[inside], x[inside]))]
        strike, depth = np.unique(x[order].round(3)), np.unique(y[order].round(3))
        time = fault["time"][:] if "time" in fault else file["time"][:]

        def values(name):
            field = fault[name][:].reshape(len(time), len(x), -1)
            return field[:, order, 0].reshape(len(time), len(strike), len(depth))

        return GridHistory(time, strike, depth, values("slip"),
                           np.abs(values("slip_rate")), values("shear_traction"))


def spans(history):
    """First and last record of each event."""
    fast = history.rate.max(axis=(1, 2)) > THRESHOLD
    result = []
    for i in np.flatnonzero(fast):
        if result and history.time[i] - history.time[result[-1][1]] < SHORTEST_INTERVAL:
            result[-1][1] = i
        else:
            result.append([i, i])
    return result


def integral(history, values):
    """Over the frictional part."""
    def weights(places):
        return np.gradient(places) * np.r_[0.5, np.ones(len(places) - 2), 0.5]

    return weights(history.strike) @ values @ weights(history.depth)


def show(history):
    """A table of the events."""
    print("event   start, yr   duration, s   moment, N m   magnitude   largest slip, m   "
          "area, km^2   mean stress drop there, MPa")
    for number, (first, last) in enumerate(spans(history), 1):
        before = max(first - 1, 0)
        slip = history.slip[last] - history.slip[before]
        drop = history.traction[before] - history.traction[last]
        ruptured = (history.rate[first:last + 1].max(axis=0) > THRESHOLD).astype(float)
        area = integral(history, ruptured)
        moment = RIGIDITY * integral(history, slip)
        print(f"{number:5d}   {history.time[first] / YEAR:9.2f}   "
              f"{history.time[last] - history.time[first]:11.1f}   {moment:11.3e}   "
              f"{(np.log10(moment) - 9.1) / 1.5:9.2f}   {slip.max():15.2f}   "
              f"{area / 1e6:10.0f}   {integral(history, drop * ruptured) / area / 1e6:12.2f}")


def arrival_times(history, first, last):
    """When each node first passes the threshold in an event, s after its first record;
    nan where it does not."""
    log_rate = np.log(np.maximum(history.rate[first:last + 1], 1e-30))
    above = log_rate > np.log(THRESHOLD)
    index = above.argmax(axis=0)
    time = history.time[first:last + 1] - history.time[first]
    result = time[index].astype(float)
    result[~above.any(axis=0)] = np.nan
    for i, j in zip(*np.nonzero(index > 0)):
        k = index[i, j]
        part = ((np.log(THRESHOLD) - log_rate[k - 1, i, j])
                / (log_rate[k, i, j] - log_rate[k - 1, i, j]))
        result[i, j] = time[k - 1] + part * (time[k] - time[k - 1])
    return result


def show_arrivals(history):
    """Arrival times of the first event along strike and along depth."""
    events = spans(history)
    if not events:
        return
    arrival = arrival_times(history, *events[0])

    def at(x, y):
        return arrival[np.abs(history.strike - x).argmin(),
                       np.abs(history.depth - y).argmin()]

    print("Arrival of the first rupture, s, at 10 km of depth, by km along strike:")
    print("  ".join(f"{x / 1e3:g}: {at(x, 10e3):.1f}" for x in np.arange(-32e3, 33e3, 8e3)))
    print("in the middle of the fault, by km of depth:")
    print("  ".join(f"{y / 1e3:g}: {at(0., y):.1f}" for y in np.arange(0., 21e3, 4e3)))


def draw(folder, sequence, history):
    figure, axes = figures.new_figure(5, height=13.)
    axes[0].semilogy(sequence.time / YEAR, sequence.rate, lw=0.7, color=figures.BLUE)
    axes[0].axhline(THRESHOLD, lw=0.5, color=figures.GREY)
    axes[0].set(xlabel="time [yr]", ylabel="largest slip rate [m/s]")
    events = spans(history)
    if events:
        contours = axes[1].contour(history.strike / 1e3, history.depth / 1e3,
                                   arrival_times(history, *events[0]).T,
                                   levels=np.arange(0., 200., 5.), linewidths=0.8)
        axes[1].clabel(contours, contours.levels[::2], fontsize=7)
    axes[1].invert_yaxis()
    axes[1].set(xlabel="along strike [km]", ylabel="depth [km]",
                title="arrival of the first rupture [s]")
    in_event = np.zeros(len(history.time), bool)
    for first, last in events:
        in_event[first:last + 1] = True
    cuts = ((axes[2], history.strike, history.slip[:, :, np.abs(history.depth - 10e3).argmin()],
             "along strike at 10 km of depth [km]"),
            (axes[3], history.depth, history.slip[:, np.abs(history.strike).argmin(), :],
             "depth in the middle of the fault [km]"))
    for frame, places, slip, label in cuts:
        last = {True: -np.inf, False: -np.inf}
        for i, time in enumerate(history.time):
            fast = bool(in_event[i])
            if time - last[fast] < (2. if fast else 9.9 * YEAR):
                continue
            last[fast] = time
            frame.plot(places / 1e3, slip[i], lw=0.4,
                       color=figures.VERMILION if fast else figures.BLUE)
        frame.set(xlabel=label, ylabel="slip [m]")
    axes[2].set(title="slip every 10 yr (blue) and every 2 s of events (red)")
    stations.draw(axes[4], "bp5", folder)
    return figure
