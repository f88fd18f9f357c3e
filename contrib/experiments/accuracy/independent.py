# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The spring slider on a coarse mesh, written down and integrated without stickslip.

Bilinear elements on rectangles that match across the fault, so that contact joins
equal nodes and friction acts on the jump of each pair, with the weight of its hat
function. In time the equations of motion and of state are integrated as one system
by the implicit Runge-Kutta method Radau IIA of SciPy (fifth order, error estimate of
its own), in the displacement w, the velocities of the bodies, alpha = ln(theta) and
y = asinh(V / (2 Vmin(alpha))), in which the friction coefficient is a y.

Nothing is taken from the program but its printed parameters. The law is arcsinh,
since the truncated one has a kink that a method of fifth order would feel.
"""

import numpy as np
import scipy.linalg
from scipy.integrate import solve_ivp

# SI units, as in parameters/spring_slider.prm.
YOUNG, POISSON, DENSITY, GRAVITY = 4.12e7, 0.3, 5e3, 9.81
SHEAR_VISCOSITY, BULK_VISCOSITY = 1e3, 1e3
LENGTH, THICKNESS = 5.0, 1.0
A, B, MU0, V0, L = 0.010, 0.015, 0.6, 1e-6, 2e-5
LOADING_RATE, RAMP = 2e-4, 1.0
# Cells of each body along x and y.
CELLS = (10, 2)
# m/s: inertia of the slip means nothing below it, see contrib/tools/slider_0d.py.
INERTIA_FLOOR = 1e-13


def material(shear, trace):
    """sigma = 2 shear epsilon + trace tr(epsilon) I for (xx, yy, 2 xy)."""
    return np.array([
        [2 * shear + trace, trace, 0], [trace, 2 * shear + trace, 0], [0, 0, shear]
    ])


def cell_matrices(hx, hy):
    """Mass, viscosity and stiffness of a rectangle, nodes counterclockwise."""
    shear = YOUNG / (2 * (1 + POISSON))
    lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    elastic = material(shear, lame)
    # The deviator is that of three dimensions.
    viscous = material(SHEAR_VISCOSITY, BULK_VISCOSITY - 2 / 3 * SHEAR_VISCOSITY)
    mass, damping, stiffness = (np.zeros((8, 8)) for _ in range(3))
    corner_x, corner_y = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
    for s in (-1 / np.sqrt(3), 1 / np.sqrt(3)):
        for t in (-1 / np.sqrt(3), 1 / np.sqrt(3)):
            value = (1 + corner_x * s) * (1 + corner_y * t) / 4
            dx = corner_x * (1 + corner_y * t) / 4 * 2 / hx
            dy = corner_y * (1 + corner_x * s) / 4 * 2 / hy
            strain = np.zeros((3, 8))
            strain[0, 0::2], strain[1, 1::2] = dx, dy
            strain[2, 0::2], strain[2, 1::2] = dy, dx
            shape = np.zeros((2, 8))
            shape[0, 0::2] = shape[1, 1::2] = value
            area = hx * hy / 4
            mass += area * DENSITY * shape.T @ shape
            damping += area * strain.T @ viscous @ strain
            stiffness += area * strain.T @ elastic @ strain
    return mass, damping, stiffness


def body_matrices():
    """Those of a body; its nodes are numbered along x first, two unknowns each."""
    nx, ny = CELLS
    n = 2 * (nx + 1) * (ny + 1)
    result = [np.zeros((n, n)) for _ in range(3)]
    cell = cell_matrices(LENGTH / nx, THICKNESS / ny)
    for i in range(nx):
        for j in range(ny):
            first = i + j * (nx + 1)
            nodes = np.array([first, first + 1, first + nx + 2, first + nx + 1])
            unknowns = np.stack((2 * nodes, 2 * nodes + 1), axis=1).ravel()
            for matrix, part in zip(result, cell):
                matrix[np.ix_(unknowns, unknowns)] += part
    return result


class Slider:
    """The equations in the unknowns w = (bodies, slip): u = free w + driven d(t)."""

    def __init__(self):
        nx, ny = CELLS
        row = 2 * (nx + 1)
        own = row * (ny + 1)
        mass, damping, stiffness = (
            scipy.linalg.block_diag(matrix, matrix) for matrix in body_matrices()
        )
        gravity = np.zeros(2 * own)
        gravity[1::2] = -GRAVITY
        self.weight = np.full(nx + 1, LENGTH / nx)
        self.weight[[0, -1]] /= 2
        self.n_fault = nx + 1

        top_x = np.arange(2 * own - row, 2 * own, 2)
        below, above = np.arange(own - row, own), np.arange(own, own + row)
        basis = np.eye(2 * own)
        # Both sides of the fault move with the lower one, and the slip adds to it.
        basis[above, below] = 1
        slip = above[0::2]
        dropped = np.concatenate((np.arange(row), above, top_x))
        bodies = np.setdiff1d(np.arange(2 * own), dropped)
        self.n_bodies = len(bodies)
        free = basis[:, np.concatenate((bodies, slip))]
        driven = np.zeros(2 * own)
        driven[top_x] = 1

        self.mass = free.T @ mass @ free
        self.damping = free.T @ damping @ free
        self.stiffness = free.T @ stiffness @ free
        self.load = free.T @ mass @ gravity
        self.of_driven = [
            free.T @ m @ driven for m in (mass, damping, stiffness)
        ]
        self.find_equilibrium(free, stiffness, mass @ gravity, above)

    def find_equilibrium(self, free, stiffness, gravity, above):
        """The fault stuck; the normal stress follows from the forces at its nodes."""
        n = self.n_bodies
        self.w0 = np.zeros(n + self.n_fault)
        self.w0[:n] = np.linalg.solve(self.stiffness[:n, :n], self.load[:n])
        force = stiffness @ free @ self.w0 - gravity
        self.normal_stress = force[above[1::2]] / self.weight
        self.strength = A * self.normal_stress * self.weight
        inverse = np.linalg.inv(self.mass)
        self.of_w = -inverse @ self.stiffness
        self.of_v = -inverse @ self.damping
        self.of_y = -inverse[:, n:] * self.strength
        self.of_load = inverse @ self.load
        self.of_driven = [inverse @ column for column in self.of_driven]

    def split(self, z):
        n, m = self.n_bodies, self.n_fault
        return np.split(z, [n + m, 2 * n + m, 2 * n + 2 * m])

    def start(self):
        return np.concatenate((self.w0, np.zeros(self.n_bodies + 2 * self.n_fault)))

    def slip_rate(self, y, alpha):
        """The slip rate, and its derivative with respect to y."""
        double = 2 * np.exp(
            np.log(V0) - (MU0 + B * (alpha + np.log(V0 / L))) / A
        )
        return double * np.sinh(y), double * np.cosh(y)

    def acceleration(self, t, w, velocity, y):
        displacement, rate, change = loading(t)
        of_mass, of_damping, of_stiffness = self.of_driven
        return (
            self.of_load + self.of_w @ w + self.of_v @ velocity + self.of_y @ y
            - of_mass * change - of_damping * rate - of_stiffness * displacement
        )

    def right_hand_side(self, t, z):
        w, bodies, y, alpha = self.split(z)
        rate, slope = self.slip_rate(y, alpha)
        velocity = np.concatenate((bodies, rate))
        acceleration = self.acceleration(t, w, velocity, y)
        ageing = np.exp(-alpha) - np.abs(rate) / L
        n = self.n_bodies
        y_t = acceleration[n:] / (slope + INERTIA_FLOOR)
        y_t += B / A * ageing * np.tanh(y)
        return np.concatenate((velocity, acceleration[:n], y_t, ageing))

    def jacobian(self, t, z):
        w, bodies, y, alpha = self.split(z)
        n, m = self.n_bodies, self.n_fault
        rate, slope = self.slip_rate(y, alpha)
        acceleration = self.acceleration(t, w, np.concatenate((bodies, rate)), y)
        of_rate = self.of_v[:, n:]
        # The acceleration by w, velocities of the bodies, y and alpha.
        change = np.hstack((
            self.of_w, self.of_v[:, :n], of_rate * slope + self.of_y,
            -of_rate * (B / A * rate),
        ))
        ys, alphas = np.arange(2 * n + m, 2 * n + 2 * m), np.arange(-m, 0)
        result = np.zeros((len(z), len(z)))
        result[np.arange(n), n + m + np.arange(n)] = 1
        result[n + np.arange(m), ys] = slope
        result[n + np.arange(m), alphas] = -B / A * rate
        result[n + m:2 * n + m] = change[:n]

        inertia = slope + INERTIA_FLOOR
        ageing = np.exp(-alpha) - np.abs(rate) / L
        by_y = -np.sign(rate) * slope / L
        by_alpha = -np.exp(-alpha) + B / A * np.abs(rate) / L
        result[alphas, ys] = by_y
        result[alphas, alphas] = by_alpha
        result[ys] = change[n:] / inertia[:, None]
        pull = acceleration[n:] / inertia**2
        tanh = np.tanh(y)
        result[ys, ys] += -pull * rate + B / A * (
            ageing * (1 - tanh**2) + tanh * by_y
        )
        result[ys, alphas] += B / A * (pull * slope + tanh * by_alpha)
        return result

    def mean_rate(self, z):
        _, _, y, alpha = self.split(z)
        return self.weight @ np.abs(self.slip_rate(y, alpha)[0]) / LENGTH


def loading(t):
    """Displacement, velocity and acceleration of the top, as in the program."""
    if t >= RAMP:
        return LOADING_RATE * (t - RAMP / 2), LOADING_RATE, 0.0
    phase = np.pi * t / RAMP
    return (
        LOADING_RATE / 2 * (t - RAMP / np.pi * np.sin(phase)),
        LOADING_RATE / 2 * (1 - np.cos(phase)),
        LOADING_RATE / 2 * np.pi / RAMP * np.sin(phase),
    )


def event_starts(end_time, relative_tolerance):
    """When the mean slip rate rises above twice the loading rate, in s."""
    slider = Slider()
    crossings = [
        crossing(slider, 2 * LOADING_RATE, 1), crossing(slider, LOADING_RATE, -1)
    ]
    solution = solve_ivp(
        slider.right_hand_side,
        (0.0, end_time),
        slider.start(),
        method="Radau",
        jac=slider.jacobian,
        rtol=relative_tolerance,
        atol=absolute_tolerances(slider, relative_tolerance),
        max_step=0.1,
        events=crossings,
    )
    if not solution.success:
        raise RuntimeError(solution.message)
    return first_of_each(*solution.t_events)


def crossing(slider, level, direction):
    def difference(t, z):
        return np.log(max(slider.mean_rate(z), 1e-300) / level)

    difference.direction = direction
    return difference


def absolute_tolerances(slider, relative):
    """A millimetre has passed at an event, and velocities of 1e-3 m/s."""
    n, m = slider.n_bodies, slider.n_fault
    return relative * np.concatenate((
        np.full(n + m, 1e-4), np.full(n, 1e-4), np.full(2 * m, 1.0)
    ))


def first_of_each(starts, ends):
    """An event lasts until the rate has fallen to half of where it began."""
    result, end = [], -1.0
    for start in starts:
        if not result or end > result[-1] and start > end:
            result.append(start)
        later = ends[ends > result[-1]]
        end = later[0] if len(later) else -1.0
    return np.array(result)
