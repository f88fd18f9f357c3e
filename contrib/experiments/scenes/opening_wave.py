# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene opening_wave.prm: gap and slip of a layer that a wave throws up, beside the
same wave under a layer that cannot come off."""

import numpy as np

from common import page
from common.figures import BLUE, GREEN, GREY, ORANGE, new_figure, title
from experiments.results.history import FaultHistory
from pictures.run_files import read_table
from pictures.style import edges

from . import cases

SCENE = "opening_wave"
FAULT = "fault"
VARIANTS = {
    "unilateral": {},
    "bilateral, normal stress as at the start": {f"Faults/{FAULT}/Contact": "bilateral"},
    "bilateral, normal stress follows": {
        f"Faults/{FAULT}/Contact": "bilateral",
        f"Faults/{FAULT}/Normal stress follows": "true",
    },
}
COLOURS = (BLUE, GREY, ORANGE)


class Wave:
    """Fields of one run over time, s, and x, m."""

    def __init__(self, run):
        history = FaultHistory(run.history(), FAULT)
        self.run = run
        self.time, self.x = history.time, history.x
        self.slip = history.field("slip")
        self.mean_slip = history.mean(self.slip)
        self.normal_stress = history.field("normal_stress")

    def remaining(self):
        """Largest slip of any node at the end, and the mean, m."""
        return np.abs(self.slip[-1]).max(), self.mean_slip[-1]


def slip_while(wave, gap):
    """Mean slip over the fault that nodes have gained between records while open at
    either end, and in all, m."""
    growth = np.diff(wave.slip, axis=0)
    is_open = (gap[1:] > 0) | (gap[:-1] > 0)
    return (growth * is_open).sum(axis=0).mean(), growth.sum(axis=0).mean()


def rows(waves):
    result = []
    for name, wave in waves.items():
        largest, mean = wave.remaining()
        result.append((
            name, f"{1e3 * largest:.3f}", f"{1e3 * mean:.3f}",
            f"{np.abs(wave.run.series()[f'{FAULT}.max_slip_rate']).max():.2f}",
        ) + cases.cost(wave.run))
    return result


def outcome(store):
    runs = {
        name: store.run(cases.case(f"{SCENE}, {name}", SCENE, settings))
        for name, settings in VARIANTS.items()
    }
    waves = {name: Wave(run) for name, run in runs.items()}
    shipped = runs["unilateral"]
    gap = FaultHistory(shipped.history(), FAULT).field("gap")
    while_open, in_all = slip_while(waves["unilateral"], gap)
    openings = read_table(shipped.files / "openings.csv")
    text = page.table(
        ("opens at, s", "closes at, s", "largest gap, mm", "at x, m",
         "most that is open, m"),
        [(f"{opens:.4f}", f"{closes:.4f}", f"{1e3 * largest:.4f}", f"{x:.1f}",
          f"{area:.1f}")
         for opens, closes, largest, x, area in zip(
             openings["opens"], openings["closes"], openings["largest_gap"],
             openings["widest_x"], openings["largest_open_area"])])
    text += (
        f"\nOf the mean slip, {1e3 * in_all:.3f} mm, {1e3 * while_open:.3f} mm are "
        f"while the sides do not touch. Energy: "
        f"{shipped.summary_number('Energy/taken by contacts'):.3g} J/m taken by "
        f"contacts, {shipped.summary_number('Energy/dissipated by friction'):.3g} J/m by "
        f"friction, {shipped.summary_number('Energy/missing'):.2g} J/m missing.\n\n"
    )
    text += page.table(
        ("contact", "largest slip that remains, mm", "mean slip, mm",
         "largest slip rate, m/s") + cases.COST_TITLES, rows(waves))
    return cases.Outcome(text, {SCENE: lambda: draw(waves, gap)})


def draw(waves, gap):
    figure, axes = new_figure(4, height=11.5, ratios=(1.2, 1.2, 1, 1))
    wave = waves["unilateral"]
    ms = 1e3 * wave.time
    shown = (ms[ms > 50][0], ms[-1])
    opened = np.ma.masked_equal(gap, 0)
    for panel, values, label, name in (
            (axes[0], 1e3 * opened, "gap [mm]", "Gap; white: the sides touch"),
            (axes[1], 1e3 * wave.slip, "slip [mm]", "Slip down the slope")):
        image = panel.pcolormesh(edges(ms), edges(wave.x), values.T, cmap="viridis",
                                 shading="flat", rasterized=True)
        panel.set(xlim=shown, xlabel="time [ms]", ylabel="x [m]")
        figure.colorbar(image, ax=panel, label=label, pad=0.01)
        title(panel, name)

    middle = int(np.argmin(np.abs(wave.x)))
    panel = axes[2]
    panel.plot(ms, 1e3 * gap[:, middle], color=GREEN, label="gap [mm]")
    panel.plot(ms, 1e3 * wave.slip[:, middle], color=BLUE, label="slip [mm]")
    panel.plot(ms, wave.normal_stress[:, middle] / 1e6, color=ORANGE, linewidth=0.8,
               label="normal stress [MPa]")
    panel.set(xlim=shown, xlabel="time [ms]")
    panel.legend(loc="upper left")
    panel.grid(alpha=0.3)
    title(panel, "In the middle")

    panel = axes[3]
    for (name, other), colour in zip(waves.items(), COLOURS):
        panel.plot(other.x, 1e3 * other.slip[-1], color=colour, label=name)
    panel.set(xlim=(wave.x[0], wave.x[-1]), ylim=(None, 3.2), xlabel="x [m]",
              ylabel="slip [mm]")
    panel.legend(loc="upper left")
    panel.grid(alpha=0.3)
    title(panel, "Slip that remains")
    return figure
