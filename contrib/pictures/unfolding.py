# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""A fault in space spread out in a plane."""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg

# A fault whose normal is nearer to the vertical than this is unfolded along x and y.
LEVEL = np.cos(np.radians(15))


def unfolded(points, faces, axes):
    """Ways along strike and down dip of the nodes of a fault in space, in m.

    Along each edge they grow as it goes along these directions, by least squares: on a
    plane they are coordinates, on a fault that bends in one direction arc lengths.
    Of a level fault they are x and y.
    """
    normals = axes[:, -1]
    mean = normals.mean(axis=0)
    if np.abs(mean[2]) >= LEVEL * np.linalg.norm(mean):
        directions = (np.tile([1.0, 0, 0], (len(points), 1)),
                      np.tile([0, 1.0, 0], (len(points), 1)))
        directions = [d - (d * normals).sum(axis=1)[:, None] * normals for d in directions]
    else:
        strike = np.cross([0, 0, 1.0], normals)
        if strike.mean(axis=0) @ [1.0, 0.1, 0] < 0:
            strike = -strike
        dip = np.cross(strike, normals)
        directions = [strike, dip * np.sign(-dip[:, 2].mean())]
    directions = [d / np.linalg.norm(d, axis=1, keepdims=True) for d in directions]

    around = [face[face >= 0] for face in faces]
    edges_of_faces = np.concatenate(
        [np.stack((face, np.roll(face, -1)), axis=1) for face in around])
    one, other = edges_of_faces.T
    way = points[other] - points[one]
    rows = np.arange(len(one))
    differences = scipy.sparse.csr_matrix(
        (np.concatenate((-np.ones(len(one)), np.ones(len(one)))),
         (np.concatenate((rows, rows)), np.concatenate((one, other)))),
        shape=(len(one), len(points)))
    result = []
    for number, direction in enumerate(directions):
        steps = ((direction[one] + direction[other]) / 2 * way).sum(axis=1)
        values = scipy.sparse.linalg.lsqr(
            differences, steps, atol=1e-12, btol=1e-12)[0]
        shift = 0 if np.abs(mean[2]) < LEVEL else np.mean(points[:, number] - values)
        result.append(values - values.min() if shift == 0 else values + shift)
    return np.stack(result, axis=1)
