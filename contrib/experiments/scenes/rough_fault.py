# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene rough_fault.prm: contact pressure, drag and energy of a self-similar
profile, beside the sum of its waves."""

import numpy as np

from common import page
from common.figures import BLUE, GREY, ORANGE, VERMILION, new_figure, title
from experiments.results.history import FaultHistory
from tools import rough_profile
from pictures.style import edges

from . import cases
from .wavy import Waves

SCENE = "rough_fault"
FAULT = "fault"
LENGTH, WAVES, SEED, THICKNESS = 4.0, 12, 1, 2.0
MODULUS, POISSON = 4.12e6, 0.3
NORMAL_STRESS = 2.5e3 * 9.81 * THICKNESS
FRICTION = 0.6
RATIOS = (1e-3, 1e-2)
# m, at which the table compares.
SLIPS = (0.05, 0.1, 0.2, 0.5, 1.0)


def theory(ratio):
    return Waves(
        [(k, ratio * amplitude, phase)
         for k, amplitude, phase in rough_profile.waves(LENGTH, WAVES, SEED)],
        MODULUS, POISSON, THICKNESS)


class Result:
    """Of a run: contact pressure of the nodes, friction, energy over the slip."""

    def __init__(self, run, ratio):
        self.run, self.ratio, self.theory = run, ratio, theory(ratio)
        history = FaultHistory(run.history(), FAULT)
        self.x = history.x
        self.slip = history.mean(history.field("slip"))
        self.pressure = history.field("contact_pressure")
        self.friction = history.mean(history.field("shear_traction"))
        weight = history.weight / history.weight.sum()
        self.tension = (self.pressure < 0) @ weight
        self.roughness = np.sqrt(
            ((self.pressure - NORMAL_STRESS) ** 2) @ weight)
        series = run.series()
        self.gap = series[f"{FAULT}.largest_gap"].max()

    def at(self, slip):
        return int(np.argmin(np.abs(self.slip - slip)))

    def expected(self, slip):
        """Root of the mean square of the change of the pressure, and the largest
        difference of the run from it, Pa."""
        k = self.at(slip)
        wanted = self.theory.pressure(self.x, self.slip[k])
        return np.sqrt(np.mean(wanted**2)), np.sqrt(
            np.mean((self.pressure[k] - NORMAL_STRESS - wanted) ** 2))


def rows(result):
    for slip in SLIPS:
        k = result.at(slip)
        expected, difference = result.expected(slip)
        yield (
            f"{result.ratio:g}", f"{result.slip[k]:.3f}",
            f"{result.roughness[k] / 1e3:.2f}", f"{expected / 1e3:.2f}",
            f"{100 * difference / expected:.1f} %",
            f"{100 * result.tension[k]:.0f} %",
            f"{result.friction[k] / NORMAL_STRESS:.4f}",
            f"{result.theory.drag(result.slip[k]) / NORMAL_STRESS:.4f}",
            f"{result.theory.energy(result.slip[k]):.3g}",
        )


def outcome(store):
    profile = [LENGTH, WAVES, SEED]
    results = []
    for ratio in RATIOS:
        settings = {} if ratio == RATIOS[0] else {
            "Faults/fault/Elevation": rough_profile.expression(ratio, *profile)}
        results.append(Result(
            store.run(cases.case(f"rough fault, {ratio:g}", SCENE, settings)), ratio))
    table = page.table(
        ("amplitude over length", "slip, m", "roughness of the contact pressure, kPa",
         "sum of waves, kPa", "difference", "of the fault under tension",
         "friction over the weight", "drag of the waves over the weight",
         "energy of the waves, J/m^2"),
        [row for result in results for row in rows(result)])
    gaps = "; ".join(
        f"{result.gap:.2g} m with {result.ratio:g}" for result in results)
    mappings = results[0].run.summary_number("Steps/contact mappings built")
    text = (
        f"Mappings: {mappings:.0f} in {results[0].slip[-1]:.2f} m of slip. Largest "
        f"gap: {gaps}. Roughness is the root of the mean square.\n\n" + table
        + "\n" + page.table(
            cases.COST_TITLES, [cases.cost(result.run) for result in results]))
    return cases.Outcome(text, {"rough_fault": lambda: draw(results)})


def draw(results):
    figure, axes = new_figure(5, height=12.0, ratios=(0.7, 1.2, 1.2, 1, 1))
    x = np.linspace(0, LENGTH, 1000)
    first = results[0].theory
    profile = (first.amplitude * np.sin(np.outer(x, first.k) + first.phase)).sum(1)
    axes[0].plot(x, 1e3 * profile, color=GREY)
    axes[0].set(xlim=(0, LENGTH), ylabel="elevation [mm]")
    title(axes[0], f"The profile, {results[0].ratio:g}")

    for panel, result, limit in zip(axes[1:3], results, (150, 1500)):
        image = panel.pcolormesh(
            edges(result.slip), edges(result.x), result.pressure.T / 1e3,
            cmap="RdBu_r", shading="flat", rasterized=True, vmin=-limit, vmax=limit)
        panel.set(xlim=(0, result.slip[-1]), ylim=(0, LENGTH), xlabel="slip [m]",
                  ylabel="x of the upper side [m]")
        figure.colorbar(image, ax=panel, label="contact pressure [kPa]", pad=0.01)
        title(panel, f"Contact pressure, {result.ratio:g}: blue is held together")

    for result, colour in zip(results, (BLUE, VERMILION)):
        axes[3].loglog(
            result.slip, result.roughness / 1e3, ".", color=colour, markersize=3,
            label=f"{result.ratio:g}")
        slips = np.geomspace(2e-3, result.slip[-1], 200)
        axes[3].loglog(
            slips, [np.sqrt(np.mean(result.theory.pressure(x, s) ** 2)) / 1e3
                    for s in slips], color=GREY, linewidth=1)
        axes[4].plot(result.slip, result.friction / NORMAL_STRESS, color=colour,
                     label=f"friction, {result.ratio:g}")
        axes[4].plot(
            result.slip, result.theory.drag(result.slip) / NORMAL_STRESS,
            color=colour, linestyle="--", label=f"drag of the waves, {result.ratio:g}")
    axes[3].axhline(NORMAL_STRESS / 1e3, color=ORANGE, linewidth=0.8,
                    label="weight")
    axes[3].set(xlim=(2e-3, 1), xlabel="slip [m]", ylabel="rms change [kPa]")
    axes[3].legend(loc="lower right", ncol=3)
    axes[3].grid(alpha=0.3)
    title(axes[3], "Roughness of the contact pressure (grey: sum of the waves)")
    axes[4].set(xlim=(0, results[0].slip[-1]), xlabel="slip [m]",
                ylabel="over the weight")
    axes[4].legend(loc="center right", ncol=2)
    axes[4].grid(alpha=0.3)
    title(axes[4], "Resistance")
    return figure
