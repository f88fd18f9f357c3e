# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scenes lifted_patch.prm and lifted_corner.prm: how much of a heavy slab comes off
the floor, beside the theory of beams."""

import h5py
import numpy as np
from matplotlib.tri import Triangulation

from common import page
from common.figures import (
    BLUE, GREEN, GREY, ORANGE, VERMILION, new_figure, title,
)
from experiments.results.history import FaultHistory

from . import cases

PATCH, CORNER = "lifted_patch", "lifted_corner"
FAULT = "bed"
THICKNESS, MODULUS, RATIO = 1.0, 1e10, 0.25
# Pa.
WEIGHT = 2500 * 9.81 * THICKNESS
# Of a plate, N m.
STIFFNESS = MODULUS * THICKNESS**3 / (12 * (1 - RATIO**2))
# m: over which shear bends a beam of rectangular section that is held down, the root of
# its stiffness against bending over that against shear, 5/6 G h.
SHEAR_LENGTH = THICKNESS * np.sqrt(2 * (1 + RATIO) / (10 * (1 - RATIO**2)))


class Slab:
    """A slab of 24 m whose end is lifted: m, s."""

    LENGTH, LIFT, HALF_TIME = 24.0, 0.02, 100.0

    @staticmethod
    def lift(time):
        return 0.5 * Slab.LIFT * (1 - np.cos(np.pi * time / Slab.HALF_TIME))


def euler_length(lift):
    return (24 * STIFFNESS * lift / WEIGHT) ** 0.25


def force_with_shear(length):
    """Over the weight, m. Where the beam touches, its rotation decays over the
    shear length, and its moment with it."""
    return length * (length / 2 + SHEAR_LENGTH) / (length + SHEAR_LENGTH)


def lift_with_shear(length):
    force, square = force_with_shear(length), SHEAR_LENGTH**2
    bending = square * (length - force) * length + force * length**3 / 3 - length**4 / 8
    return WEIGHT / STIFFNESS * (
        bending + square * (force * length - length**2 / 2))


def length_with_shear(lift):
    lengths = np.linspace(1e-3, 24, 20001)
    return np.interp(lift, lift_with_shear(lengths), lengths)


def work_with_shear(lift):
    """J/m, from the floor to a lift."""
    lifts = np.linspace(0, lift, 20001)
    return np.trapz(WEIGHT * force_with_shear(length_with_shear(lifts)), lifts)


def open_lengths(history):
    """From the end that is lifted to halfway between the last node that is open and
    the first one that is not, m, at each record."""
    is_open = history.field("gap") > 0
    between = np.append(history.x[0], 0.5 * (history.x[1:] + history.x[:-1]))
    first = np.argmax(is_open, axis=1)
    return np.where(is_open.any(axis=1), Slab.LENGTH - between[first], 0)


def work_of_lifting(history):
    """Of the force at the end, which is the weight that the floor does not carry, from
    the floor to the largest lift, J/m."""
    force = WEIGHT * Slab.LENGTH - history.field("normal_stress") @ history.weight
    rising = history.time <= Slab.HALF_TIME
    return np.trapz(force[rising], Slab.lift(history.time[rising]))


def patch(store):
    shipped = store.run(cases.case(PATCH, PATCH))
    history = FaultHistory(shipped.history(), FAULT)
    lengths = open_lengths(history)
    rows = []
    for time in (20, 35, 50, 70, 100, 130, 150, 165, 180):
        k = int(np.argmin(np.abs(history.time - time)))
        lift = Slab.lift(history.time[k])
        rows.append((
            f"{history.time[k]:.1f}", f"{1e3 * lift:.2f}", f"{lengths[k]:.2f}",
            f"{length_with_shear(lift):.2f}", f"{euler_length(lift):.2f}"))
    friction = "Energy/dissipated by friction"
    work = "Energy/work of driven sides"
    text = page.table(
        ("time, s", "lift, mm", "open length, m", "beam with shear, m",
         "beam without, m"), rows)
    text += (
        f"\nLifting takes {work_of_lifting(history):.0f} J/m, of a beam "
        f"{work_with_shear(Slab.LIFT):.0f} J/m with shear and "
        f"{0.4 * WEIGHT * euler_length(Slab.LIFT) * Slab.LIFT:.0f} J/m without; lifting "
        f"and letting down {shipped.summary_number(work):.1f} J/m, of which friction "
        f"takes {shipped.summary_number(friction):.1f} J/m and contact "
        f"{shipped.summary_number('Energy/taken by contacts'):.1g} J/m; "
        f"{shipped.summary_number('Energy/missing'):.2g} J/m are missing. Largest gap at "
        f"the end: {history.field('gap')[-1].max():g} m.\n\n")
    text += page.table(cases.COST_TITLES, [cases.cost(shipped)])
    return cases.Outcome(text, {PATCH: lambda: draw_patch(history, lengths)})


def draw_patch(history, lengths):
    figure, axes = new_figure(3, height=9.0)
    gap = history.field("gap")
    for time, colour in ((20, BLUE), (35, GREEN), (50, ORANGE), (100, VERMILION)):
        k = int(np.argmin(np.abs(history.time - time)))
        lift = Slab.lift(history.time[k])
        axes[0].plot(history.x, 1e3 * gap[k], color=colour,
                     label=f"lifted by {1e3 * lift:.1f} mm")
        axes[0].plot(Slab.LENGTH - euler_length(lift), 0, "|", color=colour,
                     markersize=12)
    axes[0].set(xlim=(8, Slab.LENGTH), xlabel="x [m]", ylabel="gap [mm]")
    axes[0].legend(loc="upper left")
    title(axes[0], "Gap below the slab; ticks: where a beam without shear comes off")

    lifts = np.linspace(0, Slab.LIFT, 400)
    rising = history.time <= Slab.HALF_TIME
    lift = Slab.lift(history.time)
    axes[1].plot(1e3 * lifts, euler_length(lifts), "--", color=GREY, linewidth=1,
                 label="beam without shear")
    axes[1].plot(1e3 * lifts, length_with_shear(lifts), color=GREY, linewidth=1,
                 label="beam with shear")
    axes[1].plot(1e3 * lift[rising], lengths[rising], ".", color=BLUE, markersize=3,
                 label="lifted")
    axes[1].plot(1e3 * lift[~rising], lengths[~rising], ".", color=ORANGE, markersize=3,
                 label="let down")
    axes[1].set(xlabel="lift of the end [mm]", ylabel="open length [m]")
    axes[1].legend(loc="lower right")
    title(axes[1], "Open length")

    slip = history.field("slip")
    for time, colour in ((50, BLUE), (100, VERMILION), (150, ORANGE), (200, GREEN)):
        k = int(np.argmin(np.abs(history.time - time)))
        axes[2].plot(history.x, 1e3 * slip[k], color=colour, label=f"{time} s")
    axes[2].set(xlim=(8, Slab.LENGTH), xlabel="x [m]", ylabel="slip [mm]")
    axes[2].legend(loc="upper left")
    title(axes[2], "Slip of the slab's lower side, on the floor and above it")
    return figure


class Corner:
    """A slab of 8 m x 8 m, pulled at a square metre of its corner: m, N, s."""

    SIDE, PULL, END = 8.0, 2.5e5, 100.0
    # Distance of the pull's centre from the corner.
    ARM = np.sqrt(0.5)

    @staticmethod
    def pull(time):
        return Corner.PULL * np.sin(np.pi * time / Corner.END) ** 2


def corner_pull(length):
    """The pull that lifts a triangle whose height, from the corner, is this: it
    balances the moment of the weight about the line that touches, w l^3 / 3."""
    return WEIGHT * length**3 / (3 * (length - Corner.ARM))


def corner_length(pull):
    lengths = np.linspace(1.5 * Corner.ARM, 12, 20001)
    return np.interp(pull, corner_pull(lengths), lengths)


def corner_gap(pull, distances):
    """Gap at distances from the corner along the diagonal: a beam whose width at the
    distance s is 2 s."""
    length = corner_length(pull)
    s = np.linspace(length, 1e-6, 20001)
    moment = pull * np.maximum(s - Corner.ARM, 0) - WEIGHT * s**3 / 3
    step = s[0] - s[1]
    slope = np.cumsum(moment / (2 * STIFFNESS * s)) * step
    return np.interp(distances, s[::-1], (np.cumsum(slope) * step)[::-1])


class Bed:
    """Gaps of the nodes of the fault in three dimensions."""

    def __init__(self, run):
        with h5py.File(run.history(), "r") as file:
            group = file[FAULT]
            self.time = np.array(group["time"]).ravel()
            self.points = np.array(group["coordinates"])[:, :2]
            self.gap = np.array(group["gap"]).reshape(-1, len(self.points))
        on_diagonal = np.flatnonzero(
            np.isclose(self.points[:, 0], self.points[:, 1]))
        self.distance = np.sqrt(2) * (Corner.SIDE - self.points[on_diagonal, 0])
        order = np.argsort(self.distance)
        self.diagonal, self.distance = on_diagonal[order], self.distance[order]

    def at(self, time):
        return int(np.argmin(np.abs(self.time - time)))

    def length(self, k):
        """Open part of the diagonal at a record, m."""
        is_open = self.gap[k, self.diagonal] > 0
        if not is_open.any():
            return 0.0
        last = np.flatnonzero(is_open)[-1]
        return 0.5 * (self.distance[last] + self.distance[last + 1])


def corner(store):
    run = store.run(cases.case(CORNER, CORNER))
    bed = Bed(run)
    rows = []
    for time in (20, 30, 40, 50, 60, 70, 80):
        k = bed.at(time)
        pull = Corner.pull(bed.time[k])
        rows.append((
            f"{bed.time[k]:.0f}", f"{pull / 1e3:.0f}", f"{bed.length(k):.2f}",
            f"{corner_length(pull):.2f}",
            f"{1e3 * bed.gap[k, bed.diagonal[0]]:.3f}",
            f"{1e3 * corner_gap(pull, 0):.3f}"))
    text = page.table(
        ("time, s", "pull, kN", "open along the diagonal, m", "beam, m",
         "gap at the corner, mm", "beam, mm"), rows)
    text += (
        f"\nEnergy: {run.summary_number('Energy/dissipated by friction'):.3g} J taken by "
        f"friction, {run.summary_number('Energy/taken by contacts'):.1g} J by contacts, "
        f"{run.summary_number('Energy/missing'):.2g} J missing. Largest gap at the end: "
        f"{bed.gap[-1].max():g} m. Unknowns: "
        f"{run.summary_number('Unknowns/not fixed'):,.0f}.\n\n")
    text += page.table(cases.COST_TITLES, [cases.cost(run)])
    return cases.Outcome(text, {CORNER: lambda: draw_corner(bed)})


def draw_corner(bed):
    figure, axes = new_figure(1, 3, height=3.6)
    mesh = Triangulation(bed.points[:, 0], bed.points[:, 1])
    largest = 1e3 * bed.gap.max()
    for panel, time in zip(axes, (30, 50)):
        gap = 1e3 * bed.gap[bed.at(time)]
        image = panel.tripcolor(mesh, np.ma.masked_equal(gap, 0).filled(0), vmin=0,
                                vmax=largest, cmap="viridis", shading="gouraud",
                                rasterized=True)
        touching = gap == 0
        panel.plot(*bed.points[touching].T, ".", color="white", markersize=1.2)
        panel.set(xlim=(0, Corner.SIDE), ylim=(0, Corner.SIDE), aspect="equal",
                  xlabel="x [m]", ylabel="y [m]")
        pull = Corner.pull(bed.time[bed.at(time)])
        title(panel, f"Pulled with {pull / 1e3:.0f} kN")
    figure.colorbar(image, ax=list(axes[:2]), label="gap [mm]; dots: touching",
                    shrink=0.8, pad=0.01)
    panel = axes[2]
    for time, colour in ((30, BLUE), (50, VERMILION)):
        k = bed.at(time)
        pull = Corner.pull(bed.time[k])
        s = np.linspace(0, 8, 400)
        panel.plot(s, 1e3 * np.where(s < corner_length(pull), corner_gap(pull, s), 0),
                   color=GREY, linewidth=1)
        panel.plot(bed.distance, 1e3 * bed.gap[k, bed.diagonal], ".", color=colour,
                   label=f"{pull / 1e3:.0f} kN")
    panel.set(xlim=(0, 8), xlabel="distance from the corner [m]", ylabel="gap [mm]")
    panel.legend(loc="upper right")
    title(panel, "Along the diagonal")
    return figure
