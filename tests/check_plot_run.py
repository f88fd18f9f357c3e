#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that contrib/tools/plot_run.py draws a run in the program's formats.

Usage: check_plot_run.py PLOT_RUN [OUTPUT_DIRECTORY]

Writes the files of a made-up run, with periodic events that start in the
middle of the fault, and has them drawn; likewise a run without events, and one
in three dimensions. A missing file must give one sentence and status 1. With
OUTPUT_DIRECTORY the made-up run is kept there.
"""

import pathlib
import subprocess
import sys
import tempfile

import h5py
import matplotlib.image
import numpy as np

FAULT = "fault"
PERIOD, FIRST = 1.5, 21.0
SERIES = (
    "step,time,step_size,rate_state_iterations,tnnmg_iterations,"
    "multigrid_cycles"
)
FAULT_SERIES = (
    "max_slip_rate", "mean_slip_rate", "min_slip_rate", "mean_slip",
    "mean_state", "mean_shear_traction",
)
EVENTS = (
    "fault,start,peak_time,end,peak_mean_slip_rate,peak_slip_rate,mean_slip,"
    "nucleation_x"
)


def slip_rate(t, x):
    """Growth to both sides from the middle, once in every period."""
    background = 1e-12 * np.exp(np.minimum(t, FIRST)[:, None] + 0 * x)
    since = (t - FIRST) % PERIOD
    since[t < FIRST] = -1.0
    distance = since[:, None] - np.abs(x) / 25.0
    return background + 2e-2 * np.exp(-((distance - 0.02) / 0.01) ** 2)


def write_run(directory, with_events=True, dim=2):
    x = np.linspace(-2.5, 2.5, 41)
    t = np.concatenate((
        np.linspace(0.0, FIRST, 100, endpoint=False),
        np.arange(FIRST, 30.0 if with_events else FIRST + 1e-9, 5e-3),
    ))
    rate = slip_rate(t, x)
    points = np.stack([x] + [np.zeros_like(x)] * (dim - 1), axis=1)
    if dim == 3:
        points = np.concatenate((points, points + [0.0, 1.0, 0.0]))
        rate = np.concatenate((rate, 0.5 * rate), axis=1)
    weight = np.full(len(points), 5.0 / len(points))

    values = np.stack((
        rate.max(axis=1), rate.mean(axis=1), rate.min(axis=1), 2e-4 * t,
        1.0 + 0 * t, 2.5e4 + 0 * t,
    ), axis=1)
    with open(directory / "time_series.csv", "w", encoding="utf-8") as file:
        columns = [f"{FAULT}.{name}" for name in FAULT_SERIES]
        file.write(",".join([SERIES] + columns) + "\n")
        for i, row in enumerate(values):
            step = t[i] - t[i - 1] if i else 1e-3
            file.write(f"{i},{t[i]:.17g},{step:.17g},{2 + i % 3},{4 + i % 5},{12 + i % 9},")
            file.write(",".join(f"{v:.17g}" for v in row) + "\n")
    with open(directory / "events.csv", "w", encoding="utf-8") as file:
        file.write(EVENTS + "\n")
        for start in np.arange(FIRST, 30.0 - 0.2, PERIOD) if with_events else ():
            file.write(f"{FAULT},{start},{start + 0.05},{start + 0.13},5e-3,2e-2,"
                       "3e-4,0\n")

    shape = rate.shape + ((dim - 1,) if dim == 3 else ())
    vectors = np.zeros(shape)
    if dim == 3:
        vectors[..., 0] = rate
    else:
        vectors[...] = rate
    with h5py.File(directory / "faults.h5", "w") as file:
        group = file.create_group(FAULT)
        group["coordinates"], group["weight"], group["time"] = points, weight, t
        group["slip_rate"] = vectors
        group["slip"] = np.zeros(shape)
        group["shear_traction"] = np.zeros(shape)
        group["state"] = np.ones(rate.shape)
        group["normal_stress"] = np.full(rate.shape, 4.9e4)


def plot(script, directory):
    return subprocess.run(
        [sys.executable, script, str(directory)], capture_output=True, text=True
    )


def check(script, directory, **options):
    """Draw one made-up run; return what is wrong with the figure, if anything."""
    write_run(directory, **options)
    run = plot(script, directory)
    if run.returncode != 0 or run.stderr:
        return f"{options}: status {run.returncode}: {run.stderr}"
    image = matplotlib.image.imread(directory / "run.png")[..., :3]
    if image.shape[0] < 1000 or image.shape[1] < 1000:
        return f"{options}: the figure has only {image.shape[:2]} pixels"
    # The map of slip rates covers a part of the figure with colour.
    coloured = (image.max(axis=2) - image.min(axis=2) > 0.2).mean()
    if coloured < 0.1:
        return f"{options}: only {coloured:.1%} of the figure is coloured"
    return None


def main():
    script = sys.argv[1]
    errors = []
    with tempfile.TemporaryDirectory() as name:
        for i, options in enumerate((
            {}, {"with_events": False}, {"dim": 3},
        )):
            directory = pathlib.Path(name, str(i))
            directory.mkdir()
            errors.append(check(script, directory, **options))
        directory = pathlib.Path(name, "0")
        with h5py.File(directory / "faults.h5", "a") as file:
            del file[FAULT]["slip_rate"]
        for what in ("slip rates", "faults.h5"):
            run = plot(script, directory)
            if run.returncode != 1 or len(run.stderr.splitlines()) != 1:
                errors.append(f"without {what}: {run.returncode}: {run.stderr}")
            (directory / "faults.h5").unlink(missing_ok=True)
    if len(sys.argv) > 2:
        pathlib.Path(sys.argv[2]).mkdir(parents=True, exist_ok=True)
        write_run(pathlib.Path(sys.argv[2]))
    errors = [error for error in errors if error]
    print("\n".join(errors) or "All figures drawn.")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
