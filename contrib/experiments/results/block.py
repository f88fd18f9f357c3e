# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""All layers as one block in plane strain that can slip at the top fault only.

Written down anew with NumPy and SciPy, to say what the lower faults feel if they do
nothing: bilinear elements on a grid of rectangles, fixed at the base, moved along x at
the top, free otherwise. The slip of the top fault is given as a function of position
and time; momentum gives the tractions at the elevations of the others. Newmark's
method with beta = 1/4, gamma = 1/2, as in the program. The mass of the row of
elements above the fault follows the lower side there.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import eigsh, splu

from . import layers

CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
# Displacements along x of the lower two corners.
LOWER_X = [0, 2]


def shape_and_strain(xi, eta, size):
    """At a point of the reference square: the four functions, and the matrix from
    corner displacements to (eps_xx, eps_yy, 2 eps_xy)."""
    x, y = CORNERS.T
    shape = (1 + x * xi) * (1 + y * eta) / 4
    d_x = x * (1 + y * eta) / (2 * size[0])
    d_y = y * (1 + x * xi) / (2 * size[1])
    strain = np.zeros((3, 8))
    strain[0, 0::2], strain[1, 1::2] = d_x, d_y
    strain[2, 0::2], strain[2, 1::2] = d_y, d_x
    return shape, strain


def isotropic(first, second):
    """From (eps_xx, eps_yy, 2 eps_xy) to stress, for both constants of Lamé."""
    return np.array([
        [first + 2 * second, first, 0], [first, first + 2 * second, 0], [0, 0, second]
    ])


def element_matrices(size):
    """Stiffness, viscosity and mass of a rectangle, the components of a corner next to
    each other."""
    elastic = isotropic(layers.FIRST_LAME, layers.SHEAR_MODULUS)
    viscous = isotropic(
        layers.BULK_VISCOSITY - 2 * layers.SHEAR_VISCOSITY / 3, layers.SHEAR_VISCOSITY
    )
    result = np.zeros((3, 8, 8))
    point = 1 / np.sqrt(3)
    area = size[0] * size[1] / 4
    for xi in (-point, point):
        for eta in (-point, point):
            shape, strain = shape_and_strain(xi, eta, size)
            result[0] += area * strain.T @ elastic @ strain
            result[1] += area * strain.T @ viscous @ strain
            for c in (0, 1):
                result[2, c::2, c::2] += area * layers.DENSITY * np.outer(shape, shape)
    return result


class Block:
    """Matrices of the block on a grid of columns of cells and, for each layer from
    below, rows."""

    def __init__(self, columns=60, rows=(12, 4, 2, 4, 12)):
        self.x = np.linspace(-layers.WIDTH / 2, layers.WIDTH / 2, columns + 1)
        self.z = np.concatenate([[0.0]] + [
            bottom + np.arange(1, n + 1) * thickness / n
            for bottom, n, thickness in zip(
                np.cumsum((0.0, *layers.THICKNESSES)), rows, layers.THICKNESSES
            )
        ])
        self.fault_rows = np.cumsum(rows)[:-1]
        self.n = 2 * len(self.x) * len(self.z)
        every_row = range(len(self.z) - 1)
        self.stiffness, self.viscosity, self.mass = self.assemble(every_row)
        self.slip_stiffness, self.slip_viscosity = (
            self.slip_matrix(k) for k in (0, 1)
        )
        ends = np.full(len(self.x), self.x[1] - self.x[0])
        ends[[0, -1]] /= 2
        self.width = ends
        height = np.tile(np.arange(len(self.z)), len(self.x))
        held = np.zeros((len(height), 2), dtype=bool)
        held[height == 0] = True
        held[height == len(self.z) - 1, 0] = True
        self.free = np.flatnonzero(~held.ravel())
        self.top = 2 * np.flatnonzero(height == len(self.z) - 1)

    def unknowns(self, row):
        """Of the corners of the elements of a row, (elements x 8)."""
        corner = np.arange(len(self.x) - 1) * len(self.z) + row
        right = corner + len(self.z)
        nodes = np.stack((corner, right, right + 1, corner + 1), axis=1)
        return (2 * nodes[:, :, None] + np.arange(2)).reshape(-1, 8)

    def row_matrices(self, row):
        return element_matrices((self.x[1] - self.x[0], self.z[row + 1] - self.z[row]))

    def assemble(self, rows):
        """The three matrices of some rows of elements."""
        where, values = [], []
        for row in rows:
            unknowns = self.unknowns(row)
            where.append(np.stack((
                np.repeat(unknowns, 8, axis=1).ravel(),
                np.tile(unknowns, (1, 8)).ravel(),
            )))
            values.append(
                np.tile(self.row_matrices(row).reshape(3, 1, 64), (1, len(unknowns), 1))
                .reshape(3, -1)
            )
        where, values = np.concatenate(where, axis=1), np.concatenate(values, axis=1)
        return [coo_matrix((v, where), (self.n, self.n)).tocsr() for v in values]

    def slip_matrix(self, which):
        """From slip at the nodes of the top fault to forces, since the elements above
        it start from the other side."""
        row = self.fault_rows[-1]
        unknowns = self.unknowns(row)
        matrix = self.row_matrices(row)[which][:, LOWER_X]
        node = np.arange(len(self.x) - 1)[:, None] + np.arange(2)
        where = (
            np.repeat(unknowns, 2, axis=1).ravel(), np.tile(node, (1, 8)).ravel()
        )
        values = np.tile(matrix.ravel(), len(unknowns))
        return coo_matrix((values, where), (self.n, len(self.x))).tocsr()

    def traction_operators(self, which, component):
        """For each lower fault a matrix from displacements (or velocities) to the
        traction at its nodes: the mean of what both sides say."""
        result = []
        for row in self.fault_rows[:-1]:
            nodes = 2 * (np.arange(len(self.x)) * len(self.z) + row) + component
            below, above = (self.assemble([r])[which] for r in (row - 1, row))
            result.append((below - above)[nodes].multiply(1 / (2 * self.width[:, None])))
        return [matrix.tocsr() for matrix in result]

    def under_weight(self):
        """Normal stresses and shear tractions in Pa on the lower faults (faults x nodes)
        from the weight alone. The layers would widen, more the deeper they are, but base
        and top hold them: hence the shear."""
        gravity = np.zeros(self.n)
        gravity[1::2] = -layers.GRAVITY
        u = np.zeros(self.n)
        stiffness = self.stiffness[self.free][:, self.free].tocsc()
        u[self.free] = splu(stiffness).solve((self.mass @ gravity)[self.free])
        normal, shear = (
            np.array([m @ u for m in self.traction_operators(0, component)])
            for component in (1, 0)
        )
        return -normal, shear

    def tractions(self, times, slip):
        """Shear tractions in Pa on the lower faults (times x faults x nodes) while the
        top fault has the given slip in m (times x nodes), without those from weight."""
        operators = [self.traction_operators(k, 0) for k in (0, 1)]
        u, v, a = np.zeros(self.n), np.zeros(self.n), np.zeros(self.n)
        result = np.zeros((len(times), len(operators[0]), len(self.x)))
        factors, last_step = None, None
        for k in range(1, len(times)):
            step = times[k] - times[k - 1]
            if last_step is None or abs(step - last_step) > 1e-9:
                last_step = step
                matrix = (
                    2 / step * self.mass + self.viscosity + step / 2 * self.stiffness
                )
                factors = splu(matrix[self.free][:, self.free].tocsc())
            slip_rate = (slip[k] - slip[k - 1]) / step
            predicted = u + step / 2 * v
            new = np.zeros(self.n)
            new[self.top] = layers.loading_rate(times[k])
            right = (
                self.mass @ (2 / step * v + a) - self.stiffness @ predicted
                - self.slip_stiffness @ slip[k] - self.slip_viscosity @ slip_rate
                - matrix @ new
            )
            new[self.free] = factors.solve(right[self.free])
            u = predicted + step / 2 * new
            a = 2 / step * (new - v) - a
            v = new
            result[k] = [
                elastic @ u + viscous @ v for elastic, viscous in zip(*operators)
            ]
        return result

    def vibrations(self, count=40):
        """Free vibrations with all faults locked: frequencies in Hz, in increasing
        order, and the share of each in the response to a uniform slip."""
        stiffness, mass = (
            m[self.free][:, self.free].tocsc() for m in (self.stiffness, self.mass)
        )
        squares, shapes = eigsh(stiffness, count, mass, sigma=0.0)
        order = np.argsort(squares)
        force = (self.slip_stiffness @ np.ones(len(self.x)))[self.free]
        share = (shapes[:, order].T @ force) ** 2 / squares[order]
        return np.sqrt(squares[order]) / (2 * np.pi), share / share.sum()
