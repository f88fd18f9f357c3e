# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene large_slip.prm: forces, slip and events over the overlap."""

import h5py
import numpy as np
from matplotlib.collections import PolyCollection

from common import page
from common.figures import (
    BLUE, GREY, ORANGE, VERMILION, new_figure, title,
)

from . import cases
from .volume import Volume, volumes

SCENE = "large_slip"
WIDTH, THICKNESS, DENSITY, GRAVITY = 5.0, 1.0, 5e3, 9.81
WEIGHT = DENSITY * GRAVITY * WIDTH * THICKNESS
NORMAL_STRESS = DENSITY * GRAVITY * THICKNESS
RADIATION_DAMPING = np.sqrt(DENSITY * 4.12e6 / (2 * 1.3)) / 2
LOWER = 0
# Overlap, as parts of the length, at which bodies are drawn and events are counted.
SHOWN = (1.0, 0.84, 0.68, 0.52)
PARTS = ((1.0, 0.875), (0.875, 0.75), (0.75, 0.625), (0.625, 0.5))
# s: a run with a record of each step.
EACH_STEP_END = 20.0


def transmitted(volume):
    """Normal and shear force that pass from the upper to the lower body, in N/m.

    The lowest row of cells carries what is above it: with test functions that rise
    linearly from 0 to 1 over the row, the mean stress in each cell is all that is
    needed, and the balance is that of the discrete equations.
    """
    width, height = volume.sizes()
    bottom = volume.points[..., 1].min()
    row = (volume.body == LOWER) & (
        np.abs(volume.points[..., 1].min(axis=1) - bottom) < 1e-6)
    if np.ptp(height[row]) > 1e-6:
        raise ValueError("The lowest row has cells of different heights.")
    normal, shear = (
        (volume.field(name)[row].mean(axis=1) * width[row]).sum()
        for name in ("stress_yy", "stress_xy")
    )
    own = DENSITY * GRAVITY * WIDTH * (THICKNESS - height[row][0] / 2)
    return -normal - own, shear


def contact_side(volume):
    """Position, width and mean normal stress (compression positive) of the cells of
    the lower body at the fault."""
    top = volume.points[volume.body == LOWER][..., 1].max()
    row = (volume.body == LOWER) & (
        np.abs(volume.points[..., 1].max(axis=1) - top) < 1e-6)
    x = volume.points[row][..., 0].mean(axis=1)
    order = np.argsort(x)
    return (
        x[order], volume.sizes()[0][row][order],
        -volume.field("stress_yy")[row].mean(axis=1)[order],
    )


class Sides:
    """The two sides of the fault where they are now."""

    def __init__(self, volume):
        place = volume.points + volume.displacement()
        at_fault = np.abs(volume.points[..., 1]) < 1e-6
        self.lower, self.upper = (
            self.sorted(place[at_fault & (volume.body == body)[:, None]])
            for body in (LOWER, 1 - LOWER)
        )

    @staticmethod
    def sorted(points):
        return points[np.argsort(points[:, 0], kind="stable")]

    def ends(self):
        return self.upper[0, 0], self.lower[-1, 0]

    def overlap(self):
        left, right = self.ends()
        return right - left

    def largest_gap(self):
        """Between the deformed sides, in m: how far they are from touching."""
        x = np.linspace(*self.ends(), 200)
        return np.abs(
            np.interp(x, *self.upper.T) - np.interp(x, *self.lower.T)).max()

    def deflection(self):
        """Of the lower side, from its highest to its lowest point."""
        return np.ptp(self.lower[:, 1])


class Forces:
    """Over all VTU files of a run: overlap, and forces between the bodies."""

    def __init__(self, run):
        series = run.series()
        self.time, self.paths = volumes(run.files)
        volumes_now = [Volume(path) for path in self.paths]
        self.overlap = np.array([Sides(volume).overlap() for volume in volumes_now])
        both = np.array([transmitted(volume) for volume in volumes_now])
        self.normal, self.shear = both.T
        traction, rate = (
            np.interp(self.time, series["time"], series[f"fault.mean_{name}"])
            for name in ("shear_traction", "slip_rate")
        )
        self.friction = (traction + RADIATION_DAMPING * rate) * self.overlap

    def overlap_at(self, time):
        return np.interp(time, self.time, self.overlap)

    def at(self, part):
        """Index of the file with an overlap next to a part of the length."""
        return int(np.argmin(np.abs(self.overlap - part * WIDTH)))


def jumps(run):
    """From a run with a record of each step: how far slip departs from the mean of the
    old and the new slip rate times the step, the largest slip in a step, steps."""
    with h5py.File(run.history(), "r") as file:
        group = file["fault"]
        time = np.array(group["time"]).ravel()
        slip, rate, stress = (
            np.array(group[name]).reshape(len(time), -1)
            for name in ("slip", "slip_rate", "normal_stress")
        )
    inside = (stress[1:] > 0) & (stress[:-1] > 0)
    expected = np.diff(time)[:, None] * (rate[1:] + rate[:-1]) / 2
    left = np.where(inside, np.abs(np.diff(slip, axis=0) - expected), 0.0)
    largest = np.where(inside, np.abs(np.diff(slip, axis=0)), 0.0).max()
    left_contact = int((stress[0] > 0).sum() - (stress[-1] > 0).sum())
    return left.max(), largest, len(time) - 1, left_contact


def event_rows(run, forces):
    events = run.events("fault")
    series = run.series()
    overlap = forces.overlap_at(series["time"])
    rows = []
    for upper, lower in PARTS:
        inside = (overlap <= upper * WIDTH) & (overlap > lower * WIDTH) & (
            series["time"] > 2)
        window = series["time"][inside][[0, -1]]
        own = (events["start"] >= window[0]) & (events["start"] < window[1])
        large = own & (events["mean_slip"] > 0.01)
        traction = series["fault.mean_shear_traction"][inside]
        mean = np.trapz(traction * overlap[inside], series["time"][inside]) / np.ptp(
            window)
        rows.append((
            f"{WIDTH * upper:.2f} to {WIDTH * lower:.2f}", own.sum(), large.sum(),
            f"{np.median(np.diff(events['start'][large])):.2f}",
            f"{100 * np.median(events['mean_slip'][large]):.1f}",
            f"{np.median(events['peak_mean_slip_rate'][large]):.2f}",
            f"{events['peak_slip_rate'][own].max():.1f}",
            f"{mean / 1e3:.1f}", f"{mean / WEIGHT:.3f}",
        ))
    return page.table(
        ("overlap, m", "events", "of these with more than 1 cm of slip",
         "from one to the next, s", "slip, cm", "largest mean slip rate, m/s",
         "of a node", "mean drag, kN/m", "over the weight"), rows)


def force_rows(forces):
    rows = []
    for part in SHOWN:
        k = forces.at(part)
        volume = Volume(forces.paths[k])
        x, width, stress = contact_side(volume)
        sides = Sides(volume)
        inside = x > WIDTH / 2 - forces.overlap[k]
        pulled = width[inside & (stress < 0)].sum()
        rows.append((
            f"{forces.overlap[k]:.2f}", f"{forces.time[k]:.1f}",
            f"{forces.normal[k] / WEIGHT:.6f}",
            f"{WEIGHT / forces.overlap[k] / 1e3:.1f}",
            f"{stress[inside].max() / 1e3:.0f}", f"{pulled:.2f}",
            f"{NORMAL_STRESS * forces.overlap[k] / WEIGHT:.3f}",
            f"{forces.shear[k] / 1e3:.1f}", f"{forces.friction[k] / 1e3:.1f}",
            f"{100 * sides.deflection():.1f}", f"{100 * sides.largest_gap():.1f}",
        ))
    return page.table(
        ("overlap, m", "time, s", "contact force over weight",
         "weight over overlap, kPa", "largest normal stress in a cell, kPa",
         "under tension, m", "normal force in the friction law over weight",
         "shear force below, kN/m", "friction and damping, kN/m",
         "deflection of the lower side, cm", "largest gap between the sides, cm"), rows)


def outcome(store):
    shipped = store.run(cases.case("large slip", SCENE))
    each_step = store.run(cases.case(
        "large slip, a record of each step", SCENE,
        {"Time/End time": f"{EACH_STEP_END:g}", "Output/Write volume": "false",
         "Output/Fault shortest interval": "0",
         "Output/Fault longest interval": "1e-9"}))
    moving = store.run(cases.case(
        "large slip with inertia", SCENE, {"Time/Inertia": "dynamic"}))
    swing = Forces(moving).normal / WEIGHT
    forces = Forces(shipped)
    ratio = forces.normal / WEIGHT
    left, largest, steps, lost = jumps(each_step)
    text = (
        f"Contact force over weight in {len(ratio)} files: {ratio.min():.6f} to "
        f"{ratio.max():.6f}; with inertia {swing.min():.3f} to {swing.max():.3f}, mean "
        f"{swing.mean():.4f}, in {len(moving.events('fault')['start'])} events. Mappings: {shipped.summary_number('Steps/contact mappings built'):.0f}"
        f" in {shipped.series()['fault.mean_slip'][-1]:.2f} m of slip. Energy: "
        f"{shipped.summary_number('Energy/missing'):.3g} J/m missing, "
        f"{shipped.summary_number('Energy/missing, over the largest work'):.2g} of the "
        f"largest work, {shipped.summary_number('Energy/dissipated by friction'):.3g} "
        f"J/m dissipated by friction.\n\nTo {EACH_STEP_END:g} s: "
        f"{each_step.summary_number('Steps/contact mappings built'):.0f} mappings in "
        f"{steps} steps, {lost} nodes leave the contact; slip departs from the mean "
        f"slip rate times the step by at most {left:.2g} m; largest slip of a node in a "
        f"step {largest:.2g} m.\n\n"
        + force_rows(forces) + "\n" + event_rows(shipped, forces) + "\n"
        + page.table(cases.COST_TITLES, [cases.cost(shipped)])
    )
    return cases.Outcome(text, {"large_slip": lambda: draw(shipped, forces)})


def draw_bodies(axes, path, limits):
    """Deformed cells, coloured by the normal stress on horizontal planes."""
    volume = Volume(path)
    # Corners are written row by row.
    ring = [0, 1, 3, 2] if is_row_by_row(volume) else [0, 1, 2, 3]
    corners = (volume.points + volume.displacement())[:, ring]
    stress = -volume.field("stress_yy").mean(axis=1) / 1e3
    image = axes.add_collection(PolyCollection(
        corners, array=stress, cmap="RdBu_r", edgecolors="face", linewidths=0.2))
    image.set_clim(*limits)
    axes.set(xlim=(-2.7, 5.2), ylim=(-1.1, 1.1), aspect="equal", ylabel="y [m]")
    return image


def is_row_by_row(volume):
    first = volume.points[0]
    return bool(np.isclose(first[2, 0], first[0, 0]))


def draw(shipped, forces):
    figure, axes = new_figure(6, height=12.0, ratios=(1.5, 1.5, 1.5, 1.5, 1.2, 1.2))
    for panel, part in zip(axes, SHOWN):
        k = forces.at(part)
        image = draw_bodies(panel, forces.paths[k], (-200, 200))
        title(panel, f"t = {forces.time[k]:.1f} s, overlap {forces.overlap[k]:.2f} m")
    axes[3].set_xlabel("x [m]")
    figure.colorbar(image, ax=list(axes[:4]), label="vertical pressure [kPa]",
                    shrink=0.5, pad=0.01)

    panel = axes[4]
    panel.plot(forces.overlap, forces.normal / WEIGHT, ".", color=BLUE,
               markersize=4, label="contact force, from the stresses")
    panel.plot(forces.overlap, NORMAL_STRESS * forces.overlap / WEIGHT, color=GREY,
               label="normal force in the friction law")
    series = shipped.series()
    overlap = forces.overlap_at(series["time"])
    every = slice(None, None, 20)
    panel.plot(overlap[every], (series["fault.mean_shear_traction"] * overlap)[every]
               / WEIGHT, color=VERMILION, linewidth=0.4, label="friction",
               rasterized=True)
    panel.set(xlim=(5, 2.6), ylim=(0, 1.15), xlabel="overlap [m]",
              ylabel="force / weight")
    panel.legend(loc="lower left", ncol=3)
    panel.grid(alpha=0.3)
    title(panel, "Forces between the bodies")

    panel = axes[5]
    panel.semilogy(overlap[every], series["fault.max_slip_rate"][every], color=ORANGE,
                   linewidth=0.4, label="largest", rasterized=True)
    panel.semilogy(overlap[every], series["fault.mean_slip_rate"][every], color=BLUE,
                   linewidth=0.4, label="mean", rasterized=True)
    panel.set(xlim=(5, 2.6), ylim=(1e-6, 10), xlabel="overlap [m]",
              ylabel="slip rate [m/s]")
    panel.legend(loc="lower left", ncol=2)
    title(panel, "Events")
    return figure
