# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Hard cases of the friction law: states, slip rates, parameters, normal stress."""

from .scene import CONDENSED, NODE_DISTANCE, Case, slider

# One with an even number, one with an odd one.
ALTERNATING = f"cos(pi * (x + 2.5) / {NODE_DISTANCE})"


def stepped(left, right):
    return f"if(x < 0, {left}, {right})"


def states():
    """Under the slip law the state stays what it is where nothing slips."""
    for law in ("slip", "aging"):
        for decades in (2, 4, 8, 12):
            half = decades / 2
            state = f"if({ALTERNATING} > 0, 1e{half:g}, 1e{-half:g})"
            yield Case(
                "state of neighbouring nodes",
                f"theta over {decades} decades, {law} law",
                slider(22.6, fault={"State law": law, "Initial state": state}),
                CONDENSED,
            )


def slip_rates():
    """The left half is dragged along, the right half is as good as welded."""
    for rate in ("1e-4", "1e-2", "1", "10"):
        time = min(1.0, 0.1 / float(rate))
        yield Case(
            "slip rates within a fault",
            f"stuck beside {rate} m/s",
            slider(
                time,
                {
                    "Boundary conditions/upper top/x value": rate,
                    "Boundary conditions/upper top/Ramp length": f"{time / 2:g}",
                    "Time/Initial step": f"{min(1e-3, time / 200):g}",
                    "Time/Largest step": f"{time / 8:g}",
                    "Output/Fault shortest interval": "0",
                    "Output/Fault longest interval": f"{time:g}",
                    "Contact/Follow slip": "false",
                    # One more step or less is an error of 4e-5.
                    "TNNMG/Tolerance": "1e-12" if rate == "10" else "1e-9",
                },
                fault={
                    "Normal stress": "function",
                    "Normal stress function": stepped("10", "1e9"),
                },
            ),
            CONDENSED,
        )


def laws():
    """With the published ones the fault slips first at 22.3 s."""
    for a in ("1e-4", "1e-3", "1e-2", "1e-1"):
        for ratio in (0, 0.5, 1.5, 5, 20):
            b = float(a) * ratio
            for regularisation in ("truncated", "arcsinh"):
                if regularisation == "arcsinh" and ratio not in (0, 20):
                    continue
                # The critical length grows with b - a.
                slip = 2e-5 * max(1.0, abs(b - float(a)) / 0.005)
                # These slip from the start and never come to rest.
                end = 3 if b > 0.1 else 23
                yield Case(
                    "a and b",
                    f"a = {a}, b/a = {ratio:g}, {regularisation}",
                    slider(
                        end,
                        fault={
                            "a": a,
                            "b": f"{b:g}",
                            "Characteristic slip": f"{slip:g}",
                            "Regularisation": regularisation,
                        },
                    ),
                    CONDENSED,
                )


def characteristic_slips():
    for slip in ("1e-7", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1"):
        yield Case(
            "characteristic slip",
            f"L = {slip} m",
            # Where an event takes 1e5 steps, they amplify what iterations leave.
            slider(
                23,
                {"TNNMG/Tolerance": "1e-12"} if float(slip) < 1e-5 else {},
                fault={"Characteristic slip": slip},
            ),
            CONDENSED,
            timeout=900 if float(slip) < 1e-6 else 300,
        )


def normal_stresses():
    for left, right in (
        ("1", "1"),
        ("1", "1e3"),
        ("1", "1e6"),
        ("1", "1e9"),
        ("4.9e4", "1e9"),
        ("1e9", "1e9"),
        ("0", "4.9e4"),
    ):
        yield Case(
            "normal stress",
            f"sigma_n = {left} Pa on one half, {right} Pa on the other",
            slider(
                26,
                fault={
                    "Normal stress": "function",
                    "Normal stress function": stepped(left, right),
                },
            ),
            CONDENSED,
            timeout=900,
        )


def cases():
    for group in (states, slip_rates, laws, characteristic_slips, normal_stresses):
        yield from group()
