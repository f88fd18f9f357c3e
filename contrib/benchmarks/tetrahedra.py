# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Iterations of TNNMG on tetrahedra beside those on hexahedra with the same nodes, level
and curved faults."""

import itertools
import math
import pathlib

from common import programs

from . import iterations, pushed_blocks
from .scenes import STATES, Mesh

# Cubes of half a metre along the sides of a box of 5 m x 5 m x 2 m.
CELLS = (10, 10, 4)
SIZE = 0.5
REFINEMENTS = (0, 1, 2)
SWEEPS = (1, 2)
SHAPES = {"hexahedra": False, "tetrahedra": True}
ELEVATIONS = {"level": None, "curved": "0.1*sin(2*pi*x/2.5)*cos(2*pi*y/5)"}

SCENE = """set Dimension = 3
subsection Bodies
  set Names     = lower, upper
  set Mesh file = {mesh}
  subsection lower
    set Uniform refinements = {refinements}
  end
  subsection upper
    set Uniform refinements = {refinements}
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Between                = lower, upper
    set Normal stress          = function
    set Normal stress function = 4.9e4
{shape}  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
""" + pushed_blocks.END.replace("{top}", "upper top")


def elevation(name, x, y, z):
    """Height of a node: that of the fault in the middle, none at bottom and top."""
    if ELEVATIONS[name] is None:
        return z
    part = 1 - abs(z) / (CELLS[2] / 2 * SIZE)
    return z + part * 0.1 * math.sin(2 * math.pi * x / 2.5) * math.cos(2 * math.pi * y / 5)


def node(i, j, k):
    return (k * (CELLS[1] + 1) + j) * (CELLS[0] + 1) + i + 1


def corner(place, bits):
    return tuple(place[d] + (bits >> d & 1) for d in range(3))


def cells(place, of_tetrahedra):
    """A cube, or five tetrahedra: one between every second corner, and one at each other
    corner. Edges across faces join nodes whose numbers have an even sum."""
    at = [node(*corner(place, bits)) for bits in range(8)]
    if not of_tetrahedra:
        return [(5, *(at[b] for b in (0, 1, 3, 2, 4, 5, 7, 6)))]
    if sum(place) % 2 == 0:
        five = ((0, 5, 3, 6), (1, 3, 0, 5), (2, 0, 3, 6), (4, 5, 0, 6), (7, 6, 3, 5))
    else:
        five = ((1, 2, 4, 7), (0, 1, 2, 4), (3, 2, 1, 7), (5, 4, 7, 1), (6, 7, 4, 2))
    return [(4, *(at[b] for b in corners)) for corners in five]


def faces(place, first, second, of_tetrahedra):
    a, b, c, d = (
        node(*corner(place, bits)) for bits in (0, first, first + second, second)
    )
    if not of_tetrahedra:
        return [(3, a, b, c, d)]
    if sum(place) % 2 == 0:
        return [(2, a, b, c), (2, a, c, d)]
    return [(2, a, b, d), (2, b, c, d)]


def mesh_text(shape, bend):
    """Two layers of 5 m x 5 m x 1 m, in the format of Gmsh."""
    nx, ny, nz = CELLS
    of_tetrahedra = SHAPES[shape]
    names = ["lower", "upper", "bottom", "fault", "top", "ends"]
    elements = []
    for i, j, k in itertools.product(range(nx), range(ny), range(nz)):
        elements += [(kind, 1 if k < nz // 2 else 2, *nodes)
                     for kind, *nodes in cells((i, j, k), of_tetrahedra)]
    for group, k in ((3, 0), (4, nz // 2), (5, nz)):
        for i, j in itertools.product(range(nx), range(ny)):
            elements += [(kind, group, *nodes)
                         for kind, *nodes in faces((i, j, k), 1, 2, of_tetrahedra)]
    for k in range(nz):
        for end, i in itertools.product((0, ny), range(nx)):
            elements += [(kind, 6, *nodes)
                         for kind, *nodes in faces((i, end, k), 1, 4, of_tetrahedra)]
        for end, j in itertools.product((0, nx), range(ny)):
            elements += [(kind, 6, *nodes)
                         for kind, *nodes in faces((end, j, k), 2, 4, of_tetrahedra)]
    places = []
    for k, j, i in itertools.product(range(nz + 1), range(ny + 1), range(nx + 1)):
        x, y, z = (SIZE * (n - whole / 2) for n, whole in zip((i, j, k), CELLS))
        places.append(f"{x} {y} {elevation(bend, x, y, z):.17g}")
    return pushed_blocks.mesh_text(
        [(3 if n < 2 else 2, name) for n, name in enumerate(names)], places, elements)


def scene(shape, bend, refinements, sweeps, folder):
    """Write a scene with its mesh."""
    name = f"{bend}-{shape}-{refinements}-{sweeps}"
    mesh = folder / f"{name}.msh"
    mesh.write_text(mesh_text(shape, bend))
    path = folder / f"{name}.prm"
    path.write_text(SCENE.format(
        mesh=mesh.name, refinements=refinements, sweeps=sweeps,
        shape=f"    set Shape = {ELEVATIONS[bend]}\n" if ELEVATIONS[bend] else ""))
    return Mesh(name, f"{shape}, {bend} fault", {}, str(path), 3, 2)


SECTION = "tetrahedra"


def measure(quick, log):
    records = []
    with programs.temporary_folder() as folder:
        for refinements in REFINEMENTS[: 1 if quick else None]:
            for sweeps, bend, shape in itertools.product(SWEEPS, ELEVATIONS, SHAPES):
                mesh = scene(shape, bend, refinements, sweeps, pathlib.Path(folder))
                iterations.measure_states(SECTION, mesh, STATES, records)
                log(f"{mesh.name} measured")
    return records, None


def text(records, _):
    return "\n".join((
        "Iterations / V-cycles:\n",
        *iterations.state_tables(
            records, "fault, cells, refinements, sweeps",
            lambda record: record["problem"].replace("-", ", ")),
    ))
