# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Two equal layers without ends, pressed together over the whole of a wavy fault.

Sides that differ by d cos(kx) have the contact pressure K(k) d cos(kx), of half spaces
E* k / 2 with 1/E* = 2 (1 - nu^2) / E (Westergaard 1939; Johnson 1985, section 13.2).
Waves A sin(kx) of both sides that have slid by s differ by
2 A sin(ks/2) cos(k (x + s/2)) in the coordinate x of the upper side; the energy stored
in them over the area, K d^2 / 4, is K A^2 sin^2(ks/2), and its slope over s,
K k A^2 sin(ks) / 2, is the drag. Waves add up, in the energy too.
"""

import numpy as np
from scipy.linalg import expm


def half_space(modulus, ratio, k):
    return modulus / (2 * (1 - ratio**2)) * k / 2


def layer_compliance(modulus, ratio, k, thickness, top_is_free):
    """Amplitude of the normal displacement of a face without shear traction for a
    pressure of one; the other side is held, or free to move normally."""
    shear = modulus / (2 * (1 + ratio))
    lame = modulus * ratio / ((1 + ratio) * (1 - 2 * ratio))
    wide = lame + 2 * shear
    # u_x = X sin kx, u_y = Y cos kx, shear T sin kx, normal S cos kx; derivatives.
    matrix = np.zeros((4, 4))
    matrix[0, 1], matrix[0, 2] = k, 1 / shear
    matrix[1, 0], matrix[1, 3] = -lame * k / wide, 1 / wide
    matrix[2] = k * (wide * k * np.array([1, 0, 0, 0]) + lame * matrix[1])
    matrix[3, 2] = -k
    from_far = expm(thickness * matrix)
    # Unknown at the far side: two of X, Y, T, S; X is zero there.
    unknown = (1, 2) if top_is_free else (2, 3)
    columns = from_far[:, unknown]
    coefficients = np.linalg.solve(columns[2:], [0.0, -1.0])
    return abs(columns[1] @ coefficients)


def stiffness(modulus, ratio, k, thickness):
    """K(k) of a lower layer on a plate and an upper one with a free normal motion."""
    if k * thickness > 6:
        return half_space(modulus, ratio, k)
    return 1 / (
        layer_compliance(modulus, ratio, k, thickness, False)
        + layer_compliance(modulus, ratio, k, thickness, True)
    )


class Waves:
    """A profile of waves (k, amplitude, phase) between two layers."""

    def __init__(self, waves, modulus, ratio, thickness):
        self.k, self.amplitude, self.phase = np.array(waves).T
        self.stiffness = np.array([
            stiffness(modulus, ratio, k, thickness) for k in self.k])

    def pressure(self, x, slip):
        """Change of the contact pressure at points of the upper side."""
        x = np.asarray(x)[..., None]
        return (
            2 * self.stiffness * self.amplitude * np.sin(self.k * slip / 2)
            * np.cos(self.k * (x + slip / 2) + self.phase)
        ).sum(-1)

    def energy(self, slip):
        """Stored over the area, in J/m^2."""
        slip = np.asarray(slip)[..., None]
        return (self.stiffness * self.amplitude**2
                * np.sin(self.k * slip / 2) ** 2).sum(-1)

    def drag(self, slip):
        slip = np.asarray(slip)[..., None]
        return (self.stiffness * self.k * self.amplitude**2
                * np.sin(self.k * slip) / 2).sum(-1)
