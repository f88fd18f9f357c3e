#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Draw the kinds of geometry of doc/geometry.md.

Usage: contrib/geometry [--only HEADING] [--program FILE]

The first indented block below each heading is completed by a boundary condition,
`stickslip --check` makes the meshes of it, and these are drawn:
doc/images/geometry_*.png. Takes some seconds.
"""

import itertools
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from common import figures, programs

PAGE = programs.PROJECT / "doc/geometry.md"
MESHES = ("tests/meshes", "parameters/meshes")
OUTER_SIDES = ("bottom", "far", "outside")
BODY_COLOURS = ("#d9e6f2", "#f2e3cc", "#dcefe2", "#efdde8")
FAULT_COLOURS = (figures.VERMILION, figures.BLUE, figures.GREEN, figures.PURPLE)
# Vertices of a cell of VTK's types in an order that goes round its faces.
LINE, TRIANGLE, QUADRILATERAL = 3, 5, 9


def sections():
    """Headings of the page and the first indented block below each."""
    for part in PAGE.read_text(encoding="utf-8").split("\n## ")[1:]:
        heading, text = part.split("\n", 1)
        block = re.search(r"(?:^    .*\n)+", text, re.M)
        yield heading, re.sub(r"^    ", "", block[0], flags=re.M)


class Body:
    """What --check writes of a body: cells, and faces with the numbers of sides."""

    def __init__(self, path):
        words = path.read_text(encoding="utf-8").split()
        self.points = self.numbers(words, "POINTS", 3, float).reshape(-1, 3)
        at = words.index("CELLS")
        n = int(words[at + 1])
        flat, place = np.array(words[at + 3:at + 3 + int(words[at + 2])], int), 0
        self.cells = []
        for _ in range(n):
            self.cells.append(flat[place + 1:place + 1 + flat[place]])
            place += flat[place] + 1
        at = words.index("CELL_TYPES")
        self.types = np.array(words[at + 2:at + 2 + n], int)
        at = words.index("default", words.index("MaterialID"))
        self.sides = np.array(words[at + 1:at + 1 + n], int)

    @staticmethod
    def numbers(words, name, per_item, kind):
        at = words.index(name)
        return np.array(words[at + 3:at + 3 + per_item * int(words[at + 1])], kind)

    def shapes(self, types, sides=None):
        """Corners of the cells of some types, or of those faces on some sides."""
        return [
            self.points[cell] for cell, kind, side
            in zip(self.cells, self.types, self.sides)
            if kind in types and (sides is None or side in sides)
        ]


def with_condition(block, body, side):
    """The block with a side that is fixed, so that it is a scene."""
    axes = "xyz" if "Dimension = 3" in block else "xy"
    return block + (
        f"subsection Boundary conditions\n  set Sides = {body} {side}\n"
        f"  subsection {body} {side}\n"
        + "".join(f"    set {axis} condition = fixed\n" for axis in axes)
        + "  end\nend\nsubsection Output\n  set Event start slip rate = 1\nend\n")


def check(program, block, folder):
    """What --check prints, and the bodies it writes, by name."""
    for source in MESHES:
        for mesh in (programs.PROJECT / source).glob("*.msh"):
            shutil.copy(mesh, folder)
    scene = pathlib.Path(folder) / "scene.prm"
    names = re.search(r"subsection Bodies\s+set Names\s*= (.*)", block)[1].split(", ")
    # Names of the sides in a file are known to that alone.
    for body, side in itertools.product(names, OUTER_SIDES):
        scene.write_text(with_condition(block, body, side))
        run = subprocess.run(
            [program, "--check", scene, "--set", f"Output/Output directory={folder}"],
            capture_output=True, text=True)
        if run.returncode == 0:
            return run.stdout, {
                name: Body(pathlib.Path(folder) / f"mesh_{name}.vtk")
                for name in names}
    raise programs.Failed(run.stderr)


def fault_sides(report):
    """For each fault its name and the body and number of each part of its sides."""
    faults = []
    for line in report[report.index("Faults:"):].splitlines()[1:]:
        part = re.match(r"    (?:first|second) side on (\S+) \((\d+)\)", line)
        if part:
            faults[-1][1].append((part[1], int(part[2])))
        elif re.match(r"  \S+$", line):
            faults.append((line.strip(), []))
    return faults


def draw_plane(bodies, faults):
    points = np.concatenate([body.points for body in bodies.values()])
    shape = np.ptp(points[:, 1]) / np.ptp(points[:, 0])
    figure, axes = figures.new_figure(1, height=min(0.9 + 6.5 * shape, 3.6))
    for colour, (name, body) in zip(BODY_COLOURS, bodies.items()):
        cells = [corners[:, :2] for corners in body.shapes((TRIANGLE, QUADRILATERAL))]
        axes.add_collection(PolyCollection(
            cells, facecolors=colour, edgecolors="#888888", linewidths=0.5))
        axes.plot([], [], "s", color=colour, markeredgecolor="#888888", label=name)
    for colour, (name, parts) in zip(FAULT_COLOURS, faults):
        for body, side in parts:
            lines = [line[:, :2] for line in bodies[body].shapes((LINE,), (side,))]
            axes.add_collection(LineCollection(lines, colors=colour, linewidths=2.2))
        axes.plot([], [], color=colour, linewidth=2.2, label=f"fault {name}")
    unit = 1e3 if np.ptp(points[:, 0]) > 2e4 else 1
    axes.xaxis.set_major_formatter(lambda x, _: f"{x / unit:g}")
    axes.yaxis.set_major_formatter(lambda y, _: f"{y / unit:g}")
    unit_name = "km" if unit > 1 else "m"
    axes.set(aspect="equal", xlabel=f"x [{unit_name}]", ylabel=f"y [{unit_name}]")
    axes.autoscale_view()
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure


def draw_space(bodies, faults):
    figure = figures.plt.figure(figsize=(figures.WIDTH, 4.2), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    at_faults = {part for _, parts in faults for part in parts}
    for colour, (name, body) in zip(BODY_COLOURS, bodies.items()):
        outer = set(body.sides) - {0} - {side for of, side in at_faults if of == name}
        axes.add_collection3d(Poly3DCollection(
            body.shapes((TRIANGLE, QUADRILATERAL), outer), facecolors=colour,
            edgecolors="#999999", linewidths=0.3, alpha=0.12))
        axes.plot([], [], "s", color=colour, markeredgecolor="#888888", label=name)
    for colour, (name, parts) in zip(FAULT_COLOURS, faults):
        for body, side in parts[:1]:
            axes.add_collection3d(Poly3DCollection(
                bodies[body].shapes((TRIANGLE, QUADRILATERAL), (side,)),
                facecolors=colour, edgecolors="white", linewidths=0.4))
        axes.plot([], [], "s", color=colour, label=f"fault {name}")
    points = np.concatenate([body.points for body in bodies.values()])
    axes.set_xlim(points[:, 0].min(), points[:, 0].max())
    axes.set_ylim(points[:, 1].min(), points[:, 1].max())
    axes.set_zlim(points[:, 2].min(), points[:, 2].max())
    axes.set_box_aspect(np.ptp(points, axis=0))
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    axes.legend(loc="center left", bbox_to_anchor=(1.05, 0.5))
    return figure


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--only")
    parser.add_argument("--program", default=programs.PROGRAM)
    arguments = parser.parse_args()
    for heading, block in sections():
        if arguments.only not in (None, heading):
            continue
        with programs.temporary_folder() as folder:
            report, bodies = check(arguments.program, block, folder)
        draw = draw_space if "Dimension = 3" in block else draw_plane
        figure = draw(bodies, fault_sides(report))
        name = "geometry_" + heading.lower().replace(" ", "_")
        print(f"{figures.save(figure, name)} is written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
