# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""What the comparison of runs needs of their fault histories.

The histories have some thousand records at times of their own. What is kept of each
are the slip at two times and the slip rates at common times.
"""

import csv

import h5py
import numpy as np

# s: in quiet loading, after the fourth event and after the eleventh or twelfth.
SLIP_TIMES = (28.4, 40.0)
# s: from after the ramp on, until the slip is compared.
SAMPLE_TIMES = np.linspace(5.0, 40.0, 701)
# m/s: below this a fault is stuck, whatever the number.
SMALLEST_RATE = 1e-16


def reduce(path, fault):
    """Write arrays.npz next to the program's files, of what there is of a fault."""
    arrays = {}
    history = path / "files/faults.h5"
    if history.is_file():
        arrays = history_arrays(history, fault)
    catalogue = path / "files/events.csv"
    if catalogue.is_file():
        with open(catalogue, newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["fault"] == fault]
        arrays["event_times"] = np.array(
            [(float(row["start"]), float(row["end"])) for row in rows]
        ).reshape(-1, 2)
    np.savez_compressed(path / "arrays.npz", **arrays)


def history_arrays(history, fault):
    with h5py.File(history, "r") as file:
        group = file[fault]
        if group["time"].size < 2:
            return {}
        x = np.array(group["coordinates"])[:, 0]
        weight = np.array(group["weight"]).ravel()
        time = np.array(group["time"]).ravel()
        slip = np.array(group["slip"]).reshape(len(time), len(x))
        rate = np.abs(np.array(group["slip_rate"])).reshape(len(time), len(x))
    order = np.argsort(x, kind="stable")
    logarithm = np.log10(np.maximum(rate, SMALLEST_RATE))
    return {
        "x": x[order],
        "weight": weight[order],
        "slip": at_times(time, slip, SLIP_TIMES)[:, order],
        "log10_rate": at_times(time, logarithm, SAMPLE_TIMES)[:, order].astype(
            np.float32
        ),
    }


def at_times(time, values, wanted):
    """Linear interpolation between records; nan outside of them."""
    wanted = np.asarray(wanted)
    right = np.clip(np.searchsorted(time, wanted), 1, len(time) - 1)
    part = (wanted - time[right - 1]) / (time[right] - time[right - 1])
    inside = (part >= 0) & (part <= 1)
    part = np.where(inside, part, np.nan)[:, None]
    return (1 - part) * values[right - 1] + part * values[right]


def load(path):
    with np.load(path / "arrays.npz") as arrays:
        return dict(arrays)
