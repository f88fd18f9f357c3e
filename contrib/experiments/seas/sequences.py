# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Events of runs beside those of other programs, and errors against cost."""

import dataclasses
import math

import numpy as np

from experiments.seas.benchmarks import (BENCHMARKS, ELEMENTS, SHORTEST_INTERVAL, THRESHOLD,
                                         YEAR)


@dataclasses.dataclass
class Sequence:
    """The largest slip rate after each step, and the events."""

    # s, m/s.
    time: np.ndarray
    rate: np.ndarray
    # Starts, s, and largest slip rates, m/s, of events.
    starts: np.ndarray
    peaks: np.ndarray


def read(folder):
    table = np.genfromtxt(folder / "time_series.csv", delimiter=",", names=True,
                          deletechars="")
    time, rate = table["time"], np.abs(table["fault.max_slip_rate"])
    return Sequence(time, rate, *events(time, rate))


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
        if not starts or start - starts[-1] > SHORTEST_INTERVAL:
            starts.append(start)
            peaks.append(rate[i + 1:end + 1].max())
    return np.array(starts), np.array(peaks)


def reference(benchmark):
    """Name and event times, yr, of the first program that has some."""
    return next(iter(benchmark.events.items()))


def show(name, sequence):
    """Times of events here and elsewhere, yr, and largest slip rates."""
    benchmark = BENCHMARKS[name]
    largest = f" (published {benchmark.largest:g})" if benchmark.largest > 0. else ""
    print("event   time, yr   interval, yr   largest slip rate, m/s" + largest
          + "".join(f"   {program}: time, yr   off by" for program in benchmark.events))
    years = sequence.starts / YEAR
    for i, (time, peak) in enumerate(zip(years, sequence.peaks)):
        line = (f"{i + 1:5d}   {time:8.2f}   {time - (years[i - 1] if i else 0.):12.2f}   "
                f"{peak:22.2f}" + " " * len(largest))
        for program, times in benchmark.events.items():
            width = len(program) + 10
            line += (f"   {times[i]:{width}.2f}   {100. * (time / times[i] - 1.):+5.2f}%"
                     if i < len(times) else f"   {'-':>{width}}        -")
        print(line)


def most_digits(benchmark):
    """Name and event times, yr, of the boundary elements, if there are any: those of
    others are rounded."""
    if ELEMENTS in benchmark.events:
        return ELEMENTS, benchmark.events[ELEMENTS]
    return reference(benchmark)


def errors(name, sequence):
    """Of the first event and of the first interval, yr."""
    times = most_digits(BENCHMARKS[name])[1]
    years = sequence.starts / YEAR
    if len(years) < 2 or len(times) < 2:
        return math.nan, math.nan
    return years[0] - times[0], np.diff(years)[0] - np.diff(times)[0]


def show_convergence(name, runs):
    """Errors against cost; runs are (cell, m, vertices, accepted steps, processor time, s,
    sequence), from coarse to fine. Orders are those of the error from one row to the next."""
    program = most_digits(BENCHMARKS[name])[0]
    print(f"\nErrors against {program}, yr, and the orders of the two:")
    print("cell, m   vertices   steps   processor time, s   first event   order   "
          "first interval   order")
    last = None
    for cell, vertices, steps, used, sequence in runs:
        here = errors(name, sequence)
        orders = ["-", "-"]
        if last:
            ratio = math.log(last[0] / cell)
            orders = [f"{math.log(abs(old / new)) / ratio:.1f}" if new and old == old
                      else "-" for old, new in zip(last[1], here)]
        print(f"{cell:7g}   {vertices:8,d}   {steps:5,d}   {used:17.0f}   {here[0]:11.2f}   "
              f"{orders[0]:>5}   {here[1]:14.2f}   {orders[1]:>5}")
        last = (cell, here)
