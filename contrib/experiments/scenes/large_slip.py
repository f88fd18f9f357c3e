# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene large_slip.prm: contact pressure, drag and events over a whole wave."""

import numpy as np
from matplotlib.collections import PolyCollection

from common import page
from common.figures import (
    BLUE, GREY, ORANGE, VERMILION, new_figure, title,
)
from experiments.results.history import FaultHistory
from pictures.style import edges

from . import cases
from .volume import Volume, volumes
from .wavy import Waves

SCENE = "large_slip"
LENGTH, THICKNESS, DENSITY, GRAVITY = 5.0, 1.0, 5e3, 9.81
MODULUS, RATIO = 4.12e6, 0.3
WAVE, AMPLITUDE = 1.25, 2.5e-3
NORMAL_STRESS = DENSITY * GRAVITY * THICKNESS
FAULT = "fault"
# Parts of the wave, at which pressures are compared and between which events are
# counted, and those at which bodies are drawn.
PARTS = (0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875)
QUARTERS = (0, 0.25, 0.5, 0.75, 1.0)
SHOWN = (0.5, 1.0)


class Pressure:
    """Contact pressure at the nodes of the upper side over the slip."""

    def __init__(self, run):
        history = FaultHistory(run.history(), FAULT)
        self.x = history.x
        self.slip = history.mean(history.field("slip"))
        self.values = history.field("normal_stress")
        self.mean = history.mean(self.values)
        k = 2 * np.pi / WAVE
        weight = history.weight / history.weight.sum()
        self.wave = 2 * self.values @ (weight * np.exp(-1j * k * self.x))

    def at(self, part):
        """Index of the record next to a part of the wave."""
        return int(np.argmin(np.abs(self.slip - part * WAVE)))


def theory():
    return Waves([(2 * np.pi / WAVE, AMPLITUDE, 0.0)], MODULUS, RATIO, THICKNESS)


def pressure_rows(pressure):
    waves = theory()
    rows = []
    for part in PARTS:
        k = pressure.at(part)
        expected = waves.pressure(np.linspace(0, WAVE, 200), pressure.slip[k]).max()
        rows.append((
            f"{pressure.slip[k]:.3f}", f"{abs(pressure.wave[k]) / 1e3:.2f}",
            f"{expected / 1e3:.2f}",
            f"{pressure.mean[k] / NORMAL_STRESS:.5f}",
            f"{pressure.values[k].min() / 1e3:.1f}",
            f"{pressure.values[k].max() / 1e3:.1f}",
        ))
    return page.table(
        ("slip, m", "wave of the normal stress, kPa", "half spaces, kPa",
         "mean over the weight", "least, kPa", "largest, kPa"), rows)


def event_rows(run):
    """Events of the quarters of a wave."""
    events, series = run.events(FAULT), run.series()
    slip = np.interp(events["start"], series["time"], series[f"{FAULT}.mean_slip"])
    rows = []
    for first, last in zip(QUARTERS[:-1], QUARTERS[1:]):
        own = (slip >= first * WAVE) & (slip < last * WAVE) & (events["start"] > 2)
        inside = (series[f"{FAULT}.mean_slip"] >= first * WAVE) & (
            series[f"{FAULT}.mean_slip"] < last * WAVE) & (series["time"] > 2)
        time = series["time"][inside]
        mean = np.trapz(series[f"{FAULT}.mean_shear_traction"][inside], time)
        mean /= np.ptp(time)
        rows.append((
            f"{first * WAVE:.2f} to {last * WAVE:.2f}", own.sum(),
            f"{np.ptp(time) / max(own.sum(), 1):.2f}",
            f"{100 * np.median(events['mean_slip'][own]):.1f}",
            f"{np.median(events['peak_mean_slip_rate'][own]):.2f}",
            f"{events['peak_slip_rate'][own].max():.1f}",
            f"{mean / NORMAL_STRESS:.3f}",
        ))
    return rows


def outcome(store):
    shipped = store.run(cases.case("large slip", SCENE))
    pressure = Pressure(shipped)
    gap = shipped.series()[f"{FAULT}.largest_gap"][-1]
    text = (
        f"Mappings: {shipped.summary_number('Steps/contact mappings built'):.0f} in "
        f"{pressure.slip[-1]:.2f} m of slip; largest gap "
        f"{1e6 * gap:.2f} µm, {gap / AMPLITUDE:.2g} of the amplitude. Energy: "
        f"{shipped.summary_number('Energy/added by new contact mappings'):.3g} J/m "
        "added by mappings, "
        f"{shipped.summary_number('Energy/missing'):.2g} J/m missing, "
        f"{shipped.summary_number('Energy/missing, over the largest work'):.2g} of the "
        f"largest work.\n\n" + pressure_rows(pressure) + "\n"
        + page.table(
            ("slip, m", "events", "from one to the next, s", "slip, cm",
             "largest mean slip rate, m/s", "of a node", "mean drag over the weight"),
            event_rows(shipped))
        + "\n" + page.table(cases.COST_TITLES, [cases.cost(shipped)])
    )
    return cases.Outcome(text, {"large_slip": lambda: draw(shipped, pressure)})


def draw_bodies(axes, path, limits):
    """Deformed cells, coloured by the normal stress on horizontal planes; what the
    upper body has slid is drawn as far as the period goes."""
    volume = Volume(path)
    # Corners are written row by row.
    ring = [0, 1, 3, 2] if is_row_by_row(volume) else [0, 1, 2, 3]
    corners = (volume.points + volume.displacement())[:, ring]
    stress = -volume.field("stress_yy").mean(axis=1) / 1e3
    for shift in (-LENGTH, 0):
        image = axes.add_collection(PolyCollection(
            corners + (shift, 0), array=stress, cmap="viridis", edgecolors="face",
            linewidths=0.2))
        image.set_clim(*limits)
    axes.set(xlim=(-2.5, 2.5), ylim=(-1.0, 1.0), aspect="equal", ylabel="y [m]")
    return image


def is_row_by_row(volume):
    first = volume.points[0]
    return bool(np.isclose(first[2, 0], first[0, 0]))


def draw(shipped, pressure):
    figure, axes = new_figure(5, height=12.0, ratios=(1.6, 1.6, 1.2, 1.0, 1.0))
    time, paths = volumes(shipped.files)
    series = shipped.series()
    slip_then = np.interp(time, series["time"], series[f"{FAULT}.mean_slip"])
    for panel, part in zip(axes, SHOWN):
        k = int(np.argmin(np.abs(slip_then - part * WAVE)))
        image = draw_bodies(panel, paths[k], (0, 100))
        title(panel, f"Slid by {slip_then[k]:.2f} m")
    axes[1].set_xlabel("x [m]")
    figure.colorbar(image, ax=list(axes[:2]), label="vertical pressure [kPa]",
                    shrink=0.6, pad=0.01)

    panel = axes[2]
    every = np.unique(np.searchsorted(
        np.maximum.accumulate(pressure.slip), np.linspace(0, pressure.slip[-1], 400)
    ).clip(0, len(pressure.slip) - 1))
    image = panel.pcolormesh(
        edges(pressure.slip[every]), edges(pressure.x), pressure.values[every].T / 1e3,
        cmap="viridis", shading="flat", rasterized=True)
    events = shipped.events(FAULT)
    panel.plot(np.interp(events["start"], series["time"],
                         series[f"{FAULT}.mean_slip"]), events["nucleation_x"], "o",
               color=VERMILION, markersize=3)
    panel.set(xlim=(0, pressure.slip[-1]), ylim=(-2.5, 2.5), xlabel="slip [m]",
              ylabel="x of the upper side [m]")
    figure.colorbar(image, ax=panel, label="normal stress [kPa]", pad=0.01)
    title(panel, "Normal stress along the upper side; dots: where events begin")

    panel = axes[3]
    slips = np.linspace(0, pressure.slip[-1], 300)
    waves = theory()
    expected = [waves.pressure(np.linspace(0, WAVE, 200), s).max() for s in slips]
    panel.plot(slips, np.array(expected) / 1e3, color=GREY, linewidth=3,
               label="layers pressed together (closed form)")
    panel.plot(pressure.slip[every], np.abs(pressure.wave[every]) / 1e3, ".",
               color=BLUE, markersize=3, label="in the run")
    panel.set(xlim=(0, pressure.slip[-1]), ylim=(0, None), xlabel="slip [m]",
              ylabel="amplitude [kPa]")
    panel.legend(loc="lower center")
    panel.grid(alpha=0.3)
    title(panel, "Wave of the normal stress")

    panel = axes[4]
    some = slice(None, None, 10)
    for name, colour in (("max", ORANGE), ("mean", BLUE)):
        panel.semilogy(series[f"{FAULT}.mean_slip"][some],
                       series[f"{FAULT}.{name}_slip_rate"][some], color=colour,
                       linewidth=0.5, rasterized=True,
                       label="fastest node" if name == "max" else "mean")
    panel.set(xlim=(0, pressure.slip[-1]), ylim=(1e-5, 10), xlabel="slip [m]",
              ylabel="slip rate [m/s]")
    panel.legend(loc="lower left", ncol=2)
    title(panel, "Events")
    return figure
