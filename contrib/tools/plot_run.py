#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Draw a run: slip, slip rates and tractions over time and space, step sizes and iterations.

Usage: plot_run.py OUTPUT_DIRECTORY [-o FIGURE] [--fault NAME[,NAME...]] [--event N]

Reads time_series.csv, events.csv, openings.csv and faults.h5 of a run and draws

- the largest and the mean slip rate of the chosen faults over time, with their events;
- in two dimensions, for each of these faults, its slip rate over position and time, for
  the whole run and from shortly before to shortly after one event, and what it slips
  in that time, with the shear traction before and after;
- in three dimensions, for each of them, maps over the fault of what it slips in that
  time, its largest slip rate, and the change of its shear traction;
- of faults that may open, the largest gap and the open area over time with their openings,
  shaded, and the gap over position and time, or over the fault;
- step sizes, and the iterations that each step took.

The position on a fault that is not level is the way along it, as in faults.h5; in three
dimensions the ways along strike and down dip, with which the fault is unfolded into a
plane. The fault is the one with most events unless faults are chosen ('all' takes
all); the event is the one in the middle of those of the first of them, or N, counted
from 1. Files of a run that has not ended, or has no events, are drawn as far as they go.
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
import scipy.sparse
import scipy.sparse.linalg
from matplotlib.colors import LogNorm

# Okabe and Ito's colours, which the colour-blind can tell apart.
BLUE, ORANGE, GREEN, VERMILION, GREY = (
    "#0072b2", "#e69f00", "#009e73", "#d55e00", "#777777"
)
COLOURS = (VERMILION, BLUE, ORANGE, GREEN, "#56b4e9", "#cc79a7", "#b8a800", "#000000")
# A fault whose normal is nearer to the vertical than this is unfolded along x and y.
LEVEL = np.cos(np.radians(15))


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


def unfolded(points, faces, axes):
    """Ways along strike and down dip of the nodes of a fault in space, in m.

    Along each edge they grow as it goes along these directions, by least squares: on a
    plane they are coordinates, on a fault that bends in one direction arc lengths.
    Of a level fault they are x and y.
    """
    normals = axes[:, -1]
    mean = normals.mean(axis=0)
    if np.abs(mean[2]) >= LEVEL * np.linalg.norm(mean):
        directions = (np.tile([1.0, 0, 0], (len(points), 1)),
                      np.tile([0, 1.0, 0], (len(points), 1)))
        directions = [d - (d * normals).sum(axis=1)[:, None] * normals for d in directions]
    else:
        strike = np.cross([0, 0, 1.0], normals)
        if strike.mean(axis=0) @ [1.0, 0.1, 0] < 0:
            strike = -strike
        dip = np.cross(strike, normals)
        directions = [strike, dip * np.sign(-dip[:, 2].mean())]
    directions = [d / np.linalg.norm(d, axis=1, keepdims=True) for d in directions]

    around = [face[face >= 0] for face in faces]
    edges_of_faces = np.concatenate(
        [np.stack((face, np.roll(face, -1)), axis=1) for face in around])
    one, other = edges_of_faces.T
    way = points[other] - points[one]
    rows = np.arange(len(one))
    differences = scipy.sparse.csr_matrix(
        (np.concatenate((-np.ones(len(one)), np.ones(len(one)))),
         (np.concatenate((rows, rows)), np.concatenate((one, other)))),
        shape=(len(one), len(points)))
    result = []
    for number, direction in enumerate(directions):
        steps = ((direction[one] + direction[other]) / 2 * way).sum(axis=1)
        values = scipy.sparse.linalg.lsqr(
            differences, steps, atol=1e-12, btol=1e-12)[0]
        shift = 0 if np.abs(mean[2]) < LEVEL else np.mean(points[:, number] - values)
        result.append(values - values.min() if shift == 0 else values + shift)
    return np.stack(result, axis=1)


class FaultRecords:
    """The fields of one fault over time, at its nodes in contact in the order of the
    way along it; in three dimensions at all nodes."""

    def __init__(self, path, name):
        if not path.is_file():
            raise RunError(f"There is no file {path}.")
        self.path, self.name = path, name
        with h5py.File(path, "r") as file:
            if name not in file:
                raise RunError(f"{path} holds no fault {name}.")
            group = file[name]
            if "slip_rate" not in group:
                raise RunError(
                    f"{path} holds no slip_rate; 'Output/Fault fields' must list it."
                )
            points = np.array(group["coordinates"])
            weight = np.array(group["weight"]).ravel()
            self.time = np.array(group["time"]).ravel()
            self.time = self.time[: len(group["slip_rate"])]
            self.is_plane = points.shape[1] == 2
            self.is_level = np.ptp(points[:, -1]) <= 1e-9 * np.ptp(points[:, 0])
            if self.is_plane:
                # Files of earlier versions have no ways along faults.
                has_way = not self.is_level and "arc_length" in group
                self.along = np.array(group["arc_length"]) if has_way else points[:, 0]
                self.label = ("position along the fault [m]" if has_way
                              else "position along x [m]")
                order = np.argsort(self.along, kind="stable")
                self.nodes = order[weight[order] > 0]
                self.along = self.along[self.nodes]
            else:
                self.nodes = np.arange(len(points))
                self.faces = np.array(group["faces"])
                axes = np.array(group["axes"])
                self.map = unfolded(points, self.faces, axes)
                self.labels = (("x [m]", "y [m]") if self.is_level
                               else ("along strike [m]", "down dip [m]"))
                # A long fault has its maps below each other.
                self.is_long = np.ptp(self.map[:, 0]) > 1.5 * np.ptp(self.map[:, 1])

    def has(self, field):
        with h5py.File(self.path, "r") as file:
            return field in file[self.name]

    def field(self, name, records=slice(None)):
        """Records x nodes; in three dimensions x components."""
        with h5py.File(self.path, "r") as file:
            values = np.array(file[self.name][name])[: len(self.time)]
        return values[records][:, self.nodes]

    def rate(self, records=slice(None)):
        rate = np.abs(self.field("slip_rate", records))
        return rate if rate.ndim == 2 else np.linalg.norm(rate, axis=2)

    def triangles(self):
        """Those that the faces are made of, without faces across periodic ends."""
        extent = np.ptp(self.map, axis=0)
        result = []
        for face in self.faces:
            face = face[face >= 0]
            if (np.ptp(self.map[face], axis=0) > 0.6 * extent).any() and len(
                    self.faces) > 8:
                continue
            result.append(face[:3])
            if len(face) == 4:
                result.append(face[[0, 2, 3]])
        return np.array(result)


def edges(centres):
    """Limits of the cells around the given points."""
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middle = (centres[1:] + centres[:-1]) / 2
    return np.concatenate(([centres[0]], middle, [centres[-1]]))


def choose_faults(series, events, wanted):
    faults = [
        name[: -len(".max_slip_rate")]
        for name in series
        if name.endswith(".max_slip_rate")
    ]
    if not faults:
        raise RunError("time_series.csv has no column of slip rates.")
    if wanted == "all":
        return faults
    if wanted is not None:
        names = wanted.split(",")
        for name in names:
            if name not in faults:
                raise RunError(f"No fault {name}; there are {', '.join(faults)}.")
        return names
    # On a tie the last fault: the topmost one, nearest to the usual loading.
    return [max(
        reversed(faults), key=lambda name: int(np.sum(events["fault"] == name))
    )]


def draw_slip_rates(axis, series, faults, events):
    t = series["time"]
    top = 1e-12
    for number, fault in enumerate(faults):
        colour = COLOURS[number % len(COLOURS)]
        own = events["fault"] == fault
        name = "" if len(faults) == 1 else f"{fault}: "
        axis.semilogy(t, series[f"{fault}.max_slip_rate"], color=colour,
                      linewidth=0.9, label=f"{name}largest")
        axis.semilogy(t, series[f"{fault}.mean_slip_rate"], linewidth=0.9,
                      color=BLUE if len(faults) == 1 else colour,
                      linestyle="-" if len(faults) == 1 else ":",
                      label="mean" if len(faults) == 1 else None)
        axis.plot(events["peak_time"][own], events["peak_mean_slip_rate"][own], "o",
                  color="black" if len(faults) == 1 else colour, markersize=3,
                  linestyle="none", label=f"{name}{own.sum()} events")
        top = max(top, np.nanmax(series[f"{fault}.max_slip_rate"], initial=0))
    axis.set_ylim(1e-14, max(10 * top, 1e-12))
    axis.set_ylabel("slip rate [m/s]")
    axis.set_title("Slip rate of " + ", ".join(faults)
                   + ("" if len(faults) == 1 else " (dotted: mean)"), loc="left")
    axis.legend(loc="lower right", ncol=3)
    axis.grid(alpha=0.3)


def may_open(series, fault):
    return f"{fault}.open_area" in series


def length_unit(size):
    """By what to multiply lengths in m of this size for a figure, and the unit then."""
    for factor, unit in ((1, "m"), (1e3, "mm"), (1e6, "µm")):
        if factor * size >= 0.5:
            return factor, unit
    return (1e9, "nm") if size > 0 else (1e3, "mm")


def draw_openings(axis, series, faults, openings, dimension):
    """Largest gap and open area of the faults that may open, and their openings."""
    t = series["time"]
    largest = max(np.nanmax(series[f"{fault}.largest_gap"]) for fault in faults)
    factor, unit = length_unit(largest)
    area = axis.twinx()
    for number, fault in enumerate(faults):
        colour = VERMILION if len(faults) == 1 else COLOURS[number % len(COLOURS)]
        own = openings["fault"] == fault
        axis.plot(t, factor * series[f"{fault}.largest_gap"], color=colour, linewidth=0.9,
                  label=f"{fault}: {own.sum()} openings")
        area.plot(t, series[f"{fault}.open_area"], color=colour, linewidth=0.9,
                  linestyle=":")
        for opens, closes in zip(openings["opens"][own], openings["closes"][own]):
            axis.axvspan(opens, closes if np.isfinite(closes) else t[-1], color=colour,
                         alpha=0.08, linewidth=0)
    axis.set_ylim(bottom=0)
    area.set_ylim(bottom=0)
    axis.set_ylabel(f"largest gap [{unit}]")
    what = "open length" if dimension == 2 else "open area"
    area.set_ylabel(what + (" [m]" if dimension == 2 else " [m²]"))
    area.spines["right"].set_visible(True)
    axis.set_title("Gap of " + ", ".join(faults) + f" (dotted: {what})", loc="left")
    axis.legend(loc="lower right", bbox_to_anchor=(1, 0.97), ncol=4)
    axis.grid(alpha=0.3)


def draw_map(axis, fault, limits, title, field="slip_rate"):
    chosen = (fault.time >= limits[0]) & (fault.time <= limits[1])
    axis.set_title(title, loc="left")
    if chosen.sum() < 2 or len(fault.along) < 2:
        axis.text(0.5, 0.5, "no records", transform=axis.transAxes,
                  ha="center", va="center")
        return
    time = fault.time[chosen]
    if field == "gap":
        gap = fault.field("gap", chosen)
        factor, unit = length_unit(gap.max())
        # Closed nodes stay white.
        values, colours, norm = np.where(gap > 0, factor * gap, np.nan), "magma_r", None
        label = f"gap [{unit}]"
    else:
        rate = fault.rate(chosen)
        top = max(rate.max(), 1e-12)
        bottom = top * 1e-10
        values, colours, norm = np.maximum(rate, bottom), "viridis", LogNorm(bottom, top)
        label = "slip rate [m/s]"
    image = axis.pcolormesh(edges(time), edges(fault.along), values.T, norm=norm,
                            cmap=colours, shading="flat", rasterized=True)
    if np.isnan(values).all():
        image.set_clim(0, 1)
        axis.text(0.5, 0.5, "closed", transform=axis.transAxes, ha="center", va="center")
    axis.set_xlim(time[0], time[-1])
    axis.set_xlabel("time [s]")
    axis.set_ylabel(fault.label)
    axis.figure.colorbar(image, ax=axis, label=label, pad=0.01)


def ends_of(fault, window):
    """Numbers of the records at both ends of a window of time."""
    first, last = np.searchsorted(fault.time, window)
    last = min(last, len(fault.time) - 1)
    return max(min(first, last) - 1, 0), last


def draw_profiles(axes, fault, window):
    """Slip of a plane fault within a window, and shear tractions at its ends; if it may
    open, its gap when that is largest."""
    records = list(ends_of(fault, window))
    for axis, field, factor, label in (
        (axes[0], "slip", 1e3, "slip [mm]"),
        (axes[1], "shear_traction", 1e-3, "shear traction [kPa]"),
    ):
        axis.set(xlabel=fault.label, ylabel=label)
        axis.grid(alpha=0.3)
        if not fault.has(field):
            axis.text(0.5, 0.5, f"no {field}", transform=axis.transAxes,
                      ha="center", va="center")
            continue
        before, after = factor * fault.field(field)[records]
        if field == "slip":
            axis.plot(fault.along, after - before, color=BLUE, linewidth=0.9)
        else:
            axis.plot(fault.along, before, color=GREY, linewidth=0.9, label="before")
            axis.plot(fault.along, after, color=VERMILION, linewidth=0.9, label="after")
            axis.legend()
    if fault.has("gap"):
        gap = fault.field("gap", slice(records[0], records[1] + 1))
        widest = gap.max(axis=1).argmax()
        factor, unit = length_unit(gap.max())
        axes[2].plot(fault.along, factor * gap[widest], color=VERMILION, linewidth=0.9)
        axes[2].set(xlabel=fault.label, ylabel=f"gap [{unit}]")
        axes[2].set_title(f"t = {fault.time[records[0] + widest]:.5g} s", loc="left")
        axes[2].grid(alpha=0.3)
    axes[0].set_title(f"What {fault.name} slips from t = {fault.time[records[0]]:.5g} s "
                      f"to {fault.time[records[1]]:.5g} s", loc="left")


def draw_fault_maps(axes, fault, window):
    """Slip, largest slip rate and change of traction over a fault in space."""
    first, last = ends_of(fault, window)
    maps = [("largest slip rate [m/s]", fault.rate(slice(first, last + 1)).max(axis=0),
             "viridis")]
    if fault.has("slip"):
        slip = fault.field("slip")[[first, last]]
        maps.insert(0, ("slip [mm]", 1e3 * np.linalg.norm(slip[1] - slip[0], axis=1),
                        "viridis"))
    if fault.has("shear_traction"):
        before, after = np.linalg.norm(
            fault.field("shear_traction")[[first, last]], axis=2)
        maps.append(("change of shear traction [kPa]", 1e-3 * (after - before), "RdBu_r"))
    if fault.has("gap"):
        gap = fault.field("gap", slice(first, last + 1)).max(axis=0)
        factor, unit = length_unit(gap.max())
        maps.append((f"largest gap [{unit}]", factor * gap, "magma_r"))
    triangles = fault.triangles()
    for axis, (label, values, colours) in zip(axes, maps):
        limits = {}
        if colours == "RdBu_r":
            limits = {"vmax": np.abs(values).max(), "vmin": -np.abs(values).max()}
        elif label.startswith("largest slip rate") and values.max() > 0:
            limits = {"norm": LogNorm(max(values.min(), 1e-6 * values.max()),
                                      values.max() * (1 + 1e-9))}
            values = np.maximum(values, 1e-6 * values.max())
        image = axis.tripcolor(*fault.map.T, triangles, values, shading="gouraud",
                               cmap=colours, rasterized=True, **limits)
        axis.set(xlabel=fault.labels[0], ylabel=fault.labels[1],
                 aspect="auto" if fault.is_long else "equal")
        axis.figure.colorbar(
            image, ax=axis, label=label, pad=0.02,
            orientation="vertical" if fault.is_long else "horizontal")
        if fault.labels[1].startswith("down"):
            axis.invert_yaxis()
    axes[0].set_title(f"{fault.name} from t = {fault.time[first]:.5g} s to "
                      f"{fault.time[last]:.5g} s", loc="left")


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


class Panels:
    """The panels of a figure, row by row: (height, number of panels) for each row."""

    def __init__(self, rows):
        heights = [height for height, _ in rows]
        self.figure = plt.figure(figsize=(9, 2.2 * sum(heights) + 0.4),
                                 layout="constrained")
        parts = self.figure.subfigures(len(rows), 1, height_ratios=heights)
        self.rows = iter([
            list(part.subplots(1, n, squeeze=False)[0])
            for part, (_, n) in zip(parts, rows)
        ])

    def row(self):
        return next(self.rows)


def draw_plane_fault(panels, fault, window, number, has_event):
    axis, = panels.row()
    draw_map(axis, fault, (-np.inf, np.inf),
             f"Slip rate along {fault.name}")
    axis, = panels.row()
    if has_event:
        draw_map(axis, fault, window, f"Event {number}")
    else:
        axis.text(0.5, 0.5, "no events", transform=axis.transAxes,
                  ha="center", va="center")
        axis.set_title("One event", loc="left")
    if fault.has("gap"):
        axis, = panels.row()
        draw_map(axis, fault, (-np.inf, np.inf), f"Gap along {fault.name}", "gap")
    draw_profiles(panels.row(), fault, window)


def draw(directory, file_name, wanted_faults, wanted_event):
    series = read_table(directory / "time_series.csv")
    events = read_table(directory / "events.csv")
    if len(series["time"]) == 0:
        raise RunError(f"{directory / 'time_series.csv'} holds no step.")
    names = choose_faults(series, events, wanted_faults)
    faults = [FaultRecords(directory / "faults.h5", name) for name in names]
    own = events["fault"] == names[0]
    event = event_window({name: values[own] for name, values in events.items()},
                         wanted_event)
    whole = (series["time"][0], series["time"][-1])
    number, window = event or (0, whole)

    plt.rcParams.update({
        "font.size": 9, "axes.titlesize": 10, "legend.frameon": False,
        "axes.spines.top": False, "axes.spines.right": False,
    })
    unilateral = [name for name in names if may_open(series, name)]
    rows = [(1.2, 1)] + [(1.0, 1)] * bool(unilateral)
    for fault in faults:
        opens = fault.has("gap")
        if fault.is_plane:
            rows += [(1.3, 1)] * (2 + opens) + [(1.1, 2 + opens)]
        elif fault.is_long:
            rows += [(1.1, 1)] * (3 + opens)
        else:
            rows += [(1.8, 3 + opens)]
    panels = Panels(rows + [(0.8, 1), (0.9, 1)])
    over_time = panels.row()
    draw_slip_rates(over_time[0], series, names, events)
    if unilateral:
        over_time += panels.row()
        draw_openings(over_time[1], series, unilateral,
                      read_table(directory / "openings.csv"),
                      2 if faults[0].is_plane else 3)
    for fault in faults:
        if fault.is_plane:
            draw_plane_fault(panels, fault, window, number, event is not None)
        else:
            draw_fault_maps(
                [axis for _ in range(3 + fault.has("gap")) for axis in panels.row()]
                if fault.is_long else panels.row(),
                fault, window)
    steps = panels.row() + panels.row()
    draw_steps(steps, series)
    for axis in over_time + steps:
        if whole[1] > whole[0]:
            axis.set_xlim(*whole)
        axis.set_xlabel("time [s]")
    panels.figure.savefig(file_name, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("-o", metavar="FIGURE", type=pathlib.Path,
                        help="default: run.png in the output directory")
    parser.add_argument("--fault", metavar="NAME[,NAME...]",
                        help="or 'all'; default: the fault with most events")
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
