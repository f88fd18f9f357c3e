# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Hard cases of bodies and meshes: stiffness, thickness, aspect, many faults."""

from .scene import CONDENSED, UMFPACK, Case, bodies, material, slider


def stiffness():
    for soft in ("lower", "upper"):
        for contrast in (1, 1e2, 1e4, 1e6):
            for end in ("softer", "stiffer"):
                if contrast == 1 and (soft, end) != ("lower", "softer"):
                    continue
                factor = 1 / contrast if end == "softer" else contrast
                yield Case(
                    "stiffness of neighbouring bodies",
                    f"{soft} body {contrast:.0e} times {end}",
                    slider(22.6, material(soft, young_modulus=4.12e7 * factor)),
                    CONDENSED,
                )


def layers():
    """A layer between two bodies of 1 m. With the pressure of the equilibrium in
    place of the weight above, the ends of the upper fault chatter."""
    for thickness in ("0.3", "0.1", "0.03", "0.01", "0.003", "0.001"):
        for aspect in (5, 50):
            n = round(5 / (float(thickness) * aspect))
            if n > 1000 or n < 2:
                continue
            scene = bodies(
                ["lower", "layer", "upper"], fault={"Normal stress": "lithostatic"}
            )
            scene |= {
                "Time/End time": "0.5",
                "Bodies/layer/Thickness": thickness,
                "Bodies/layer/Coarse cells": f"{n}, 1",
                "Bodies/layer/Refinement passes": "1",
            }
            yield Case(
                "thin layers",
                f"layer of {thickness} m between 1 m, aspect {aspect}",
                scene,
                UMFPACK,
                "exact linear corrections",
            )


def aspects():
    for aspect in (1, 5, 10, 20, 50):
        for shape, cells in (
            ("flat", f"10, {2 * aspect}"),
            ("tall", f"{10 * aspect}, 2"),
        ):
            if aspect == 1 and shape == "tall":
                continue
            # To the first event, or as long as is bearable with 2e4 vertices. Under
            # the weight the last nodes of the finer ones stick and slip in turn.
            scene = slider(
                22.6 if aspect <= 10 else 2,
                body={"Coarse cells": cells, "Refinement passes": "1"},
                fault={"Normal stress": "lithostatic"} if aspect >= 10 else {},
            )
            yield Case("aspect of the cells", f"aspect {aspect}, {shape}", scene,
                       UMFPACK, "exact linear corrections")


def mesh_ratios():
    for finer in ("lower", "upper"):
        for passes in range(4, -1, -1):
            if passes == 4 and finer == "lower":
                continue
            other = "upper" if finer == "lower" else "lower"
            yield Case(
                "mesh ratio at the fault",
                f"1:{2 ** (4 - passes)}, {finer} body finer",
                slider(22.6, {f"Bodies/{other}/Refinement passes": passes}),
                CONDENSED,
            )


def incompressible():
    for ratio in (0.3, 0.45, 0.49, 0.499, 0.4999, 0.49999):
        for strain in ("full", "patch mean"):
            entries = {"Time/End time": "1"}
            for body in ("lower", "upper"):
                entries |= material(body, poisson_ratio=ratio)
                entries[f"Bodies/{body}/Material/Volumetric strain"] = strain
            yield Case(
                "Poisson's ratio",
                f"nu = {ratio}, volumetric strain {strain}",
                slider(1, entries, fault={"Normal stress": "lithostatic"}),
                CONDENSED,
                timeout=100,
                warned="too stiff in bending"
                if strain == "full" and ratio > 0.45
                else "",
            )


def many_faults():
    for n in (5, 33):
        scene = bodies(
            [f"layer{i}" for i in range(n + 1)],
            body={"Coarse cells": "10, 2", "Refinement passes": "1"},
            fault={"Characteristic slip": "2e-4"},
        ) | {"Time/End time": "2", f"Boundary conditions/layer{n} top/x value": "1e-3"}
        yield Case("many faults", f"{n} faults", scene, CONDENSED)


def sliding():
    """Until only so much of the upper body is above the lower one."""
    for left in (0.75, 0.5, 0.25):
        distance = 5 * (1 - left)
        yield Case(
            "bodies slid apart",
            f"{left:g} of the fault left",
            slider(
                10.5,
                {
                    "Boundary conditions/upper top/x value": f"{distance / 10:g}",
                    "Time/Largest step": "0.125",
                    # As large as errors in time allow.
                    "Time/Tolerance": "1e-4" if left == 0.75 else "1e-5",
                    "TNNMG/Tolerance": "1e-12",
                },
                body={"Refinement passes": "2"},
                fault={"b": "0", "Reference friction coefficient": "0.1"},
            ),
            CONDENSED,
            note="tolerance 1e-4" if left == 0.75 else "tolerance 1e-5",
            timeout=900,
        )


def cases():
    for group in (stiffness, layers, aspects, mesh_ratios, incompressible,
                  many_faults, sliding):
        yield from group()
