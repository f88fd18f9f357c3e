# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Meshes of halved cells that interpolate a field on a fine uniform mesh.

A mesh is a list of arrays of flags, one for each level but the finest: the cells that
are refined. Fields are arrays of nodes, rows along y, with two components.
"""

import numpy as np


def element_matrix(young, poisson):
    """Of a square bilinear cell in plane strain, whatever its size; components of
    corner (0, 0), (1, 0), (0, 1), (1, 1) one after the other."""
    factor = young / ((1 + poisson) * (1 - 2 * poisson))
    elasticity = factor * np.array([
        [1 - poisson, poisson, 0], [poisson, 1 - poisson, 0],
        [0, 0, (1 - 2 * poisson) / 2]])
    matrix = np.zeros((8, 8))
    points = 0.5 + np.array([-1, 1]) / np.sqrt(12)
    for x in points:
        for y in points:
            gradients = np.array(
                [[y - 1, 1 - y, -y, y], [x - 1, -x, 1 - x, x]])
            strain = np.zeros((3, 8))
            strain[0, 0::2], strain[1, 1::2] = gradients
            strain[2, 0::2], strain[2, 1::2] = gradients[1], gradients[0]
            matrix += 0.25 * strain.T @ elasticity @ strain
    return matrix


def cell_energies(field, matrix):
    """Energy of each cell."""
    corners = np.concatenate(
        [field[:-1, :-1], field[:-1, 1:], field[1:, :-1], field[1:, 1:]], axis=2)
    return 0.5 * np.einsum("yxi,ij,yxj->yx", corners, matrix, corners, optimize=True)


def interpolated(field, stride):
    """The field from every so many nodes along each axis, linear between them."""
    for axis in (0, 1):
        coarse = np.moveaxis(field, axis, 0)[::stride]
        parts = np.arange(stride) / stride
        between = np.stack([(1 - p) * coarse[:-1] + p * coarse[1:] for p in parts], 1)
        whole = np.concatenate(
            [between.reshape(-1, *coarse.shape[1:]), coarse[-1:]], axis=0)
        field = np.moveaxis(whole, 0, axis)
    return field


def errors(field, matrix, n_levels):
    """For each level but the finest, the energy of the error of each of its cells, if
    it stays as it is; and the energy of the field."""
    result = []
    for level in range(n_levels):
        stride = 2 ** (n_levels - level)
        of_cells = cell_energies(field - interpolated(field, stride), matrix)
        rows, columns = (n // stride for n in of_cells.shape)
        result.append(
            of_cells.reshape(rows, stride, columns, stride).sum(axis=(1, 3)))
    return result, cell_energies(field, matrix).sum()


def doubled(flags):
    return flags.repeat(2, axis=0).repeat(2, axis=1)


def halved(flags):
    """Cells any child of which has the flag."""
    rows, columns = (n // 2 for n in flags.shape)
    return flags.reshape(rows, 2, columns, 2).any(axis=(1, 3))


def left_error(of_levels, refined):
    """The sum over the cells that are not refined and whose parents are."""
    exists, error = np.ones_like(refined[0]), 0.0
    for of_cells, flags in zip(of_levels, refined):
        error += of_cells[exists & ~flags].sum()
        exists = doubled(flags)
    return error


def with_ancestors(refined):
    refined = [flags.copy() for flags in refined]
    for level in range(len(refined) - 1, 0, -1):
        refined[level - 1] |= halved(refined[level])
    return refined


def balanced(refined):
    """With edges halved once at most: neighbours of a refined cell exist."""
    refined = with_ancestors(refined)
    for level in range(len(refined) - 1, 0, -1):
        wide = np.pad(refined[level], 1)
        inner = slice(1, -1)
        near = (wide[:-2, inner] | wide[2:, inner] | wide[inner, :-2]
                | wide[inner, 2:] | wide[inner, inner])
        refined[level - 1] |= halved(near)
    return refined


def smallest(parts, allowed):
    """Of each part (bodies), the cells to be refined so that the errors of all
    together are at most what is allowed: those above a common bound."""
    low, high = 0.0, max(of_cells.max() for part in parts for of_cells in part)
    best = [with_ancestors([c > low for c in part]) for part in parts]
    for _ in range(40):
        middle = np.sqrt(low * high) if low > 0 else 1e-6 * high
        trial = [with_ancestors([c > middle for c in part]) for part in parts]
        if sum(map(left_error, parts, trial)) <= allowed:
            low, best = middle, trial
        else:
            high = middle
        if low > 0 and high < 1.001 * low:
            break
    return best


def vertices(refined):
    """Their number, hanging ones included."""
    n_levels = len(refined)
    rows, columns = refined[0].shape
    finest = 2**n_levels
    nodes = np.zeros((rows * finest + 1, columns * finest + 1), dtype=bool)
    nodes[::finest, ::finest] = True
    for level, flags in enumerate(refined):
        half = 2 ** (n_levels - level - 1)
        y, x = np.nonzero(flags)
        for i in range(3):
            for j in range(3):
                nodes[(2 * y + i) * half, (2 * x + j) * half] = True
    return int(nodes.sum())


def union(first, second):
    return [a | b for a, b in zip(first, second)]
