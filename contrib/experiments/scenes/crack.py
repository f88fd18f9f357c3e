# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene crack.prm: slip beside the closed form of a shear crack in plane strain
(Starr 1928), and on meshes of different fineness."""

import numpy as np

from common import page
from common.figures import (
    BLUE, GREEN, GREY, ORANGE, VERMILION, new_figure, title,
)
from experiments.results.history import FaultHistory

from . import cases

SCENE = "crack"
HALF_LENGTH = 1000.0
POISSON_RATIO = 0.25
SHEAR_MODULUS = 75e9 / (2 * (1 + POISSON_RATIO))
STRENGTH = 0.6 * 50e6
# Pa at the start and Pa/s.
SHEAR, SHEAR_RATE = 29e6, 1e-14 * SHEAR_MODULUS
# Each halves all cells; without any those at the fault are of 25 m.
REFINEMENTS = (0, 1, 2, 3)
SHIPPED = 2
YEAR = 3.15576e7


def stress_drop(time):
    return np.maximum(SHEAR + SHEAR_RATE * time - STRENGTH, 0)


def exact_slip(x, time):
    """2 (1 - nu) / G stress drop sqrt(a^2 - x^2)."""
    return (
        2 * (1 - POISSON_RATIO) / SHEAR_MODULUS * stress_drop(time)
        * np.sqrt(np.maximum(HALF_LENGTH**2 - x**2, 0))
    )


def settings(refinements):
    if refinements == SHIPPED:
        return {}
    return {"Bodies/rock/Uniform refinements": refinements}


def errors(run):
    """At the centre, and in the mean square over the largest slip, at the end."""
    history = FaultHistory(run.history(), "fault")
    exact = exact_slip(history.x, history.time[-1])
    difference = history.field("slip")[-1] - exact
    centre = history.node(0.0)
    square = np.sqrt(history.mean(difference**2)) / exact.max()
    return difference[centre] / exact[centre], square


def outcome(store):
    runs = {
        refinements: store.run(cases.case(
            f"{SCENE}, {refinements} refinements", SCENE, settings(refinements)))
        for refinements in REFINEMENTS
    }
    found = {refinements: errors(run) for refinements, run in runs.items()}
    rows = []
    for refinements, (centre, square) in found.items():
        order = "–"
        if refinements - 1 in found:
            order = f"{np.log2(found[refinements - 1][1] / square):.2f}"
        rows.append((
            f"a/{40 * 2**refinements}", f"{25 * 0.5**refinements:g}",
            f"{100 * centre:.2f} %", f"{100 * square:.2f} %", order,
            f"{runs[refinements].series()['tnnmg_iterations'].mean():.2f}",
            f"{runs[refinements].cpu_seconds:.0f}",
        ))
    text = page.table(
        ("cells at the fault", "m", "error of the slip at the centre",
         "mean square over the largest slip", "order", "TNNMG iterations a step",
         "CPU seconds"), rows)
    return cases.Outcome(text, {SCENE: lambda: draw(runs, found)})


def draw(runs, found):
    figure, axes = new_figure(2, height=7.0)
    history = FaultHistory(runs[SHIPPED].history(), "fault")
    x = np.linspace(-HALF_LENGTH, HALF_LENGTH, 1001)
    for years, colour in ((150, BLUE), (250, GREEN), (350, ORANGE), (420, VERMILION)):
        k = int(np.argmin(np.abs(history.time - years * YEAR)))
        time = history.time[k]
        axes[0].plot(x, 1e3 * exact_slip(x, time), color=GREY, linewidth=1)
        axes[0].plot(
            history.x[::8], 1e3 * history.field("slip")[k, ::8], ".", color=colour,
            label=f"{time / YEAR:.0f} years, {stress_drop(time) / 1e6:.2f} MPa")
    axes[0].set(xlabel="x [m]", ylabel="slip [mm]")
    axes[0].legend(loc="upper right")
    title(axes[0], "Slip at four times, and the closed form (lines)")

    sizes = np.array([25 * 0.5**refinements for refinements in found])
    for index, colour, label in ((0, BLUE, "at the centre"), (1, ORANGE, "mean square")):
        axes[1].loglog(
            sizes, [abs(100 * found[p][index]) for p in found], "o-", color=colour,
            label=label)
    axes[1].loglog(sizes, sizes / 12, color=GREY, linewidth=0.8, label="first order")
    axes[1].set(xlabel="cells at the fault [m]", ylabel="error of the slip [%]")
    axes[1].legend(loc="upper left")
    axes[1].grid(alpha=0.3)
    title(axes[1], "Errors over the size of cells; the fault is 2 km long")
    return figure
