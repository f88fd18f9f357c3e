# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The five bodies as formulas: parameters, friction law, shear resonances."""

import numpy as np

# SI units, as in parameters/layered_five_bodies.prm.
YOUNGS_MODULUS, POISSONS_RATIO, DENSITY, GRAVITY = 4.12e7, 0.3, 5e3, 9.81
SHEAR_VISCOSITY = BULK_VISCOSITY = 1e3
SHEAR_MODULUS = YOUNGS_MODULUS / (2 * (1 + POISSONS_RATIO))
FIRST_LAME = 2 * SHEAR_MODULUS * POISSONS_RATIO / (1 - 2 * POISSONS_RATIO)
WAVE_SPEED = np.sqrt(SHEAR_MODULUS / DENSITY)
WIDTH, THICKNESSES = 5.0, (1.0, 0.3, 0.09, 0.3, 1.0)
HEIGHT = sum(THICKNESSES)
# Of the faults above the base, from below.
ELEVATIONS = np.cumsum(THICKNESSES)[:-1]
WEIGHTS = DENSITY * GRAVITY * (HEIGHT - ELEVATIONS)
A, B, MU0, V0, L = 0.010, 0.015, 0.6, 1e-6, 2e-5
LOADING_RATE, RAMP, INITIAL_STATE = 2e-4, 1.0, 1.0


def loading_rate(t):
    """Velocity of the top in m/s, ramped up by half a cosine."""
    return LOADING_RATE / 2 * (1 - np.cos(np.pi * np.minimum(t, RAMP) / RAMP))


def log_rate(traction, normal_stress, state):
    """Logarithm of the slip rate in m/s that the truncated law has at a traction."""
    friction = np.maximum(traction, 0.0) / normal_stress
    return np.log(V0) + (friction - MU0 - B * np.log(V0 * state / L)) / A


def column_resonances(count=3):
    """Shear resonances in Hz of a column without extent along x: with all faults locked
    (fixed at both ends), and of what lies below and above the top fault when that
    slides freely (fixed at one end)."""
    odd = 2 * np.arange(count) + 1
    above = THICKNESSES[-1]
    return {
        "locked": WAVE_SPEED / (2 * HEIGHT) * np.arange(1, count + 1),
        "below": WAVE_SPEED / (4 * (HEIGHT - above)) * odd,
        "above": WAVE_SPEED / (4 * above) * odd,
    }


def layer_resonances(thickness):
    """Shear resonances in Hz of a layer by itself, fixed at one side and free at the
    other, and with two equal sides."""
    return WAVE_SPEED / (4 * thickness), WAVE_SPEED / (2 * thickness)
