#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run a benchmark of the SEAS project and put it beside published numbers.

Usage: contrib/seas NAME [--cell M] [--years Y] [--drawn-only] [--image]
                    [--set ENTRY=VALUE] [--program FILE]

NAME is that of a scene of parameters/seas, as bp1. Cells on the fault have M metres,
those of the scene over or times a power of two (of BP3 they reach as far from the fault
when they are smaller); Y are years of 365 days. The run goes
to output/seas/NAME_M/, the figure to figure.png there, profiles of slip and stresses
in the form of the benchmarks to slip.dat, shear_stress.dat and normal_stress.dat, and
a table of the events to the screen: an event begins when the largest slip rate passes
1e-3 m/s; of bp5 also their moments, and when the first rupture arrives where. With
--drawn-only an earlier run is taken, with --image the figure goes to doc/images as well;
--set is passed on.
"""

import dataclasses
import math
import sys

import h5py
import numpy as np

from common import figures, programs
from experiments.seas import rupture

YEAR = 365 * 86400.
THRESHOLD = 1e-3
PLANE = ("footwall", "hanging_wall")


@dataclasses.dataclass
class Benchmark:
    """Bodies and mesh of a scene, and what others found."""

    bodies: tuple
    # Cells of the file, m, and its refinement passes.
    cell: float
    passes: int
    # Distance down the dip over depth.
    slope: float = 1.
    # Rows of cells of one size in the file, where smaller cells come in as many rows more:
    # the stiffness of the medium depends on how far they reach.
    rows: int = 0
    # Times of events, yr, and largest slip rate, m/s, of codes that took part.
    events: tuple = ()
    largest: float = math.nan


# BP1: first event and intervals.
FIRST_AND_INTERVALS = [196.5, 75.67, 77.87, 78.35, 78.40]
BENCHMARKS = {
    "bp1": Benchmark(("minus", "plus"), 100., 14,
                     events=tuple(np.cumsum(FIRST_AND_INTERVALS)), largest=4.18),
    "bp2": Benchmark(("minus", "plus"), 50., 15),
    "bp3_thrust60": Benchmark(PLANE, 50., 15, 2. / math.sqrt(3.),
                              8, (177.22, 277.53, 334.53, 421.54, 514.05, 611.52, 674.79)),
    "bp3_normal60": Benchmark(PLANE, 50., 15, 2. / math.sqrt(3.), 8),
    "bp3_thrust30": Benchmark(PLANE, 50., 15, 2., 8),
    "bp3_normal30": Benchmark(PLANE, 50., 15, 2., 8,
                              (206.84, 279.40, 392.23, 465.71, 576.42, 650.34)),
    "bp5": Benchmark(("minus", "plus"), 2000., 7),
}


def settings(name, cell, years, folder):
    benchmark = BENCHMARKS[name]
    passes = benchmark.passes + math.log2(benchmark.cell / cell)
    if passes != round(passes):
        sys.exit(f"contrib/seas: --cell must be {benchmark.cell:.0f} over or times a power "
                 "of two.")
    result = {f"Bodies/{body}/Refinement passes": round(passes)
              for body in benchmark.bodies}
    if benchmark.rows and cell < benchmark.cell:
        for body in benchmark.bodies:
            result[f"Bodies/{body}/Refinement rows"] = round(
                benchmark.rows * benchmark.cell / cell)
    result["Output/Output directory"] = folder
    if years:
        result["Time/End time"] = years * YEAR
    return result


def events(time, rate):
    """Starts, s, and largest slip rates, m/s."""
    fast = rate > THRESHOLD
    starts, peaks = [], []
    for i in np.nonzero(fast[1:] & ~fast[:-1])[0]:
        part = np.log(THRESHOLD / rate[i]) / np.log(rate[i + 1] / rate[i])
        start = time[i] + part * (time[i + 1] - time[i])
        # Pauses of less than a day belong to the event.
        end = i + 1
        while end + 1 < len(time) and time[end + 1] - time[end] < 86400.:
            end += 1
        if not starts or start - starts[-1] > 30 * 86400.:
            starts.append(start)
            peaks.append(rate[i + 1:end + 1].max())
    return np.array(starts), np.array(peaks)


def show(name, starts, peaks):
    benchmark = BENCHMARKS[name]
    years = starts / YEAR
    largest = f" (published {benchmark.largest:g})" if benchmark.largest > 0. else ""
    print("event   time, yr   published   interval, yr   published   largest slip rate, m/s"
          f"{largest}")
    known_times = benchmark.events
    for i, (time, peak) in enumerate(zip(years, peaks)):
        interval = time - (years[i - 1] if i else 0.)
        known = known_interval = "-"
        if i < len(known_times):
            known = f"{known_times[i]:.2f}"
            known_interval = f"{known_times[i] - (known_times[i - 1] if i else 0.):.2f}"
        print(f"{i + 1:5d}   {time:8.2f}   {known:>9}   {interval:12.2f}   "
              f"{known_interval:>9}   {peak:10.2f}")


@dataclasses.dataclass
class History:
    """Records of the frictional part of a fault: values by time and depth."""

    time: np.ndarray
    # Down the dip, m.
    distance: np.ndarray
    # slip, slip_rate, shear_traction, normal_stress, as far as they are there.
    fields: dict


def read_fault(folder, benchmark):
    with h5py.File(folder / "faults.h5") as file:
        fault = file["fault"]
        coordinates = fault["coordinates"][:]
        if coordinates.shape[1] > 1 and np.ptp(coordinates[:, 1]) > 0.:
            distance = -coordinates[:, 1] * benchmark.slope
        else:
            distance = coordinates[:, 0]
        order = np.argsort(distance)
        order = order[distance[order] < 40e3 + 1.]
        time = fault["time"][:] if "time" in fault else file["time"][:]
        names = ["slip", "slip_rate", "shear_traction", "normal_stress"]
        fields = {name: fault[name][:].reshape(len(time), -1)[:, order]
                  for name in names if name in fault}
    return History(time, distance[order], fields)


def chosen(history):
    """Records every 5 yr between events and every second of them."""
    fastest = np.abs(history.fields["slip_rate"]).max(axis=1)
    last = {True: -np.inf, False: -np.inf}
    for i, (t, v) in enumerate(zip(history.time, fastest)):
        is_fast = bool(v > THRESHOLD)
        if t - last[is_fast] >= (1. if is_fast else 4.9 * YEAR):
            last[is_fast] = t
            yield i, is_fast, v


def write_profiles(folder, history):
    """Values every 500 m, in the form of the benchmarks."""
    positions = np.arange(0., 40e3 + 1., 500.)
    for field, title, unit in (("slip", "slip", 1.),
                               ("shear_traction", "shear_stress", 1e6),
                               ("normal_stress", "normal_stress", 1e6)):
        if field not in history.fields:
            continue
        with open(folder / f"{title}.dat", "w") as file:
            line = " ".join(f"{x:.6E}" for x in positions)
            file.write(f"{0.:.13E} {0.:.6E} {line}\n")
            for i, _, rate in chosen(history):
                values = np.interp(positions, history.distance, history.fields[field][i])
                line = " ".join(f"{x / unit:.6E}" for x in values)
                file.write(f"{history.time[i]:.13E} {np.log10(rate):.6E} {line}\n")


def draw(series, history):
    figure, (above, below) = figures.new_figure(2, height=7.)
    above.semilogy(series["time"] / YEAR, series["rate"], lw=0.7, color=figures.BLUE)
    above.axhline(THRESHOLD, lw=0.5, color=figures.GREY)
    above.set(xlabel="time [yr]", ylabel="largest slip rate [m/s]")
    for i, is_fast, _ in chosen(history):
        below.plot(np.abs(history.fields["slip"][i]), history.distance / 1e3, lw=0.4,
                   color=figures.VERMILION if is_fast else figures.BLUE)
    below.invert_yaxis()
    below.set(xlabel="slip [m]; every 5 yr (blue) and every second of events (red)",
              ylabel="distance down the fault [km]")
    return figure


def save(figure, given, folder):
    path = folder / "figure.png"
    figure.savefig(path, dpi=110)
    if given.image:
        path = figures.save(figure, f"seas_{given.name}")
    print(f"The figure is {path}.")


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("name", choices=sorted(BENCHMARKS))
    parser.add_argument("--cell", type=float)
    parser.add_argument("--years", type=float)
    parser.add_argument("--drawn-only", action="store_true")
    parser.add_argument("--image", action="store_true")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--program", default=programs.PROGRAM)
    given = parser.parse_args()
    benchmark = BENCHMARKS[given.name]
    cell = given.cell or benchmark.cell
    folder = programs.PROJECT / f"output/seas/{given.name}_{cell:g}"
    if not given.drawn_only:
        command = [given.program,
                   programs.PROJECT / f"parameters/seas/{given.name}.prm", "--overwrite"]
        for entry in given.set:
            command += ["--set", entry]
        used, note = programs.run_measured(
            command + programs.options(
                settings(given.name, cell, given.years, folder)), 86400)
        print(f"{used:.0f} s of processor time; {note or 'to the end'}")
    table = np.genfromtxt(folder / "time_series.csv", delimiter=",", names=True,
                          deletechars="")
    series = {"time": table["time"], "rate": np.abs(table["fault.max_slip_rate"])}
    starts, peaks = events(series["time"], series["rate"])
    show(given.name, starts, peaks)
    if given.name == "bp5":
        on_grid = rupture.read(folder)
        rupture.show(on_grid)
        rupture.show_arrivals(on_grid)
        save(rupture.draw(series, on_grid), given, folder)
        return
    history = read_fault(folder, benchmark)
    write_profiles(folder, history)
    save(draw(series, history), given, folder)


if __name__ == "__main__":
    main()
