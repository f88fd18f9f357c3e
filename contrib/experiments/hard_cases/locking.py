# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Elastic energy of nearly incompressible bodies under their weight."""

from .run import run
from .scene import material, slider, text


def scene(ratio, strain, refinements):
    """The fault cannot slip; one step is enough to be told the energy."""
    entries = {}
    for body in ("lower", "upper"):
        entries |= material(body, poisson_ratio=ratio)
        entries[f"Bodies/{body}/Material/Volumetric strain"] = strain
    return slider(
        0.002,
        entries,
        body={"Refinement passes": "0", "Uniform refinements": refinements},
        fault={"Reference friction coefficient": "10", "b": "0"},
    )


def measure(program, folder):
    """Print a line for each Poisson ratio and volumetric strain."""
    for ratio in (0.3, 0.49, 0.4999):
        for strain in ("full", "patch mean"):
            energies = []
            for refinements in range(4):
                result = run(program, text(scene(ratio, strain, refinements)),
                             folder, 100)
                energies.append(result.number("Energy/elastic, at the end"))
            print(ratio, strain, *energies, flush=True)
