# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Iterations of TNNMG over numbers of faults that cross in one body, and over their
refinement."""

import pathlib

from common import programs

from . import iterations, pushed_blocks
from .scenes import STATES, Mesh

NUMBERS = (1, 2, 4, 8)
REFINEMENTS = 4
# Of four faults.
LEVELS = (1, 2, 3)
# Cells of half a metre along each side of a square block.
CELLS = 16

SCENE = """subsection Bodies
  set Names     = block
  set Mesh file = {mesh}
  subsection block
    set Uniform refinements = {refinements}
  end
end
subsection Faults
  set Names = {names}
{faults}end
subsection Boundary conditions
  set Sides = block bottom, block top
  subsection block bottom
    set x condition = fixed
    set y condition = fixed
  end
""" + pushed_blocks.END.replace("{top}", "block top").replace("{sweeps}", "1")
FAULT = """  subsection {}
    set Normal stress          = function
    set Normal stress function = 4.9e4
  end
"""


def node(column, row):
    return (CELLS + 1) * row + column + 1


def lines_of_fault(number):
    """Edges of a fault: the first one is level, of 7 m, the others are upright, of 3 m,
    and cross it, one metre from each other."""
    middle = CELLS // 2
    if number == 1:
        return [(node(i, middle), node(i + 1, middle)) for i in range(1, CELLS - 1)]
    place = middle + (0 if number == 8 else number if number % 2 == 0 else 1 - number)
    return [(node(place, i), node(place, i + 1)) for i in range(middle - 3, middle + 3)]


def mesh_text(n_faults):
    """A block of 8 m x 8 m with faults, in the format of Gmsh."""
    names = ["block", "bottom", "top", "ends"] + [f"f{k + 1}" for k in range(n_faults)]
    lines = [(2, node(i, 0), node(i + 1, 0)) for i in range(CELLS)]
    lines += [(3, node(i, CELLS), node(i + 1, CELLS)) for i in range(CELLS)]
    lines += [(4, node(end, i), node(end, i + 1)) for end in (0, CELLS)
              for i in range(CELLS)]
    for number in range(1, n_faults + 1):
        lines += [(4 + number, *ends) for ends in lines_of_fault(number)]
    elements = [(1, *line) for line in lines]
    elements += [
        (3, 1, node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))
        for j in range(CELLS) for i in range(CELLS)
    ]
    return pushed_blocks.mesh_text(
        [(2 if k == 0 else 1, name) for k, name in enumerate(names)],
        [f"{i / 2 - 4} {j / 2 - 4} 0"
         for j in range(CELLS + 1) for i in range(CELLS + 1)],
        elements)


def crossing_scene(n_faults, refinements, folder):
    """Write a scene with its mesh."""
    mesh = folder / f"crossing_{n_faults}.msh"
    mesh.write_text(mesh_text(n_faults))
    names = [f"f{k + 1}" for k in range(n_faults)]
    path = folder / f"crossing_{n_faults}_{refinements}.prm"
    path.write_text(SCENE.format(
        mesh=mesh.name, refinements=refinements, names=", ".join(names),
        faults="".join(map(FAULT.format, names))))
    return Mesh(f"crossing-{n_faults}-{refinements}", f"{n_faults} crossing faults", {},
                str(path), 2, 1)


SECTION = "crossings"


def measure(quick, log):
    records = []
    cases = [(n, REFINEMENTS) for n in NUMBERS] + [(4, level) for level in LEVELS]
    with programs.temporary_folder() as folder:
        for n_faults, refinements in [(1, 2), (8, 2)] if quick else cases:
            mesh = crossing_scene(n_faults, refinements, pathlib.Path(folder))
            iterations.measure_states(SECTION, mesh, STATES, records)
            log(f"{mesh.name} measured")
    return records, None


def text(records, _):
    records = sorted(records, key=lambda record: place(record)[::-1])
    return "\n".join((
        "Iterations / V-cycles, all faults in the same state:\n",
        *iterations.state_tables(
            records, "faults, refinements",
            lambda record: "{}, {}".format(*place(record))),
    ))


def place(record):
    return tuple(map(int, record["problem"].split("-")[1:]))
