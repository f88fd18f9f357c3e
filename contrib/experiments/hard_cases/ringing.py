# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Oscillations after the first event of the spring slider without viscosity."""

import h5py
import numpy as np

from .run import run
from .scene import slider, text

# The event begins at 22.276 s.
BEGINS, LENGTH, SAMPLES = (22.33, 22.5), 0.1, 4096
# Frequencies above this, in Hz, belong to waves shorter than six cells at the
# fault.
HIGH = 300.0


def scene():
    """Without viscosity, with a record of every step."""
    elastic = {
        f"Bodies/{body}/Material/{kind} viscosity": "0"
        for body in ("lower", "upper")
        for kind in ("Shear", "Bulk")
    }
    return slider(
        BEGINS[-1] + LENGTH + 0.05,
        elastic | {
            "Output/Fault shortest interval": "0",
            "Output/Fault slip rate factor": "1.0000001",
        },
    )


def analyse(folder, begin):
    """Reversals of slip, the share of steps in which the acceleration of a node
    changes its sign, and the share of high frequencies in the power of the slip
    rate in the middle of the fault."""
    with h5py.File(folder / "output" / "faults.h5", "r") as file:
        group = file["fault1"]
        time = np.array(group["time"]).ravel()
        rate = np.array(group["slip_rate"])
        x = np.array(group["coordinates"])[:, 0]
    rate = rate.reshape(len(time), len(x))
    after = (time >= begin) & (time <= begin + LENGTH)
    # The slip rates of stuck nodes have signs that mean nothing.
    moving = np.where(np.abs(rate[after]) > 1e-9, np.sign(rate[after]), 0)
    acceleration = np.sign(np.diff(rate[after], axis=0))

    uniform = np.linspace(begin, begin + LENGTH, SAMPLES)
    middle = np.interp(uniform, time, rate[:, np.argmin(np.abs(x))])
    middle -= middle.mean()
    power = np.abs(np.fft.rfft(middle * np.hanning(SAMPLES))) ** 2
    frequency = np.fft.rfftfreq(SAMPLES, LENGTH / SAMPLES)
    return {
        "steps": int(np.sum(after)),
        "reversals": int(np.sum(moving[1:] * moving[:-1] < 0)),
        "sign changes": float(np.mean(acceleration[1:] * acceleration[:-1] < 0)),
        "high": float(power[frequency > HIGH].sum() / power.sum()),
    }


def measure(program, folder):
    """Print a line."""
    result = run(program, text(scene()), folder, 600)
    print(
        result.message or result.number("Steps/accepted"),
        *result.events[:1],
        result.number("Energy/missing, over the largest work"),
        *(analyse(folder, begin) for begin in BEGINS),
        flush=True,
    )
