# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Figures of doc/results.md."""

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.ticker import MaxNLocator

from common.figures import (
    BLACK, BLUE, GREEN, GREY, ORANGE, VERMILION, new_figure, title,
)

from . import ruptures, statistics
from .history import FaultHistory

# s: all figures of whole runs have one axis of time.
END = 60.0
# Rates below this are not told apart: such a fault is stuck.
SMALLEST = 1e-16


def heading(run):
    """The title of a run as that of a panel."""
    text = run.case.title
    return text[0].upper() + text[1:]


def draw_rates(axes, run, fault, limits):
    """Largest and mean slip rate of a fault over time."""
    series = run.series()
    axes.semilogy(series["time"], series[f"{fault}.max_slip_rate"], color=ORANGE,
                  linewidth=0.5, label="largest", rasterized=True)
    axes.semilogy(series["time"], series[f"{fault}.mean_slip_rate"], color=BLUE,
                  linewidth=0.6, label="mean", rasterized=True)
    axes.set_ylim(*limits)
    axes.set_ylabel("slip rate [m/s]")
    axes.grid(alpha=0.3)
    axes.set_xlim(0, END)


def slip_rates(slider, layered):
    """All faults of both experiments, one below the other."""
    names = layered.case.faults()[::-1]
    figure, panels = new_figure(1 + len(names), height=9.5, sharex=True)
    fault = slider.case.top_fault()
    draw_rates(panels[0], slider, fault, (1e-14, 1))
    title(panels[0], f"{heading(slider)}: {len(slider.events(fault)['start'])} events")
    panels[0].legend(loc="lower right", ncol=2)
    words = ("uppermost", "upper intermediate", "lower intermediate", "lowest")
    for axes, name, word in zip(panels[1:], names, words):
        top = float(layered.series()[f"{name}.max_slip_rate"].max())
        limits = (1e-14, 1) if name == names[0] else (1e-22, max(1e-8, 10 * top))
        draw_rates(axes, layered, name, limits)
        events = len(layered.events(name)["start"])
        title(axes, f"{heading(layered)}, {name} ({word}): {events} events")
    panels[-1].set_xlabel("time [s]")
    return figure


def binned(time, values, limits, bins):
    """The largest value in each of equal bins of time; empty ones repeat the last."""
    edges = np.linspace(*limits, bins + 1)
    index = np.clip(np.searchsorted(edges, time, side="right") - 1, 0, bins - 1)
    inside = (time >= limits[0]) & (time <= limits[1])
    result = np.full((bins, values.shape[1]), -np.inf)
    np.maximum.at(result, index[inside], values[inside])
    for k in range(1, bins):
        if not np.isfinite(result[k, 0]):
            result[k] = result[k - 1]
    result[~np.isfinite(result)] = SMALLEST
    return edges, result


def node_edges(x):
    middle = (x[1:] + x[:-1]) / 2
    return np.concatenate(([x[0]], middle, [x[-1]]))


def draw_map(figure, axes, history, limits, colours, bins=800, bar=True):
    """Slip rate over time and position."""
    edges, rate = binned(history.time, history.rate(), limits, bins)
    image = axes.pcolormesh(
        edges, node_edges(history.x), np.clip(rate.T, *colours),
        norm=LogNorm(*colours), cmap="viridis", rasterized=True,
    )
    axes.set_ylabel("x [m]")
    axes.set_xlim(*limits)
    if bar:
        figure.colorbar(image, ax=axes, pad=0.01, label="slip rate [m/s]")


def maps(slider, layered):
    """Slip rate along all faults of both experiments."""
    names = layered.case.faults()[::-1]
    figure, panels = new_figure(1 + len(names), height=10.0, sharex=True)
    for axes, run, name in zip(
        panels, (slider, *[layered] * len(names)), (slider.case.top_fault(), *names)
    ):
        history = FaultHistory(run.history(), name)
        top = float(np.quantile(history.rate().max(axis=1), 0.999))
        colours = (1e-12, 1e-1) if top > 1e-4 else (top * 1e-10, top)
        draw_map(figure, axes, history, (0, run.end()), colours)
        axes.set_xlim(0, END)
        title(axes, heading(run) + (f", {name}" if run is layered else ""))
    panels[-1].set_xlabel("time [s]")
    return figure


def steps(slider, layered):
    """Step sizes and iterations of both experiments, one beside the other."""
    figure, panels = new_figure(3, 2, height=6.5, sharex=True, sharey="row")
    for column, run in zip(panels.T, (slider, layered)):
        name = heading(run)
        series = run.series()
        time = series["time"]
        column[0].semilogy(time, series["step_size"], color=BLUE, linewidth=0.5,
                           rasterized=True)
        title(column[0], f"{name}, each step")
        column[0].set_ylabel("step size [s]")
        column[1].plot(time, series["rate_state_iterations"], ".", color=GREEN,
                       markersize=2, rasterized=True)
        column[1].set_ylabel("fixed-point iterations")
        column[2].plot(time, series["multigrid_cycles"], ".", color=VERMILION,
                       markersize=2, rasterized=True)
        column[2].set_ylabel("multigrid cycles")
        column[2].set_xlabel("time [s]")
        for axes in column:
            axes.grid(alpha=0.3)
    panels[0][0].set_xlim(0, max(slider.end(), layered.end()))
    for row in panels:
        row[1].set_ylabel("")
    for row in panels[1:]:
        row[0].set_ylim(bottom=0)
        row[0].yaxis.set_major_locator(MaxNLocator(integer=True))
    return figure


def draw_event(figure, axes, run, fault, event, before, after, bar):
    """One event with the times at which the front passes."""
    history = FaultHistory(run.history(), fault)
    start, end = event["start"], event["end"]
    limits = (start - before, end + after)
    draw_map(figure, axes, history, limits, (1e-6, 3e-2), 500, bar)
    passage = ruptures.first_passage(
        history, history.rate(), limits[0], end, ruptures.FRONT_RATE
    )
    axes.plot(passage, history.x, color="white", linewidth=1.0)
    axes.set_xlabel("time [s]")


def node_rates(axes, run, fault, limits):
    """Largest and mean rate around an event, with the threshold of events."""
    series = run.series()
    chosen = (series["time"] >= limits[0]) & (series["time"] <= limits[1])
    for name, colour, label in (
        ("max", ORANGE, "largest"), ("mean", BLUE, "mean")
    ):
        axes.semilogy(series["time"][chosen],
                      series[f"{fault}.{name}_slip_rate"][chosen],
                      color=colour, linewidth=0.9, label=label)
    axes.axhline(ruptures.EVENT_RATE, color=GREY, linestyle=":", linewidth=1,
                 label="threshold of events")
    axes.set_xlim(*limits)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip rate [m/s]")
    axes.grid(alpha=0.3)


def events(chosen):
    """Chosen events in space and time, and the rates from one event to the next:
    chosen holds (title, run, fault, index of the event)."""
    figure, panels = new_figure(3, len(chosen), height=8.5, squeeze=False)
    figure.set_figwidth(3.7 * len(chosen))
    for column, (name, run, fault, index) in zip(panels.T, chosen):
        all_events = run.events(fault)
        event = {key: values[index] for key, values in all_events.items()}
        last = column[0] is panels[0][-1]
        draw_event(figure, column[0], run, fault, event, 0.15, 0.05, last)
        title(column[0], f"{name}, event {index + 1}")
        draw_event(figure, column[1], run, fault, event, 1.0, 0.8, last)
        title(column[1], "before and after it")
        limits = cycle_limits(all_events, index)
        node_rates(column[2], run, fault, limits)
        title(column[2], "from the event before to the one after")
    for row in panels:
        for axes in row[1:]:
            axes.set_ylabel("")
    panels[2][-1].legend(loc="upper center", fontsize=7)
    return figure


def cycle_limits(all_events, index):
    starts, ends = all_events["start"], all_events["end"]
    first = starts[max(index - 1, 0)] - 0.1
    last = ends[min(index + 1, len(ends) - 1)]
    return first, last + 0.1


def histograms(slider, layered):
    """How many steps took how many iterations, in both experiments."""
    figure, panels = new_figure(1, 2, height=2.8)
    for axes, name in zip(panels, ("rate_state_iterations", "multigrid_cycles")):
        for run, colour, label, shift in (
            (slider, BLUE, "spring slider", -0.2), (layered, VERMILION, "five bodies", 0.2)
        ):
            counts = statistics.histogram(run.series()[name])
            axes.bar(np.array(list(counts)) + shift, list(counts.values()), width=0.4,
                     color=colour, label=label)
        axes.set_yscale("log")
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        axes.set_ylabel("share of the steps")
        axes.set_xlabel(name.replace("rate_state", "fixed-point").replace("_", " ")
                        + " per step")
        axes.grid(alpha=0.3)
    panels[0].legend()
    return figure


def inner(scene, results, limits):
    """Computed slip rates of the lower faults beside what follows from the slip of
    the top fault alone, over a window of time."""
    figure, panels = new_figure(len(results) + 1, height=8.5, sharex=True)
    for axes, result in zip(panels, results):
        chosen = (result["time"] >= limits[0]) & (result["time"] <= limits[1])
        for name, colour, label, width in (
            ("rate", BLACK, "computed", 1.0),
            ("block_rate", VERMILION, "block that slips at fault4 only", 0.7),
        ):
            axes.plot(result["time"][chosen], result[name][chosen], color=colour,
                      linewidth=width, label=label)
        axes.set_ylabel("log10 of slip rate")
        title(axes, f"Five bodies, {scene}: {result['fault']}")
        axes.grid(alpha=0.3)
    panels[0].legend(loc="lower right", ncol=3, fontsize=7)
    for result, colour in zip(results, (BLUE, GREEN, ORANGE)):
        chosen = (result["time"] >= limits[0]) & (result["time"] <= limits[1])
        panels[-1].plot(result["time"][chosen], result["traction"][chosen] / 1e3,
                        color=colour, linewidth=0.8, label=result["fault"])
    panels[-1].set_ylabel("kPa")
    title(panels[-1], "Mean shear traction")
    panels[-1].legend(loc="lower right", ncol=3)
    panels[-1].set_xlabel("time [s]")
    panels[-1].grid(alpha=0.3)
    return figure


def spectra(panels_of, resonances):
    """Spectra of the mean tractions, one panel for each run: panels_of holds (title,
    factor on the resonances, {fault: (frequency, power)})."""
    figure, panels = new_figure(len(panels_of), height=2.9 * len(panels_of),
                                squeeze=False)
    colours = (VERMILION, BLUE, GREEN, ORANGE)
    for axes, (name, factor, lines) in zip(panels[:, 0], panels_of):
        for resonance in resonances:
            line = axes.axvline(
                factor * resonance, color=GREY, linestyle=":", linewidth=1
            )
        line.set_label("block, all faults locked")
        for (fault, (frequency, power)), colour in zip(lines.items(), colours):
            axes.semilogy(frequency, power, color=colour, linewidth=0.9, label=fault)
        axes.set_xlim(0, max(frequency[-1] for frequency, _ in lines.values()))
        axes.set_ylabel("Pa²/Hz")
        axes.grid(alpha=0.3)
        title(axes, name if factor == 1 else f"{name}; frequencies of the block x {factor:g}")
    panels[0][0].legend(loc="upper right", ncol=5, fontsize=7)
    panels[-1][0].set_xlabel("frequency [Hz]")
    return figure
