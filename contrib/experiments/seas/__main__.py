#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run a benchmark of the SEAS project and put it beside published numbers.

Usage: contrib/seas NAME [--cell M] [--years Y] [--drawn-only] [--program FILE]

NAME is that of a scene of parameters/seas, as bp1. Cells on the fault have M metres,
100 over or times a power of two; Y are years of 365 days. The run goes to
output/seas/NAME_M/, the figure to figure.png there, and a table of the events to the
screen: an event begins when the largest slip rate passes 1e-3 m/s. With --drawn-only
an earlier run is taken.
"""

import math
import sys

import h5py
import numpy as np

from common import figures, programs

YEAR = 365 * 86400.
THRESHOLD = 1e-3
BODIES = {"bp1": ("minus", "plus")}
# Cells of the file, m, and its refinement passes.
CELL, PASSES = 100., 14
# First event, intervals, yr, and largest slip rate, m/s, of codes that took part.
PUBLISHED = {"bp1": ([196.5, 75.67, 77.87, 78.35, 78.40], 4.18)}


def settings(name, cell, years, folder):
    passes = PASSES + math.log2(CELL / cell)
    if passes != round(passes):
        sys.exit(f"contrib/seas: --cell must be {CELL:.0f} over or times a power of two.")
    result = {f"Bodies/{body}/Refinement passes": round(passes) for body in BODIES[name]}
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
    published, largest = PUBLISHED[name]
    intervals = np.diff(starts, prepend=0.) / YEAR
    print("event   interval, yr   published   largest slip rate, m/s "
          f"(published {largest:g})")
    for i, (interval, peak) in enumerate(zip(intervals, peaks)):
        known = f"{published[i]:9.2f}" if i < len(published) else "        -"
        print(f"{i + 1:5d}   {interval:12.2f}   {known}   {peak:10.2f}")


def read_fault(folder):
    with h5py.File(folder / "faults.h5") as file:
        fault = file["fault"]
        x = fault["coordinates"][:, 0]
        order = np.argsort(x)
        time = fault["time"][:] if "time" in fault else file["time"][:]
        return (time, x[order], fault["slip"][:][:, order].reshape(len(time), -1),
                fault["slip_rate"][:][:, order].reshape(len(time), -1))


def draw(folder, series, starts):
    figure, (above, below) = figures.new_figure(2, height=7.)
    above.semilogy(series["time"] / YEAR, series["rate"], lw=0.7, color=figures.BLUE)
    above.axhline(THRESHOLD, lw=0.5, color=figures.GREY)
    above.set(xlabel="time [yr]", ylabel="largest slip rate [m/s]")
    time, x, slip, rate = read_fault(folder)
    shown = x < 40e3
    fastest = np.abs(rate[:, shown]).max(axis=1)
    last_slow = last_fast = -np.inf
    for t, s, v in zip(time, slip[:, shown], fastest):
        if v > THRESHOLD and t - last_fast >= 1.:
            below.plot(s, x[shown] / 1e3, lw=0.4, color=figures.VERMILION)
            last_fast = t
        elif v <= THRESHOLD and t - last_slow >= 4.9 * YEAR:
            below.plot(s, x[shown] / 1e3, lw=0.5, color=figures.BLUE)
            last_slow = t
    below.invert_yaxis()
    below.set(xlabel="slip [m]; every 5 yr (blue) and every second of events (red)",
              ylabel="depth [km]")
    path = folder / "figure.png"
    figure.savefig(path, dpi=110)
    print(f"The figure is {path}.")


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("name", choices=sorted(BODIES))
    parser.add_argument("--cell", type=float, default=CELL)
    parser.add_argument("--years", type=float)
    parser.add_argument("--drawn-only", action="store_true")
    parser.add_argument("--program", default=programs.PROGRAM)
    given = parser.parse_args()
    folder = programs.PROJECT / f"output/seas/{given.name}_{given.cell:g}"
    if not given.drawn_only:
        command = [given.program,
                   programs.PROJECT / f"parameters/seas/{given.name}.prm", "--overwrite"]
        used, note = programs.run_measured(
            command + programs.options(
                settings(given.name, given.cell, given.years, folder)), 86400)
        print(f"{used:.0f} s of processor time; {note or 'to the end'}")
    table = np.genfromtxt(folder / "time_series.csv", delimiter=",", names=True,
                          deletechars="")
    series = {"time": table["time"], "rate": np.abs(table["fault.max_slip_rate"])}
    starts, peaks = events(series["time"], series["rate"])
    show(given.name, starts, peaks)
    draw(folder, series, starts)


if __name__ == "__main__":
    main()
