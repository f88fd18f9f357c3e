# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""What contrib/benchmark measures: states of the faults, meshes, scenes."""

import dataclasses
import math

# Initial states theta in s, as expressions in the position.
STATES = {
    # The rates that theta stands for are about L / theta.
    "stuck": "1e6",
    "nucleating": "if(abs(x) < 0.8, 1e-5, 1e6)",
    "slipping": "1e-5",
    "half": "if(x < 0, 1e-5, 1e6)",
    # 16 decades, from node to node.
    "random": "exp(18*sin(54321*x + 1))",
}

# Half of the fault strength as shear traction, from the first step on.
TRACTION = {
    "Output/Event start slip rate": "1e-4",
    "Boundary conditions/upper top/x condition": "traction",
    "Boundary conditions/upper top/x value": "28e3",
    "Boundary conditions/upper top/Ramp length": "0",
    "Time/Initial step": "1e-3",
    "Time/Largest step": "1",
    "TNNMG/Tolerance": "1e-8",
}


@dataclasses.dataclass
class Mesh:
    """A scene on some mesh."""

    name: str
    description: str
    overrides: dict
    scene: str = "parameters/spring_slider.prm"
    dim: int = 2
    bodies: int = 2

    def settings(self):
        """What overrides the scene's entries."""
        return (TRACTION | self.overrides) if self.overrides else {}


def slider(name, description, cells, uniform, passes=0):
    """The spring slider with both bodies' meshes alike."""
    entries = {
        "Coarse cells": cells,
        "Uniform refinements": uniform,
        "Refinement passes": passes,
    }
    return Mesh(
        name,
        description,
        {
            f"Bodies/{body}/{entry}": value
            for body in ("lower", "upper")
            for entry, value in entries.items()
        },
    )


UNIFORM = "cells of one size"
GRADED = "cells that grow with the distance from the fault"
MESHES = {
    mesh.name: mesh
    for mesh in (
        slider("uniform-1e4", UNIFORM, "13, 3", 3),
        slider("uniform-1e5", UNIFORM, "12, 2", 5),
        slider("uniform-1e6", UNIFORM, "35, 7", 5),
        slider("graded-1e4", GRADED, "13, 3", 0, 6),
        slider("graded-1e5", GRADED, "12, 2", 0, 9),
        # With more passes in place of the uniform refinements the cells at the
        # fault would be smaller than the slip in an event.
        slider("graded-1e6", GRADED, "12, 2", 6, 6),
        Mesh(
            "blocks-1e5",
            "three dimensions, cells of one size",
            {
                f"Bodies/{body}/{entry}": value
                for body in ("lower", "upper")
                for entry, value in (
                    ("Uniform refinements", 2),
                    ("Refinement passes", 0),
                )
            },
            scene="contrib/benchmarks/scaling_blocks.prm",
            dim=3,
        ),
    )
}
LEVELS = [
    slider(f"uniform-level-{level}", UNIFORM, "17, 3", level)
    for level in range(2, 7)
]


# The same with a fault of two waves.
CURVED = [
    dataclasses.replace(
        mesh,
        name=mesh.name.replace("uniform", "curved"),
        description="curved fault",
        overrides=mesh.overrides
        | {"Faults/fault/Elevation": "0.125*sin(2*pi*x/2.5)"},
    )
    for mesh in LEVELS
]


def count_nodes(cells, uniform, passes, sides):
    """Vertices of the mesh of a body: rows of cells are refined from a fault
    at one or two sides, neighbouring rows differ by one level at most."""
    rows = [uniform] * (cells[1] * 2**uniform)
    for _ in range(passes):
        refined = {0, len(rows) - 1} if sides == 2 else {0}
        changed = True
        while changed:
            changed = False
            for i in list(refined):
                for j in (i - 1, i + 1):
                    if (
                        0 <= j < len(rows)
                        and j not in refined
                        and rows[j] < rows[i]
                    ):
                        refined.add(j)
                        changed = True
        rows = [
            level
            for i, row in enumerate(rows)
            for level in ([row + 1] * 2 if i in refined else [row])
        ]
    lines = zip(rows[:1] + rows, rows + rows[-1:])
    return sum(cells[0] * 2 ** max(pair) + 1 for pair in lines)


# Thickness, coarse cells and more passes than the thinnest, as published for
# five layers; then again from the third on.
LAYERS = [(1.0, (10, 2), 2), (0.3, (16, 1), 1), (0.09, (55, 1), 0), (0.3, (16, 1), 1)]


def layers(n_bodies, uniform, passes):
    """Thickness, cells and passes of each body, and the number of vertices."""
    chosen = [LAYERS[i % len(LAYERS)] for i in range(n_bodies)]
    bodies = [(t, cells, max(0, passes + more)) for t, cells, more in chosen]
    vertices = sum(
        count_nodes(cells, uniform, n, 1 if i in (0, n_bodies - 1) else 2)
        for i, (_, cells, n) in enumerate(bodies)
    )
    return bodies, vertices


def layered_scene(n_bodies, unknowns, folder):
    """Write a scene of stacked layers with about so many unknowns."""
    candidates = [
        (abs(math.log(2 * layers(n_bodies, u, p)[1] / unknowns)), u, p)
        for u in range(5)
        for p in range(-2, 6)
    ]
    _, uniform, passes = min(candidates)
    bodies, _ = layers(n_bodies, uniform, passes)
    names = [f"layer{i + 1}" for i in range(n_bodies)]
    faults = [f"fault{i + 1}" for i in range(n_bodies - 1)]
    text = [
        "subsection Bodies",
        f"  set Names = {', '.join(names)}",
        f"  set Base elevation = {-sum(t for t, _, _ in bodies[:-1]):g}",
    ]
    for name, (thickness, cells, n) in zip(names, bodies):
        text += [
            f"  subsection {name}",
            "    set Lower lateral corner = -2.5",
            "    set Upper lateral corner = 2.5",
            f"    set Thickness = {thickness:g}",
            f"    set Coarse cells = {cells[0]}, {cells[1]}",
            f"    set Uniform refinements = {uniform}",
            f"    set Refinement passes = {n}",
            "  end",
        ]
    text += ["end", "subsection Faults", f"  set Names = {', '.join(faults)}"]
    for fault in faults:
        text += [
            f"  subsection {fault}",
            "    set Characteristic slip = 2e-5",
            "  end",
        ]
    text += [
        "end",
        "subsection Boundary conditions",
        f"  set Sides = {names[0]} bottom, {names[-1]} top",
        f"  subsection {names[0]} bottom",
        "    set x condition = fixed",
        "    set y condition = fixed",
        "  end",
        f"  subsection {names[-1]} top",
        "    set x condition = traction",
        "    set x value = 28e3",
        "    set Ramp length = 0",
        "  end",
        "end",
        "subsection Time",
        "  set Initial step = 1e-3",
        "end",
        "subsection Output",
        "  set Event start slip rate = 1e-4",
        "end",
        "subsection TNNMG",
        "  set Tolerance = 1e-8",
        "end",
        "",
    ]
    path = folder / f"layers_{n_bodies}.prm"
    path.write_text("\n".join(text))
    return Mesh(
        f"layers-{n_bodies}", f"{n_bodies} layers", {}, str(path), 2, n_bodies
    )
