#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check what contrib/results measures, where it is known, and its quick mode.

Usage: check_results.py CONTRIB_DIRECTORY [PROGRAM]

A made-up history with fronts of known speed, a made-up catalogue with a foreshock and
an aftershock, and made-up steps; the block against exact stresses, its weight and a
balance of forces. With PROGRAM the first seconds of the published experiments are run,
and all that can be told of them. Prints one line for each failure.
"""

import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

START, SITE, SPEEDS = 10.0, 0.4, (12.0, 25.0)
ZONE = 0.5


def arrival(x):
    """When the front comes, which begins at the edges of a zone around SITE."""
    outside = np.maximum(np.abs(x - SITE) - ZONE, 0.0)
    return START + outside / np.where(x < SITE, *SPEEDS)


def write_history(path):
    """Rates that jump to 1 cm/s with the front, after 1 mm/s in the zone."""
    x = np.linspace(-2.5, 2.5, 101)
    time = np.arange(9.0, 11.0, 5e-4)
    rate = np.where(time[:, None] < arrival(x), 1e-7, 1e-2)
    early = (time[:, None] > START - 0.05) & (np.abs(x - SITE) < ZONE)
    rate = np.maximum(rate, np.where(early, 1e-3, 0.0))
    rate[:, 0] *= -1
    order = np.random.default_rng(1).permutation(len(x))
    with h5py.File(path, "w") as file:
        group = file.create_group("fault")
        group["coordinates"] = np.stack((x, 0 * x), axis=1)[order]
        group["weight"], group["time"] = np.full(len(x), 0.05), time
        group["slip_rate"] = rate[:, order]


def check_fronts(history, ruptures):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "faults.h5")
        write_history(path)
        fault = history.FaultHistory(path, "fault")
        found = ruptures.describe(fault, fault.rate(), START, 10.8, 9.5)
    for name, value, tolerance in (
        ("begin", START - 0.05, 2e-3),
        ("zone_left", SITE - ZONE, 0.06),
        ("zone_right", SITE + ZONE, 0.06),
        ("front_begin", START, 2e-3),
        ("speed_left", SPEEDS[0], 0.2),
        ("speed_right", SPEEDS[1], 0.4),
        ("reached", 1.0, 1e-12),
    ):
        if not abs(found.get(name, np.nan) - value) <= tolerance:
            yield f"{name} is {found.get(name)} in place of {value}"


def made_up_catalogue():
    """Events every two seconds, with a small one 0.2 s after the second."""
    starts = np.array([10.0, 12.0, 12.3, 14.0, 16.0])
    return {
        "start": starts,
        "end": starts + 0.1,
        "peak_slip_rate": np.array([1e-2, 1e-2, 5e-3, 1e-2, 1e-2]),
        "mean_slip": np.array([4e-4, 4e-4, 5e-5, 3e-4, 4e-4]),
    }


def check_small_ones(ruptures, statistics):
    events = made_up_catalogue()
    time = np.arange(9.0, 17.0, 1e-2)
    rate = np.full(len(time), 1e-6)
    for start, end in zip(events["start"], events["end"]):
        rate[(time >= start) & (time <= end)] = 1e-2
    # A foreshock of the fourth, something between, and what is too slow to count.
    for begin, largest in ((13.8, 4e-3), (15.0, 4e-3), (11.0, 8e-4)):
        rate[(time > begin) & (time < begin + 0.05)] = largest
    found = ruptures.small_ones({"time": time, "fault.max_slip_rate": rate}, "fault", events)
    kinds = [(round(one["begin"], 1), one["kind"]) for one in found]
    if kinds != [(12.3, "aftershock"), (13.8, "foreshock"), (15.0, "between")]:
        yield f"small events are {kinds}"

    sizes = np.where(rate > 5e-3, 1e-4, 2e-2)
    series = {"time": time, "step_size": sizes}
    if not np.allclose(statistics.shrinking(series, events), 200.0):
        yield f"steps shrink by {statistics.shrinking(series, events)}"
    medians = {k: v["median"] for k, v in statistics.step_sizes(series, events).items()}
    if medians != {"events": 1e-4, "loading": 2e-2}:
        yield f"the median steps are {medians}"
    if statistics.histogram(np.array([2.0, 2.0, 3.0, 5.0])) != {2: 0.5, 3: 0.25, 5: 0.25}:
        yield "the histogram is wrong"


def check_block(block, layers):
    model = block.Block(columns=20, rows=(4, 2, 1, 2, 4))
    # Simple shear: the traction is the shear modulus times the shear everywhere.
    u = np.zeros(model.n)
    u[0::2] = 1e-3 * np.tile(model.z, len(model.x))
    for operator in model.traction_operators(0, 0):
        if not np.allclose(operator @ u, 1e-3 * layers.SHEAR_MODULUS):
            yield "simple shear gives another traction"
    share = model.width / model.width.sum()
    normal, shear = model.under_weight()
    weights = normal @ share
    if not np.allclose(weights, layers.WEIGHTS[:-1], rtol=0.02):
        yield f"the weights are {weights} in place of {layers.WEIGHTS[:-1]} Pa"

    # Of a symmetric block under its weight.
    if not np.allclose(shear, -shear[:, ::-1], atol=1e-6 * normal.max()):
        yield "the shear from weight is not odd in x"
    if not np.allclose(normal, normal[:, ::-1], rtol=1e-6):
        yield "the normal stress is not even in x"

    # Slow loading: each fault carries the same force. A slip that is uniform and as
    # large as what the top has moved takes all of it away again, since the upper part
    # then moves as a whole.
    times = np.arange(0.0, 12.0, 0.02)
    moved = layers.LOADING_RATE * (times - layers.RAMP / 2)
    for slip, expected in ((np.zeros(len(times)), None), (moved, 0.0)):
        full = model.tractions(times, np.repeat(slip[:, None], len(model.x), axis=1))
        mean = (full @ share)[len(times) // 2:].mean(axis=0)
        if expected is None:
            loaded = mean
            if not np.allclose(mean, mean[0], rtol=1e-3) or mean[0] < 1e3:
                yield f"slow loading gives {mean} Pa"
        elif not np.all(np.abs(mean) < 1e-2 * loaded):
            yield f"slip leaves {mean} Pa of {loaded} Pa"

    rate = 3e-9
    friction = layers.MU0 + layers.A * np.log(rate / layers.V0)
    friction += layers.B * np.log(layers.V0 * 20.0 / layers.L)
    found = np.exp(layers.log_rate(5e4 * friction, 5e4, 20.0))
    if not np.isclose(found, rate, rtol=1e-9):
        yield f"the friction law gives {found} in place of {rate} m/s"


def check_spectrum(inner):
    """Of two oscillations at other times than those of the spectrum."""
    class MadeUp:
        def series(self):
            time = np.sort(np.random.default_rng(2).uniform(0.0, 20.0, 40000))
            wave = np.sin(2 * np.pi * 9.0 * time) + 0.3 * np.sin(2 * np.pi * 17.5 * time)
            return {"time": time, "fault.mean_shear_traction": 50 * time + wave}

    found = inner.peaks(*inner.spectrum(MadeUp(), "fault", 1.0, 19.0), count=2)
    if len(found) != 2 or not np.allclose(found, [9.0, 17.5], atol=0.26):
        yield f"the spectrum has its peaks at {found} Hz"


def check_quick(contrib, program):
    """All sections of the first seconds, which have no event."""
    command = [sys.executable, "-m", "experiments.results", "--quick",
               "--program", program]
    run = subprocess.run(command, cwd=contrib, capture_output=True, text=True)
    if run.returncode != 0:
        yield f"--quick ends with status {run.returncode}: {run.stderr[-2000:]}"
    for expected in ("| vertices of the mesh | 1,274 | 1,274 | 1,274 |",
                     "| vertices of the mesh | 4,057 | 4,057 | 4,057 |"):
        if expected not in run.stdout:
            yield f"--quick does not say '{expected}'"


def main():
    contrib = pathlib.Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(contrib))
    from experiments.results import block, history, inner, layers, ruptures, statistics

    failures = [
        *check_fronts(history, ruptures),
        *check_small_ones(ruptures, statistics),
        *check_block(block, layers),
        *check_spectrum(inner),
    ]
    if len(sys.argv) > 2:
        failures += check_quick(contrib, pathlib.Path(sys.argv[2]).resolve())
    print("\n".join(failures) or "All results are as they should be.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
