#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check the errors that contrib/accuracy gives, where they are known.

Usage: check_accuracy.py CONTRIB_DIRECTORY

Made-up runs with known shifts, a missing event, another mesh and known differences
of slip and slip rate; a made-up history, interpolated; and the derivatives of the
independent computation, against differences. Prints one line for each failure.
"""

import pathlib
import sys
import tempfile

import h5py
import numpy as np


def made_up_run(reduced, nodes=11, shift=0.0, slip=1.0, rate=-6.0):
    """A run whose slip is linear along the fault, in the form that is compared."""
    x = np.linspace(-2.5, 2.5, nodes)
    weight = np.full(nodes, 5.0 / (nodes - 1))
    weight[[0, -1]] /= 2
    starts = np.array([22.0, 24.0, 26.0, 28.0, 30.0]) + shift
    return {
        "x": x,
        "weight": weight,
        "slip": np.tile(slip * (x + 3.0), (2, 1)),
        "log10_rate": np.full((len(reduced.SAMPLE_TIMES), nodes), rate),
        "events": starts.tolist(),
        "event_times": np.stack((starts, starts + 0.2), axis=1),
        "summary": {"Run/simulated time": "40.5 s"},
    }


def check_errors(errors, reduced):
    reference = made_up_run(reduced)
    run = made_up_run(reduced, nodes=21, shift=0.01, slip=1.02, rate=-5.5)
    result, note = errors.compare(run, reference)
    for name, value in (
        ("shift_first_event_s", 0.01),
        ("error_event_time_s", 0.01),
        ("error_all_events_max_s", 0.01),
        ("events_matched", 5),
        ("error_slip", 0.02),
        ("slip_time_s", 40.0),
        ("error_log10_slip_rate", 0.5),
        ("error_log10_slip_rate_median", 0.5),
    ):
        if not np.isclose(result.get(name, np.nan), value, rtol=1e-6):
            yield f"{name} is {result.get(name)} in place of {value}"
    if note:
        yield f"there is nothing to note, but '{note}'"

    del run["events"][3]
    run["log10_rate"][:] = reference["log10_rate"][:] = -16.0
    result, note = errors.compare(run, reference)
    if note != "events missing: 1" or result["events_matched"] != 4:
        yield f"a missing event is noted as '{note}'"
    if "error_log10_slip_rate" in result:
        yield "slip rates of a fault that is stuck are compared"


def check_reduction(reduced):
    """Fields that are linear in time, and records that end before the last time."""
    time = np.array([0.0, 10.0, 28.0, 30.0])
    with tempfile.TemporaryDirectory() as name:
        path = pathlib.Path(name)
        (path / "files").mkdir()
        with h5py.File(path / "files/faults.h5", "w") as file:
            group = file.create_group("fault")
            # Nodes may come in any order.
            group["coordinates"] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 0.0]]
            group["weight"], group["time"] = [0.5, 0.5, 1.0], time
            group["slip"] = np.outer(time, [1.0, 2.0, 3.0])
            group["slip_rate"] = -(10.0 ** (-np.outer(time, [1.0, 0.1, 0.2])))
        reduced.reduce(path, "fault")
        arrays = reduced.load(path)
    if not np.allclose(arrays["slip"][0], 28.4 * np.array([2.0, 3.0, 1.0])):
        yield f"the slip is {arrays['slip'][0]}"
    if not np.isnan(arrays["slip"][1]).all():
        yield "there is slip after the last record"
    at_ten = arrays["log10_rate"][100]
    if not np.allclose(at_ten, [-1.0, -2.0, -10.0], atol=1e-5):
        yield f"the logarithms of the slip rates are {at_ten}"


def check_derivatives(independent):
    """At a state like those of an event, one column after the other."""
    slider = independent.Slider()
    n, m = slider.n_bodies, slider.n_fault
    generator = np.random.default_rng(1)
    z = slider.start() + 1e-6 * generator.normal(size=2 * n + 3 * m)
    z[2 * n + m : 2 * n + 2 * m] = 60 + generator.normal(size=m)
    jacobian = slider.jacobian(2.0, z)
    for i in range(len(z)):
        step = np.zeros(len(z))
        step[i] = 1e-6 * max(1e-3, abs(z[i]))
        difference = slider.right_hand_side(2.0, z + step)
        difference -= slider.right_hand_side(2.0, z - step)
        error = np.abs(difference / (2 * step[i]) - jacobian[:, i]).max()
        if error > 1e-3 * np.abs(jacobian[:, i]).max():
            yield f"column {i} of the Jacobian is wrong by {error}"
    weight = independent.DENSITY * independent.GRAVITY * independent.THICKNESS
    mean = slider.weight @ slider.normal_stress / independent.LENGTH
    if not np.isclose(mean, weight):
        yield f"the mean normal stress is {mean} Pa in place of {weight} Pa"


def main():
    sys.path.insert(0, sys.argv[1])
    from experiments.accuracy import errors, independent, reduced

    failures = [
        *check_errors(errors, reduced),
        *check_reduction(reduced),
        *check_derivatives(independent),
    ]
    print("\n".join(failures) or "All errors are as they should be.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
