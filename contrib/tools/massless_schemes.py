#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Which formula suits bodies without mass?

Usage: massless_schemes.py [--check]

A layer without mass and viscosity hangs on a driven side, w(t), and slides on a
fault with a traction eta V. With slip d and the displacement m of its middle,

    2 k (w - m + q) = 2 k (m - d),    eta V = 2 k (m - d),    d' = V,

where q stands for a load on the middle.

The first equation holds at each moment: the middle follows at once. All formulas
give the displacement after a step from the velocity at its end, which is the
unknown, as in the program. Prints the table of doc/inertia.md: the largest
errors of slip and of the velocity of the middle in the second half of the time,
their orders, with steps of one size and with steps that change, and the swing of
the velocity of the middle from step to step, over its mean, that is left of the
moment at which the load begins to grow.

With --check the status is 1 unless the orders are those expected of the program's
formula, and nothing swings.
"""

import argparse
import sys

import numpy as np

K, ETA, END = 1.0, 0.3, 2.0
OMEGA = 3.0


class Trapezoidal:
    name = "trapezoidal rule"

    def weights(self, tau, last):
        """The displacement changes by tau (p past + q end)."""
        return 0.5, 0.5

    def start(self, v):
        return v

    def past(self, v, mean, past):
        return v


class ImplicitEuler(Trapezoidal):
    name = "implicit Euler"

    def weights(self, tau, last):
        return 0.0, 1.0


class GeneralisedAlpha(Trapezoidal):
    """Of first order systems (Jansen, Whiting and Hulbert 2000), with the
    equation at the end of the step."""

    def __init__(self, rho):
        self.name = f"generalised alpha, {rho:g}"
        self.m = (3 * rho - 1) / (2 * (1 + rho))
        self.f = rho / (1 + rho)
        self.g = 0.5 - self.m + self.f
        self.a = None

    def start(self, v):
        self.a = v
        return self.combined(v)

    def combined(self, v):
        g, m, f = self.g, self.m, self.f
        return (1 - g) * self.a + g * (f * v - m * self.a) / (1 - m)

    def weights(self, tau, last):
        return 1.0, self.g * (1 - self.f) / (1 - self.m)

    def past(self, v, mean, past):
        # The mean of the auxiliary velocities is that of the step.
        self.a = (mean - (1 - self.g) * self.a) / self.g
        return self.combined(v)


class BackwardDifferences(Trapezoidal):
    name = "backward differences"

    def weights(self, tau, last):
        return tau / (last + 2 * tau), (last + tau) / (last + 2 * tau)

    def past(self, v, mean, past):
        return mean


def formulas():
    return [
        Trapezoidal(), ImplicitEuler(), GeneralisedAlpha(0.8),
        GeneralisedAlpha(0.5), BackwardDifferences(),
    ]


def run(formula, steps, velocity, load):
    """Slip and velocity of the middle after each step, from rest in
    equilibrium: displacements of driven side, middle and fault."""
    u = np.zeros(3)
    v = np.zeros(3)
    past, last, t = formula.start(v), 0.0, 0.0
    slips, middles, times = [], [], []
    for tau in steps:
        p, q = formula.weights(tau, last)
        t += tau
        known = u + tau * p * past
        w = known[0] + tau * q * velocity(t)
        # Unknowns: velocities of the middle and of the fault.
        matrix = np.array(
            [[2 * tau * q, -tau * q], [-2 * K * tau * q, 2 * K * tau * q + ETA]]
        )
        rhs = np.array(
            [
                w + load(t) - 2 * known[1] + known[2],
                2 * K * (known[1] - known[2]),
            ]
        )
        v = np.array([velocity(t), *np.linalg.solve(matrix, rhs)])
        mean = p * past + q * v
        u = u + tau * mean
        past, last = formula.past(v, mean, past), tau
        times.append(t)
        slips.append(u[2])
        middles.append(v[1])
    return np.array(times), np.array(slips), np.array(middles)


def smooth(t):
    return np.sin(OMEGA * t)


def nothing(t):
    return 0.0


def growing(t):
    """From the start on, all at once."""
    return t


def exact(t):
    """Slip and velocity of the middle for the smooth motion: the slip obeys
    eta d' + k d = k w with w = (1 - cos(omega t)) / omega."""
    r = K / ETA
    c = r / (r * r + OMEGA * OMEGA)
    oscillation = c * (r * np.cos(OMEGA * t) + OMEGA * np.sin(OMEGA * t))
    slip = (1 - oscillation - (1 - c * r) * np.exp(-r * t)) / OMEGA
    w = (1 - np.cos(OMEGA * t)) / OMEGA
    slip_rate = r * (w - slip)
    return slip, (slip_rate + smooth(t)) / 2


def step_sizes(n, changing):
    """Steps that are doubled and halved in turn, or not at all."""
    sizes = np.ones(n)
    if changing:
        pattern = np.array([1, 1, 0.5, 0.5, 0.25, 0.5, 0.5, 1])
        sizes = np.resize(pattern, n)
    return sizes * END / sizes.sum()


def errors(formula, n, changing):
    t, slip, middle = run(formula, step_sizes(n, changing), smooth, nothing)
    late = t > END / 2
    exact_slip, exact_middle = exact(t[late])
    return np.array(
        [
            np.abs(slip[late] - exact_slip).max(),
            np.abs(middle[late] - exact_middle).max(),
        ]
    )


def swing(formula):
    """What alternates after 200 steps, over the mean."""
    middle = run(formula, np.full(200, 0.1), nothing, growing)[2][-20:]
    alternating = middle[2:] - 2 * middle[1:-1] + middle[:-2]
    return np.abs(alternating).mean() / 4 / middle.mean()


def rows():
    for formula in formulas():
        values = []
        for changing in (False, True):
            fine = errors(formula, 640, changing)
            finer = errors(formula, 1280, changing)
            values += [*fine, *np.log2(fine / finer)]
        yield formula.name, values, swing(formula)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    print(
        "| formula | error of slip | of velocity | orders "
        "| changing steps: error of slip | of velocity | orders | swing |\n"
        "|---|---|---|---|---|---|---|---|"
    )
    good = True
    for name, v, left in rows():
        print(
            f"| {name} | {v[0]:.1e} | {v[1]:.1e} | {v[2]:.2f}, {v[3]:.2f} "
            f"| {v[4]:.1e} | {v[5]:.1e} | {v[6]:.2f}, {v[7]:.2f} | {left:.0e} |"
        )
        if name == BackwardDifferences.name:
            orders = np.array([v[2], v[3], v[6], v[7]])
            good = np.all(np.abs(orders - 2) < 0.1) and left < 1e-6
    if arguments.check and not good:
        sys.exit(1)


if __name__ == "__main__":
    main()
