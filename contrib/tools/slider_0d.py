#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The spring slider without space: which characteristic slip L gives events?

Usage: slider_0d.py [-o FIGURE] [--check]

Two layers of thickness h lie on each other; the lower one is held at its
bottom, the upper one is moved at its top by w(t). If the displacement of each
varies linearly over its thickness, the slip d between them obeys

    m V' = k (w - d) + c (w' - V) - r V - sigma_n a asinh(V / (2 Vmin(alpha))),
    d' = V,    alpha' = exp(-alpha) - V / L,

per unit area, with k = G / (2 h), c = eta / (2 h), m = rho h / 6 and
sigma_n = rho g h. The radiation damping r = sqrt(rho G) / 2 (Rice 1993) stands
for the waves that leave the fault; without it (r = 0) each event overshoots as
far as it can. Integrated in d, ln V and alpha = ln(theta) by the implicit
Runge-Kutta method Radau IIA. See doc/printed_characteristic_slip.md.

With --check the status is 1 unless L = 2e-5 m gives 20 to 30 events in 60 s
with radiation damping and at least 10 without it, and L = 0.02 m creeps at the
loading velocity.
"""

import argparse
import sys

import numpy as np
from scipy.integrate import solve_ivp

# SI units, as in the published table of parameters.
YOUNGS_MODULUS, POISSONS_RATIO, DENSITY, GRAVITY = 4.12e7, 0.3, 5e3, 9.81
THICKNESS, SHEAR_VISCOSITY = 1.0, 1e3
A, B, MU0, V0 = 0.010, 0.015, 0.6, 1e-6
LOADING_RATE, RAMP, END_TIME = 2e-4, 1.0, 60.0

SHEAR_MODULUS = YOUNGS_MODULUS / (2 * (1 + POISSONS_RATIO))
STIFFNESS = SHEAR_MODULUS / (2 * THICKNESS)
DAMPING = SHEAR_VISCOSITY / (2 * THICKNESS)
MASS = DENSITY * THICKNESS / 6
RADIATION_DAMPING = np.sqrt(DENSITY * SHEAR_MODULUS) / 2
NORMAL_STRESS = DENSITY * GRAVITY * THICKNESS

# Below this slip rate inertia means nothing, and dividing by a vanishing V
# would only make the equations needlessly stiff.
INERTIA_FLOOR = 1e-13


def loading(t):
    """Displacement and velocity of the top, ramped up by half a cosine."""
    if t >= RAMP:
        return LOADING_RATE * (t - RAMP / 2), LOADING_RATE
    phase = np.pi * t / RAMP
    displacement = LOADING_RATE / 2 * (t - RAMP / np.pi * np.sin(phase))
    return displacement, LOADING_RATE / 2 * (1 - np.cos(phase))


def log_v_min(alpha, length):
    return np.log(V0) - (MU0 + B * (alpha + np.log(V0 / length))) / A


def right_hand_side(t, y, length, radiation):
    slip, log_v, alpha = y
    v = np.exp(log_v)
    w, w_t = loading(t)
    friction = A * np.arcsinh(0.5 * np.exp(log_v - log_v_min(alpha, length)))
    force = STIFFNESS * (w - slip) + DAMPING * (w_t - v) - radiation * v
    acceleration = (force - NORMAL_STRESS * friction) / MASS
    return [v, acceleration / (v + INERTIA_FLOOR), np.exp(-alpha) - v / length]


def simulate(length, radiation):
    """Times, slip rates and states from rest with theta = 1 s."""
    start = [0.0, log_v_min(0.0, length) - 10.0, 0.0]
    solution = solve_ivp(
        right_hand_side,
        (0.0, END_TIME),
        start,
        method="Radau",
        args=(length, radiation),
        rtol=1e-6,
        atol=[1e-12, 1e-6, 1e-6],
        max_step=0.1,
    )
    if not solution.success:
        raise RuntimeError(solution.message)
    return solution.t, np.exp(solution.y[1]), np.exp(solution.y[2])


def find_events(t, v):
    """Start of each event: V rises above twice the loading rate, and falls
    below half of that before the next one."""
    starts, active = [], False
    for time, rate in zip(t, v):
        if not active and rate > 2 * LOADING_RATE:
            active = True
            starts.append(time)
        elif active and rate < LOADING_RATE:
            active = False
    return np.array(starts)


def report(length, radiation, t, v):
    starts = find_events(t, v)
    critical = (B - A) * NORMAL_STRESS / length
    late = v[t > 40.0]
    print(f"L = {length:g} m, {label(radiation)}")
    print(f"  critical stiffness (b-a) sigma_n / L  {critical:.3g} Pa/m,"
          f" k / critical = {STIFFNESS / critical:.3g}")
    print(f"  events until t = {END_TIME:g} s               {len(starts)}")
    if len(starts) > 1:
        gaps = np.diff(starts)
        print(f"  first event                           {starts[0]:.2f} s")
        print(f"  recurrence: median, least, largest    {np.median(gaps):.3f} s,"
              f" {gaps.min():.3f} s, {gaps.max():.3f} s")
    print(f"  slip rate, least and largest, t > 1 s {v[t > RAMP].min():.1e}"
          f" ... {v[t > RAMP].max():.1e} m/s")
    print(f"  the same, t > 40 s                    {late.min():.5g}"
          f" ... {late.max():.5g} m/s")
    return starts


def label(radiation):
    return "with radiation damping" if radiation else "without radiation damping"


def draw(runs, file_name):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(
        len(runs), 1, sharex=True, sharey=True, figsize=(8, 7.5),
        constrained_layout=True,
    )
    for axis, (length, radiation, t, v) in zip(axes, runs):
        axis.semilogy(t, v, color="#0072b2", linewidth=1)
        axis.axhline(LOADING_RATE, color="#d55e00", linestyle="--",
                     linewidth=1, label="loading velocity")
        axis.set_ylim(1e-14, 1)
        axis.set_xlim(0, END_TIME)
        axis.set_ylabel("slip rate [m/s]")
        axis.set_title(f"L = {length:g} m, {label(radiation)}", loc="left", fontsize=10)
        axis.grid(alpha=0.3)
    axes[0].legend(loc="lower right", frameon=False)
    axes[-1].set_xlabel("time [s]")
    figure.savefig(file_name, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", metavar="FIGURE", help="draw the runs")
    parser.add_argument("--check", action="store_true",
                        help="status 1 unless the runs are as described")
    arguments = parser.parse_args()

    print(f"Stiffness k = G / (2 h)               {STIFFNESS:.4g} Pa/m")
    print(f"Normal stress rho g h                 {NORMAL_STRESS:.4g} Pa")
    print(f"Stick-slip needs L < (b-a) sigma_n/k = "
          f"{(B - A) * NORMAL_STRESS / STIFFNESS:.3g} m")
    runs, events = [], []
    for length, radiation in (
        (2e-5, RADIATION_DAMPING), (2e-5, 0.0), (2e-2, RADIATION_DAMPING)
    ):
        t, v, _ = simulate(length, radiation)
        events.append(report(length, radiation, t, v))
        runs.append((length, radiation, t, v))
    if arguments.o:
        draw(runs, arguments.o)

    if arguments.check:
        _, _, t, v = runs[-1]
        creep = v[t > 40.0]
        as_described = (
            20 <= len(events[0]) <= 30
            and len(events[1]) >= 10
            and len(events[2]) == 0
            and np.all(np.abs(creep / LOADING_RATE - 1) < 0.03)
        )
        print("As described." if as_described else "Not as described.")
        return 0 if as_described else 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
