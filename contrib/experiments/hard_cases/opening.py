# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Hard cases of faults that open and close."""

from .scene import CONDENSED, Case, bodies

GRAVITY = 9.81


def opening(end_time, fault=None, overrides=None, upper=None):
    """Two bodies on a fault that may open; the lower one is held at its bottom, and
    the `upper` side of the upper one as its entries say."""
    scene = bodies(["lower", "upper"], {"Refinement passes": "2"},
                   {"Contact": "unilateral"} | (fault or {}))
    scene = {
        key: value for key, value in scene.items()
        if not key.startswith("Boundary conditions/upper")
    }
    sides = ["lower bottom"]
    for side, entries in (upper or {}).items():
        sides.append(f"upper {side}")
        for entry, value in entries.items():
            scene[f"Boundary conditions/upper {side}/{entry}"] = value
    return scene | {
        "Boundary conditions/Sides": ", ".join(sides),
        "Time/End time": f"{end_time:g}",
        "Output/Energy balance": "true",
        "Output/Event start slip rate": "1",
        # Bounces amplify what the iterations leave.
        "TNNMG/Tolerance": "1e-12",
        "Time/Rate-state tolerance": "1e-9",
    } | (overrides or {})


def tolerances(part):
    """Entries for these parts of the default tolerances of steps."""
    return {"Time/Tolerance": f"{part * 1.3e-6:g}",
            "Time/Body tolerance": f"{part * 1e-3:g}",
            "Time/Smallest step": "1e-12"}


def impact():
    """The upper body falls, in a stronger field of gravity for the larger speed, and
    is still in contact at the end. Tolerances are as large as errors in time allow."""
    for speed, gravity, part in ((1, GRAVITY, 0.5), (100, 100 * GRAVITY, 0.02)):
        height = speed**2 / (2 * gravity)
        yield Case(
            "opening",
            f"impact at {speed} m/s",
            opening(
                speed / gravity + 0.008,
                {"Initial gap": f"{height:g} + 1e-3 * x"},
                {"Gravity/Acceleration": f"{gravity:g}", "Time/Largest step": "5e-4",
                 "Time/Initial step": "5e-4"} | tolerances(part),
            ),
            CONDENSED,
            note=f"tolerances times {part:g}",
        )


def chattering():
    """Contacts amplify differences of rounding to some 1e-4 within 0.1 s, so that
    solutions are compared then, and the longer run has only to reach its end."""
    def floor(speed):
        return {"Boundary conditions/lower bottom/y value": f"{speed:.17g} * sin(100 * t)"}

    for end_time, reference in ((0.1, CONDENSED), (0.4, None)):
        yield Case(
            "opening",
            f"chattering for {end_time} s, the floor shaken with three times gravity",
            opening(
                end_time,
                overrides={
                    "Boundary conditions/lower bottom/y condition": "velocity",
                    "Boundary conditions/lower bottom/Ramp length": "0.05",
                } | floor(0.3),
            ),
            reference,
            disturbed=floor(0.3 * (1 + 1e-14)),
        )


def bonds():
    for inertia in ("dynamic", "quasi-dynamic"):
        yield Case(
            "opening",
            f"bonds that break in a row, {inertia}",
            opening(
                1,
                {"Tensile strength": "2e4"},
                {"Time/Inertia": inertia},
                {"right": {"y condition": "velocity", "y value": "0.01",
                           "Ramp length": "0.2"}},
            ),
            CONDENSED,
            timeout=900,
        )


def tip():
    part = 0.02
    for inertia in ("dynamic", "quasi-dynamic"):
        yield Case(
            "opening",
            f"opening at a tip, {inertia}",
            opening(
                1,
                {
                    "Contact": "bilateral",
                    "Friction": "welded",
                    "Regions/Names": "crack",
                    "Regions/crack/Where": "abs(x) < 1",
                    "Regions/crack/Friction": "rate and state",
                    "Regions/crack/Contact": "unilateral",
                },
                {"Time/Inertia": inertia}
                | (tolerances(part) if inertia == "dynamic" else {}),
                {"top": {"y condition": "traction",
                         "y value": "2e5 * sin(2 * pi * t)", "Ramp length": "0.2"}},
            ),
            CONDENSED,
            note=f"tolerances times {part:g}" if inertia == "dynamic" else "",
        )


def everywhere():
    yield Case(
        "opening",
        "everywhere at once, pulled with twice the weight",
        opening(
            0.05,
            upper={"top": {"y condition": "traction", "y value": "1e5",
                           "Ramp length": "0"}},
        ),
        CONDENSED,
    )
    yield Case(
        "opening",
        "everywhere, without mass and hold",
        opening(
            1,
            overrides={"Time/Inertia": "quasi-static"},
            upper={"top": {"y condition": "traction", "y value": "1e5"}},
        ),
        refused="% of its area",
    )


def cases():
    for group in (impact, chattering, bonds, tip, everywhere):
        yield from group()
