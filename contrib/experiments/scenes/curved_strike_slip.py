# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene curved_strike_slip.prm: stresses along the bend, and events."""

import h5py
import numpy as np

from common import page
from common.figures import BLUE, GREY, ORANGE, VERMILION, new_figure, title

from . import cases

SCENE = "curved_strike_slip"
YEAR = 3.15576e7
# Pa: sxx, syy, sxy of the background.
BACKGROUND = (-60e6, -50e6, 29e6)


def trace(x):
    """The second coordinate of the fault, m, and its slope."""
    return 2e3 * np.tanh(x / 8e3), 0.25 / np.cosh(x / 8e3) ** 2


def resolved(x):
    """Normal stress and shear traction of the background along the trace, Pa."""
    slope = trace(x)[1]
    length = np.hypot(1, slope)
    n, t = (-slope / length, 1 / length), (1 / length, slope / length)
    sxx, syy, sxy = BACKGROUND
    traction = (sxx * n[0] + sxy * n[1], sxy * n[0] + syy * n[1])
    return (-(traction[0] * n[0] + traction[1] * n[1]),
            traction[0] * t[0] + traction[1] * t[1])


class Fault:
    """Fields of the nodes in contact; components along strike and dip."""

    def __init__(self, run):
        with h5py.File(run.history(), "r") as file:
            group = file["fault"]
            weight = np.array(group["weight"]).ravel()
            chosen = weight > 0
            self.time = np.array(group["time"]).ravel()
            self.points = np.array(group["coordinates"])[chosen]
            self.slip = np.array(group["slip"])[: len(self.time), chosen]
            self.rate = np.array(group["slip_rate"])[: len(self.time), chosen]
            self.normal_stress = np.array(group["normal_stress"])[0].ravel()[chosen]
            self.shear = np.array(group["shear_traction"])[0][chosen]
        # Arc length along the trace from the middle, m.
        x = np.linspace(-30e3, 30e3, 6001)
        arc = np.concatenate([[0], np.cumsum(np.hypot(1, trace(x)[1])[1:] * 10)])
        self.along = np.interp(self.points[:, 0], x, arc - arc[3000])

    def at(self, time):
        return int(np.argmin(np.abs(self.time - time)))


def largest_event(run):
    """Its times of start and end, s."""
    events = run.events("fault")
    k = int(np.nanargmax(events["mean_slip"]))
    return events["start"][k], events["end"][k]


def outcome(store):
    run = store.run(cases.case(SCENE, SCENE))
    fault, events = Fault(run), run.events("fault")
    normal, shear = resolved(fault.points[:, 0])
    rows = [
        (str(k + 1), f"{events['start'][k] / YEAR:.1f}",
         f"{events['peak_slip_rate'][k]:.3g}", f"{events['mean_slip'][k]:.3f}",
         f"{events['nucleation_x'][k] / 1e3:.1f}")
        for k in range(len(events["start"]))
    ]
    text = (
        "Normal stress at the start: "
        f"{fault.normal_stress.min() / 1e6:.1f} to {fault.normal_stress.max() / 1e6:.1f} "
        f"MPa; largest departure from that of the curve "
        f"{np.abs(fault.normal_stress - normal).max() / 1e6:.2f} MPa, of the shear "
        f"traction {np.abs(fault.shear[:, 0] - shear).max() / 1e6:.2f} MPa.\n\n"
        + page.table(
            ("event", "start, years", "largest slip rate, m/s", "mean slip, m",
             "begins at x, km"), rows)
        + "\n" + page.table(cases.COST_TITLES, [cases.cost(run)])
    )
    return cases.Outcome(text, {SCENE: lambda: draw(run, fault)})


def draw(run, fault):
    figure, axes = new_figure(4, height=11.0, ratios=(1, 1, 1, 1))
    x = np.linspace(-30e3, 30e3, 601)
    normal, shear = resolved(x)
    surface = fault.points[:, 2] > -1.0
    order = np.argsort(fault.points[surface, 0])
    for curve, values, colour, label in (
            (normal, fault.normal_stress, BLUE, "normal stress"),
            (shear, fault.shear[:, 0], ORANGE, "shear traction")):
        axes[0].plot(x / 1e3, curve / 1e6, color=GREY, linewidth=1)
        axes[0].plot(fault.points[surface, 0][order] / 1e3,
                     values[surface][order] / 1e6, ".", color=colour, label=label)
    axes[0].set(xlabel="x [km]", ylabel="at the start [MPa]")
    axes[0].legend(loc="center left")
    title(axes[0], "The background stress resolved on the fault, and closed form (lines)")

    series = run.series()
    axes[1].semilogy(series["time"] / YEAR, series["fault.max_slip_rate"],
                     color=VERMILION, linewidth=0.8, label="largest")
    axes[1].semilogy(series["time"] / YEAR, series["fault.mean_slip_rate"], color=BLUE,
                     linewidth=0.8, label="mean")
    axes[1].set(xlabel="time [years]", ylabel="slip rate [m/s]")
    axes[1].legend(loc="upper left")
    title(axes[1], "Slip rates")

    start, end = largest_event(run)
    before = fault.slip[fault.at(start)]
    draw_map(figure, axes[2], fault, before[:, 0], "slip [m]")
    title(axes[2], f"Slip along strike before the event after {start / YEAR:.0f} years")
    draw_map(figure, axes[3], fault, (fault.slip[fault.at(end)] - before)[:, 0],
             "slip [m]")
    title(axes[3], "Slip along strike of this event")
    return figure


def draw_map(figure, axes, fault, values, label):
    mesh = axes.tripcolor(fault.along / 1e3, fault.points[:, 2] / 1e3, values,
                          shading="gouraud", cmap="viridis")
    axes.set(xlabel="along the trace [km]", ylabel="z [km]", aspect="equal")
    figure.colorbar(mesh, ax=axes, label=label)
