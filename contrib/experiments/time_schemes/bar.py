# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""A bar that hits a rigid wall: the exact solution, and the bar in finite elements.

A bar of length L, modulus E and density rho, per unit of its cross-section, flies
with speed v0 towards a wall, undeformed and at a distance g0. It touches at
t1 = g0 / v0, a wave of compression runs to its free end with c = sqrt(E / rho) and
back as one of tension, and after 2 L / c it leaves undeformed with the speed that it
came with: in between the wall is pressed by rho c v0. With s = t - t1 the
displacement of the point at a distance x from the end that hits is

    u(x, t) = -g0 - v0 min(s, x / c) + v0 max(0, s - (2 L - x) / c)

at all times, which is d'Alembert's sum of waves (the benchmark of Doyen, Ern and
Piperno 2011 without weight).
"""

import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Bar:
    """In units of one's choice; SI: m, Pa, kg/m^3, m/s, m."""

    length: float = 1.0
    modulus: float = 1.0
    density: float = 1.0
    speed: float = 1.0
    gap: float = 0.25

    @property
    def wave_speed(self):
        return np.sqrt(self.modulus / self.density)

    @property
    def impact(self):
        """When the bar touches the wall."""
        return self.gap / self.speed

    @property
    def duration(self):
        """How long it stays there."""
        return 2 * self.length / self.wave_speed

    @property
    def energy(self):
        return self.density * self.length * self.speed**2 / 2

    def displacement(self, x, t):
        s, c, v = t - self.impact, self.wave_speed, self.speed
        return -self.gap - v * np.minimum(s, x / c) + v * np.maximum(
            0, s - (2 * self.length - x) / c)

    def velocity(self, x, t):
        s, c, v = t - self.impact, self.wave_speed, self.speed
        return -v * (s < x / c) + v * (s > (2 * self.length - x) / c)

    def pressure(self, t):
        s = t - self.impact
        return self.density * self.wave_speed * self.speed * (
            (s > 0) & (s < self.duration))


class Elements:
    """The bar in n linear elements; the first node is the one that hits."""

    def __init__(self, bar, n):
        self.bar, self.n = bar, n
        self.h = h = bar.length / n
        self.x = np.linspace(0, bar.length, n + 1)
        self.mass, self.stiffness = np.zeros((2, n + 1, n + 1))
        for e in range(n):
            part = np.s_[e:e + 2, e:e + 2]
            self.mass[part] += bar.density * h / 6 * np.array([[2, 1], [1, 2]])
            self.stiffness[part] += bar.modulus / h * np.array([[1, -1], [-1, 1]])
        self.start = np.zeros(n + 1), np.full(n + 1, -bar.speed)

    def energy(self, u, v):
        return (v @ self.mass @ v + u @ self.stiffness @ u) / 2

    def gap(self, u):
        return self.bar.gap + u[0]
