# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Time schemes for a bar with one node that may touch a wall.

With mass M, stiffness K and the unit vector e of the node that hits,

    M u'' + K u = p e,    g = g0 + u_0 >= 0,    p >= 0,    p g = 0.

A scheme has a name, is made of a bar in finite elements (bar.Elements) and a step
size, and `step(u, v)` gives displacement, velocity and pressure after a step. Each
step is linear but for the bound, so that one number tells the rest: the solution
without contact, and that of a unit force at the node.
"""

import numpy as np


class Scheme:
    def __init__(self, bar, tau):
        self.bar, self.tau = bar, tau
        self.M, self.K = bar.mass, bar.stiffness
        self.prepare()

    def prepare(self):
        """Matrices of the step size."""

    def factor(self, matrix):
        self.inverse = np.linalg.inv(matrix)
        self.of_force = self.inverse[:, 0]

    def bounded(self, rhs, bound):
        """The minimiser whose first entry is not less than the bound, and the
        force that keeps it there."""
        w = self.inverse @ rhs
        force = (bound - w[0]) / self.of_force[0]
        if force <= 0:
            return w, 0.0
        w += force * self.of_force
        w[0] = bound
        return w, force


class Newmark(Scheme):
    """Newmark's method with the gap at the end of the step bounded; the old
    acceleration contains the old reaction."""

    name = "Newmark with a bound on the displacement"

    def prepare(self):
        self.factor(4 / self.tau**2 * self.M + self.K)
        self.a = np.zeros(len(self.M))

    def step(self, u, v):
        known = self.M @ (4 / self.tau**2 * (u + self.tau * v) + self.a)
        new, force = self.bounded(known, -self.bar.bar.gap)
        a = 4 / self.tau**2 * (new - u - self.tau * v) - self.a
        v = v + self.tau / 2 * (self.a + a)
        self.a = a
        return new, v, force


class NewmarkVelocity(Scheme):
    """The same with the velocity at the end of the step bounded where the gap
    would close within the step."""

    name = "the same with a bound on the velocity"

    def prepare(self):
        self.factor(2 / self.tau * self.M + self.tau / 2 * self.K)
        self.a = np.zeros(len(self.M))

    def step(self, u, v):
        tau = self.tau
        rhs = self.M @ (2 / tau * v + self.a) - self.K @ (u + tau / 2 * v)
        closes = self.bar.gap(u) + tau / 2 * v[0] <= 0
        new, force = self.bounded(rhs, 0.0 if closes else -np.inf)
        self.a = 2 / tau * (new - v) - self.a
        return u + tau / 2 * (v + new), new, force


class ContactImplicit(Scheme):
    """Trapezoidal rule for the elastic force, the reaction implicit (Kane and
    others 1999): the gap at the end of the step is bounded."""

    name = "contact implicit, not projected"

    def prepare(self):
        self.factor(2 / self.tau * self.M + self.tau / 2 * self.K)

    def step(self, u, v):
        tau = self.tau
        rhs = self.M @ (2 / tau * v) - self.K @ (2 * u + tau / 2 * v)
        bound = -2 * self.bar.gap(u) / tau - v[0]
        new, force = self.bounded(rhs, bound)
        u = u + tau / 2 * (v + new)
        if force > 0:
            u[0] = -self.bar.bar.gap
        return u, self.after(new, force > 0), force / 2

    def after(self, v, is_closed):
        return v


class Projected(ContactImplicit):
    """The same, and at the end of a step that ends in contact the velocity is
    projected onto those that keep the gap closed."""

    name = "**contact implicit, projected**"

    def prepare(self):
        super().prepare()
        self.of_impulse = np.linalg.inv(self.M)[:, 0]

    def after(self, v, is_closed):
        if not is_closed:
            return v
        v = v - v[0] / self.of_impulse[0] * self.of_impulse
        v[0] = 0
        return v


class Moreau(Scheme):
    """Trapezoidal rule; an impulse that stops the node if the gap in the middle of
    the step, as the old velocity tells it, is closed (Moreau 1999)."""

    name = "Moreau"

    def prepare(self):
        self.factor(2 / self.tau * self.M + self.tau / 2 * self.K)

    def step(self, u, v):
        tau = self.tau
        rhs = self.M @ (2 / tau * v) - self.K @ (2 * u + tau / 2 * v)
        closes = self.bar.gap(u) + tau / 2 * v[0] <= 0
        new, force = self.bounded(rhs, 0.0 if closes else -np.inf)
        return u + tau / 2 * (v + new), new, force / 2


class Stabilised(Scheme):
    """Contact-stabilised Newmark's method: the predictor is projected onto
    admissible displacements (Deuflhard, Krause and Ertel 2008)."""

    name = "contact-stabilised (Deuflhard, Krause, Ertel 2008)"

    def prepare(self):
        self.factor(self.M + self.tau**2 / 4 * self.K)
        self.of_impulse = np.linalg.inv(self.M)[:, 0]

    def step(self, u, v):
        tau, wall = self.tau, -self.bar.bar.gap
        predicted = u + tau * v
        if predicted[0] < wall:
            predicted += (wall - predicted[0]) / self.of_impulse[0] * self.of_impulse
        rhs = self.M @ predicted - tau**2 / 4 * (self.K @ u)
        new, force = self.bounded(rhs, wall)
        # M (new - predicted) is tau^2 / 2 of all forces.
        return new, v + 2 / tau * (new - predicted), 2 * force / tau**2


class GeneralisedAlpha(Scheme):
    """Generalised alpha (Chung and Hulbert 1993) with the gap at the end of the step
    bounded. The reaction is interpolated between the old and the new one, as all
    other forces are."""

    name = "generalised alpha, 0.8, with a bound on the displacement"
    rho = 0.8

    def prepare(self):
        rho = self.rho
        self.m, self.f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
        self.gamma = 0.5 - self.m + self.f
        self.beta = (1 - self.m + self.f) ** 2 / 4
        self.factor((1 - self.m) / (self.beta * self.tau**2) * self.M
                    + (1 - self.f) * self.K)
        self.a = np.zeros(len(self.M))
        self.old_share, self.new_share, self.reaction = self.f, 1 - self.f, 0.0

    def step(self, u, v):
        tau, beta, gamma = self.tau, self.beta, self.gamma
        past = u + tau * v + (0.5 - beta) * tau**2 * self.a
        rhs = (self.M @ ((1 - self.m) / (beta * tau**2) * past - self.m * self.a)
               - self.f * self.K @ u)
        rhs[0] += self.old_share * self.reaction
        new, force = self.bounded(rhs, -self.bar.bar.gap)
        a = (new - past) / (beta * tau**2)
        v = v + tau * ((1 - gamma) * self.a + gamma * a)
        self.a, self.reaction = a, force / self.new_share
        return new, v, self.reaction


class GeneralisedAlphaOfStep(GeneralisedAlpha):
    """The same with one reaction for the whole step."""

    name = "the same, one reaction for the whole step"

    def prepare(self):
        super().prepare()
        self.old_share, self.new_share = 0, 1


class ImplicitEuler(Scheme):
    name = "implicit Euler"

    def prepare(self):
        self.factor(self.M / self.tau**2 + self.K)

    def step(self, u, v):
        new, force = self.bounded(
            self.M @ (u / self.tau**2 + v / self.tau), -self.bar.bar.gap)
        return new, (new - u) / self.tau, force


class Massless(Scheme):
    """The node that hits has no mass (Khenous, Laborde and Renard 2008): that of its
    element is its neighbour's, and it follows the bar or lies on the wall.
    Trapezoidal rule for the other nodes, the contact force being one of the forces
    on them."""

    name = "massless contact nodes, implicit contact"

    def prepare(self):
        h, rho, tau = self.bar.h, self.bar.bar.density, self.tau
        self.inner_mass = self.M[1:, 1:].copy()
        self.inner_mass[0, 0] += 2 / 3 * rho * h
        self.bond = self.bar.bar.modulus / h
        inner = 2 / tau * self.inner_mass + tau / 2 * self.K[1:, 1:]
        self.closed = np.linalg.inv(inner)
        # An open node follows its neighbour, so that their bond is free.
        inner[0, 0] -= tau / 2 * self.bond
        self.free = np.linalg.inv(inner)

    def force(self, u):
        """Of the bar upon its nodes but the first, and the pressure."""
        pressure = max(0.0, self.bond * (-self.bar.bar.gap - u[1]))
        result = -self.K[1:, 1:] @ u[1:]
        result[0] += self.bond * u[1] + pressure
        return result, pressure

    def step(self, u, v):
        tau, wall = self.tau, -self.bar.bar.gap
        rhs = self.inner_mass @ (2 / tau * v[1:]) + self.force(u)[0]
        middle = u[1:] + tau / 2 * v[1:]
        inner = self.K[1:, 1:] @ middle
        shift = np.zeros_like(inner)
        shift[0] = 1
        w = self.free @ (rhs - inner + self.bond * middle[0] * shift)
        if u[1] + tau / 2 * (v[1] + w[0]) < wall:
            w = self.closed @ (rhs - inner + self.bond * wall * shift)
        new = u.copy()
        new[1:] += tau / 2 * (v[1:] + w)
        new[0] = max(wall, new[1])
        first = (new[0] - u[0]) / tau
        return new, np.concatenate(([first], w)), self.force(new)[1]

    def energy(self, u, v):
        return (v[1:] @ self.inner_mass @ v[1:] + u @ self.K @ u) / 2


SCHEMES = (Newmark, NewmarkVelocity, ContactImplicit, Moreau, Projected, Stabilised,
           GeneralisedAlpha, GeneralisedAlphaOfStep, ImplicitEuler, Massless)
