# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Hard cases of time stepping: large and small steps, no viscosity, reversal."""

from .scene import CONDENSED, Case, slider

PUBLISHED = {"b": "0.015"}
STRENGTHENING = {"b": "0.005"}


def nucleation():
    """The first event with all steps of one size, and with a large first step."""
    for size in ("1e-3", "4e-3", "2e-2", "0.1", "0.5", "2"):
        yield Case(
            "nucleation by constant steps",
            f"steps of {size} s",
            slider(
                22.6,
                {
                    "Time/Step size control": "constant",
                    "Time/Largest step": size,
                    "Time/Initial step": size,
                },
            ),
            {"Time/Step size control": "embedded", "Time/Tolerance": "1.3e-7"},
            "estimated error, tolerance 1.3e-7",
        )
    for size in ("0.5", "2", "8", "16"):
        yield Case(
            "nucleation with a large largest step",
            f"largest step {size} s, estimated error",
            slider(22.6, {"Time/Largest step": size}),
            CONDENSED,
        )


def step_sizes():
    for name, fault in (("weakening", PUBLISHED), ("strengthening", STRENGTHENING)):
        for exponent in (-9, -6, -3, -1, 0, 1, 2, 3):
            size = 10.0**exponent
            yield Case(
                "step size",
                f"tau = 1e{exponent} s, velocity {name}",
                slider(
                    40 * size,
                    {
                        "Time/Step size control": "constant",
                        "Time/Largest step": f"{size:g}",
                        "Time/Smallest step": f"{size / 8:g}",
                        "Boundary conditions/upper top/x condition": "traction",
                        "Boundary conditions/upper top/x value": "2e4",
                        "Boundary conditions/upper top/Ramp length": f"{10 * size:g}",
                        "Output/Event start slip rate": "4e-4",
                        "Output/Fault shortest interval": "0",
                    },
                    fault=fault,
                ),
                CONDENSED,
                note="shear traction of 20 kPa on top",
            )


def viscosity():
    for value in ("0", "1", "1e3", "1e5", "1e8", "1e12"):
        entries = {
            f"Bodies/{body}/Material/{kind} viscosity": value
            for body in ("lower", "upper")
            for kind in ("Shear", "Bulk")
        }
        yield Case(
            "viscosity",
            f"eta = zeta = {value} Pa s",
            slider(24, entries),
            CONDENSED,
        )


def reversal():
    """Iterations as exact as can be: ten events and a reversal of the slip amplify
    what they leave by seven orders of magnitude, and errors of the steps as well,
    so that these are smaller where there are events."""
    for period, rate in ((4, "2e-3"), (20, "4e-4"), (100, "4e-4")):
        yield Case(
            "loading that reverses",
            f"{rate} m/s, back and forth in {period} s",
            slider(
                60,
                {
                    "Boundary conditions/upper top/x value":
                    f"{rate} * cos(2 * pi * t / {period})",
                    "TNNMG/Tolerance": "1e-12",
                } | ({"Time/Tolerance": "1.3e-7"} if period == 100 else {}),
            ),
            CONDENSED,
            note="tolerance 1.3e-7" if period == 100 else "",
            timeout=600,
        )


def cases():
    for group in (nucleation, step_sizes, viscosity, reversal):
        yield from group()
