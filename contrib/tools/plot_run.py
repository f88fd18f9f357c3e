#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Draw a run: slip rates over time and space, step sizes and iterations.

Usage: plot_run.py OUTPUT_DIRECTORY [-o FIGURE] [--fault NAME] [--event N]

Reads time_series.csv, events.csv and faults.h5 of a run and draws

- the largest and the mean slip rate of one fault over time, with its events,
- its slip rate over position and time, for the whole run,
- the same, from shortly before to shortly after one event,
- step sizes, and the iterations that each step took.

The fault is the one with most events, the event the one in the middle of them,
unless chosen. In three dimensions the position is that along x. Files of a run
that has not ended, or has no events, are drawn as far as they go.
"""

import argparse
import csv
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

# Okabe and Ito's colours, which the colour-blind can tell apart.
BLUE, ORANGE, GREEN, VERMILION, GREY = (
    "#0072b2", "#e69f00", "#009e73", "#d55e00", "#777777"
)


class RunError(Exception):
    """A file of the run is missing or is not what it should be."""


def read_table(path):
    """The columns of a CSV file by name; numbers where they are numbers."""
    if not path.is_file():
        raise RunError(f"There is no file {path}.")
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    if not rows:
        raise RunError(f"{path} is empty.")
    names, rows = rows[0], [row for row in rows[1:] if len(row) == len(rows[0])]
    table = {}
    for column, name in enumerate(names):
        values = [row[column] for row in rows]
        table[name] = np.array(
            values if name == "fault" else [float(v or "nan") for v in values],
            dtype=str if name == "fault" else float,
        )
    return table


def read_fault(path, name):
    """Position, time and |slip rate| (time x nodes) of one fault."""
    if not path.is_file():
        raise RunError(f"There is no file {path}.")
    with h5py.File(path, "r") as file:
        if name not in file:
            raise RunError(f"{path} holds no fault {name}.")
        group = file[name]
        if "slip_rate" not in group:
            raise RunError(
                f"{path} holds no slip_rate; 'Output/Fault fields' must list it."
            )
        x = np.array(group["coordinates"])
        time = np.array(group["time"]).ravel()
        rate = np.abs(np.array(group["slip_rate"]))
    if x.ndim == 2:
        x = x[:, 0]
    if rate.ndim == 3:
        rate = np.linalg.norm(rate, axis=2)
    records = min(len(time), len(rate))
    time, rate = time[:records], rate[:records]
    order = np.argsort(x, kind="stable")
    x, rate = x[order], rate[:, order]
    # Nodes with the same x, a line across the fault: the fastest stands for it.
    x, first = np.unique(x, return_index=True)
    return x, time, np.maximum.reduceat(rate, first, axis=1)


def edges(centres):
    """Limits of the cells around the given points."""
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middle = (centres[1:] + centres[:-1]) / 2
    return np.concatenate(([centres[0]], middle, [centres[-1]]))


def choose_fault(series, events, wanted):
    faults = [
        name[: -len(".max_slip_rate")]
        for name in series
        if name.endswith(".max_slip_rate")
    ]
    if not faults:
        raise RunError("time_series.csv has no column of slip rates.")
    if wanted is not None:
        if wanted not in faults:
            raise RunError(f"No fault {wanted}; there are {', '.join(faults)}.")
        return wanted
    # On a tie the topmost fault: the one nearest to the usual loading.
    return max(
        reversed(faults), key=lambda name: int(np.sum(events["fault"] == name))
    )


def draw_slip_rates(axis, series, fault, own_events):
    t = series["time"]
    axis.semilogy(t, series[f"{fault}.max_slip_rate"], color=VERMILION,
                  linewidth=0.9, label="largest")
    axis.semilogy(t, series[f"{fault}.mean_slip_rate"], color=BLUE,
                  linewidth=0.9, label="mean")
    axis.plot(own_events["peak_time"], own_events["peak_mean_slip_rate"], "o",
              color="black", markersize=3, linestyle="none",
              label=f"{len(own_events['start'])} events")
    top = np.nanmax(series[f"{fault}.max_slip_rate"], initial=1e-12)
    axis.set_ylim(1e-14, max(10 * top, 1e-12))
    axis.set_ylabel("slip rate [m/s]")
    axis.set_title(f"Slip rate of {fault}", loc="left")
    axis.legend(loc="lower right", ncol=3)
    axis.grid(alpha=0.3)


def draw_map(figure, axis, x, time, rate, limits, title):
    chosen = (time >= limits[0]) & (time <= limits[1])
    if chosen.sum() < 2 or len(x) < 2:
        axis.text(0.5, 0.5, "no records", transform=axis.transAxes,
                  ha="center", va="center")
        axis.set_title(title, loc="left")
        return
    time, rate = time[chosen], rate[chosen]
    top = max(rate.max(), 1e-12)
    bottom = top * 1e-10
    image = axis.pcolormesh(
        edges(time), edges(x), np.maximum(rate, bottom).T,
        norm=LogNorm(bottom, top), cmap="viridis", shading="flat",
        rasterized=True,
    )
    axis.set_xlim(time[0], time[-1])
    axis.set_ylabel("position along x [m]")
    axis.set_title(title, loc="left")
    figure.colorbar(image, ax=axis, label="slip rate [m/s]", pad=0.01)


def event_window(own_events, number):
    """Times that show one event with what comes shortly before and after."""
    count = len(own_events["start"])
    if count == 0:
        return None
    index = count // 2 if number is None else number - 1
    if not 0 <= index < count:
        raise RunError(f"There is no event {number}; there are {count}.")
    start, end = own_events["start"][index], own_events["end"][index]
    if not np.isfinite(end):
        end = own_events["peak_time"][index]
    margin = max(1.5 * (end - start), 1e-3)
    return index + 1, (start - margin, end + margin)


def draw_steps(axes, series):
    t = series["time"]
    axes[0].semilogy(t, series["step_size"], color=BLUE, linewidth=0.8)
    axes[0].set_ylabel("step size [s]")
    axes[0].set_title("Time steps", loc="left")
    axes[0].grid(alpha=0.3)
    for name, colour, label in (
        ("multigrid_cycles", GREY, "multigrid cycles"),
        ("tnnmg_iterations", ORANGE, "TNNMG iterations"),
        ("rate_state_iterations", GREEN, "rate-state iterations"),
    ):
        axes[1].plot(t, series[name], ".", color=colour, markersize=2,
                     label=label, rasterized=True)
    axes[1].set_yscale("log")
    axes[1].set_ylim(bottom=0.8)
    axes[1].set_ylabel("per time step")
    axes[1].set_title("Iterations", loc="left")
    axes[1].legend(loc="lower right", bbox_to_anchor=(1, 0.97), ncol=3,
                   markerscale=4)
    axes[1].grid(alpha=0.3)


def draw(directory, file_name, wanted_fault, wanted_event):
    series = read_table(directory / "time_series.csv")
    events = read_table(directory / "events.csv")
    if len(series["time"]) == 0:
        raise RunError(f"{directory / 'time_series.csv'} holds no step.")
    fault = choose_fault(series, events, wanted_fault)
    x, time, rate = read_fault(directory / "faults.h5", fault)
    own = events["fault"] == fault
    own_events = {name: values[own] for name, values in events.items()}
    window = event_window(own_events, wanted_event)

    plt.rcParams.update({
        "font.size": 9, "axes.titlesize": 10, "legend.frameon": False,
        "axes.spines.top": False, "axes.spines.right": False,
    })
    figure, axes = plt.subplots(
        5, 1, figsize=(9, 12.5), constrained_layout=True,
        gridspec_kw={"height_ratios": [1.2, 1.3, 1.3, 0.8, 0.9]},
    )
    whole = (series["time"][0], series["time"][-1])
    draw_slip_rates(axes[0], series, fault, own_events)
    draw_map(figure, axes[1], x, time, rate, (-np.inf, np.inf),
             f"Slip rate along {fault}")
    if window is None:
        axes[2].text(0.5, 0.5, "no events", transform=axes[2].transAxes,
                     ha="center", va="center")
        axes[2].set_title("One event", loc="left")
    else:
        number, limits = window
        draw_map(figure, axes[2], x, time, rate, limits, f"Event {number}")
    draw_steps(axes[3:], series)
    for axis in (axes[0], axes[1], axes[3], axes[4]):
        if whole[1] > whole[0]:
            axis.set_xlim(*whole)
    for axis in axes:
        axis.set_xlabel("time [s]")
    figure.savefig(file_name, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("-o", metavar="FIGURE", type=pathlib.Path,
                        help="default: run.png in the output directory")
    parser.add_argument("--fault", metavar="NAME",
                        help="default: the fault with most events")
    parser.add_argument("--event", metavar="N", type=int,
                        help="counted from 1; default: the middle one")
    arguments = parser.parse_args()
    figure = arguments.o or arguments.directory / "run.png"
    try:
        draw(arguments.directory, figure, arguments.fault, arguments.event)
    except (RunError, KeyError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print(figure)
    return 0


if __name__ == "__main__":
    sys.exit(main())
