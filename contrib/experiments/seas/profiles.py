# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Faults in two dimensions: values by time and distance down the dip, their files in the
form of the benchmarks, and their figure."""

import dataclasses

import h5py
import numpy as np
from matplotlib.colors import LogNorm

from common import figures
from experiments.seas import stations
from experiments.seas.benchmarks import THRESHOLD, YEAR


@dataclasses.dataclass
class History:
    """Records of the frictional part of a fault: values by time and distance."""

    time: np.ndarray
    # Down the dip, m.
    distance: np.ndarray
    # slip, slip_rate, shear_traction, normal_stress, as far as they are there.
    fields: dict


def read_fault(folder, slope):
    """The fault of a run; slope is the distance down the dip over the depth."""
    with h5py.File(folder / "faults.h5") as file:
        fault = file["fault"]
        coordinates = fault["coordinates"][:]
        if coordinates.shape[1] > 1 and np.ptp(coordinates[:, 1]) > 0.:
            distance = -coordinates[:, 1] * slope
        else:
            distance = coordinates[:, 0]
        order = np.argsort(distance)
        order = order[distance[order] < 40e3 + 1.]
        time = fault["time"][:] if "time" in fault else file["time"][:]
        names = ["slip", "slip_rate", "shear_traction", "normal_stress"]
        fields = {name: fault[name][:].reshape(len(time), -1)[:, order]
                  for name in names if name in fault}
    return History(time, distance[order], fields)


def chosen(history):
    """Records every 5 yr between events and every second of them."""
    fastest = np.abs(history.fields["slip_rate"]).max(axis=1)
    last = {True: -np.inf, False: -np.inf}
    for i, (t, v) in enumerate(zip(history.time, fastest)):
        is_fast = bool(v > THRESHOLD)
        if t - last[is_fast] >= (1. if is_fast else 4.9 * YEAR):
            last[is_fast] = t
            yield i, is_fast, v


def write(folder, history):
    """Values every 500 m, in the form of the benchmarks."""
    positions = np.arange(0., 40e3 + 1., 500.)
    for field, title, unit in (("slip", "slip", 1.),
                               ("shear_traction", "shear_stress", 1e6),
                               ("normal_stress", "normal_stress", 1e6)):
        if field not in history.fields:
            continue
        with open(folder / f"{title}.dat", "w") as file:
            line = " ".join(f"{x:.6E}" for x in positions)
            file.write(f"{0.:.13E} {0.:.6E} {line}\n")
            for i, _, rate in chosen(history):
                values = np.interp(positions, history.distance, history.fields[field][i])
                line = " ".join(f"{x / unit:.6E}" for x in values)
                file.write(f"{history.time[i]:.13E} {np.log10(rate):.6E} {line}\n")


def draw_slip(axes, history):
    for i, is_fast, _ in chosen(history):
        axes.plot(np.abs(history.fields["slip"][i]), history.distance / 1e3, lw=0.4,
                  color=figures.VERMILION if is_fast else figures.BLUE)
    axes.invert_yaxis()
    axes.set(xlabel="slip [m]; every 5 yr (blue) and every second of events (red)",
             ylabel="distance down\nthe fault [km]")


def draw_rates(figure, axes, history):
    """Slip rates over distance and records, which are dense in events: over time these
    would be lines. Ticks are at the onsets of events and say when that is."""
    rate = np.abs(history.fields["slip_rate"])
    image = axes.pcolormesh(
        np.arange(len(history.time) + 1), figures.edges(history.distance / 1e3),
        np.clip(rate, 1e-12, 1e1).T, norm=LogNorm(1e-12, 1e1), cmap="viridis",
        shading="flat", rasterized=True)
    axes.invert_yaxis()
    fast = rate.max(axis=1) > THRESHOLD
    onsets, last = [], -np.inf
    for i in np.flatnonzero(fast[1:] & ~fast[:-1]) + 1:
        if history.time[i] - last > YEAR:
            onsets.append(i)
        last = history.time[i]
    axes.set_xticks(onsets, [f"{history.time[i] / YEAR:.0f}" for i in onsets])
    axes.set(xlabel="records; onset of events [yr]", ylabel="distance down\nthe fault [km]")
    figure.colorbar(image, ax=axes, label="slip rate [m/s]", pad=0.01)


def draw(name, folder, sequence, history):
    """Largest slip rate, slip, slip rates, and stations."""
    figure, axes = figures.new_figure(4, height=11.)
    axes[0].semilogy(sequence.time / YEAR, sequence.rate, lw=0.7, color=figures.BLUE)
    axes[0].axhline(THRESHOLD, lw=0.5, color=figures.GREY)
    axes[0].set(xlabel="time [yr]", ylabel="largest\nslip rate [m/s]")
    draw_slip(axes[1], history)
    draw_rates(figure, axes[2], history)
    stations.draw(axes[3], name, folder)
    return figure
