#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the VTU files of several processes joined are the one file of a process.

Usage: check_volume_pieces.py PROGRAM MPIEXEC

Runs a scene with 'Volume pieces', and goes on with other numbers of processes; prints
what is wrong and returns 1 if there is anything:

- together the pieces have the cells of the one file, each once, with the same fields,
  and at the corners of each the same values of points;
- VTK reads as many cells from the PVTU file, and the same fields;
- so it is where there are fewer cells than processes, and pieces are empty;
- solution.pvd lists PVTU files, and there are the pieces of these only, also after a
  restart from an earlier checkpoint, and none after a new run without.
"""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "contrib"))

from check_restart import FAST, PLANE, read_scene
from common.vtu_file import files, names_in, sections
from experiments.scenes.volume import Volume, volumes

SETTINGS = FAST + PLANE + [
    "Output/Volume longest interval=0.05",
    "Output/Volume fields=displacement, velocity, acceleration, stress, strain, body",
    "Output/Checkpoint interval=0.05", "Output/Checkpoints kept=100",
]


def listed(folder):
    return [path.name for path in volumes(folder)[1]]


def sizes(path):
    """Numbers of cells of the pieces."""
    pieces = [ElementTree.parse(file).getroot().find(".//Piece") for file in files(path)]
    return [int(piece.get("NumberOfCells")) for piece in pieces]


def fields(volume):
    return sorted([*volume.at_points, *volume.at_cells])


def rows(path):
    """A row for each cell, in the order of their centres: corners, and all that it and
    they have."""
    volume, points = Volume(path), sections(path)["Points"]["Points"]
    n_cells = len(volume.corners)
    found = {name: values[volume.corners].reshape(n_cells, -1)
             for name, values in volume.at_points.items()} | volume.at_cells
    # Bodies lie on top of each other, and are told apart by their number.
    keys = np.column_stack([volume.points.mean(axis=1), volume.body])
    columns = [points[volume.corners].reshape(n_cells, -1),
               *(found[name] for name in fields(volume))]
    return np.column_stack(columns)[np.lexsort(np.round(keys, 6).T)]


def check_with_vtk(path, volume):
    try:
        from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader
    except ImportError:
        return
    reader = vtkXMLPUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetNumberOfCells() != len(volume.corners):
        yield f"VTK reads {grid.GetNumberOfCells()} cells of {len(volume.corners)}"
    names = [data.GetArrayName(k)
             for data in (grid.GetPointData(), grid.GetCellData())
             for k in range(data.GetNumberOfArrays())]
    if sorted(names) != fields(volume):
        yield f"VTK reads {names}"


def check_folder(folder, n_processes):
    """What is wrong with the files of a run with pieces."""
    names = listed(folder)
    if not names or any(not name.endswith(".pvtu") for name in names):
        yield f"solution.pvd lists {names}"
    wanted = {piece for name in names for piece in files(folder / name)}
    present = set(folder.glob("*/*.vtu"))
    if wanted != present:
        yield f"pieces that are missing or too many: {wanted ^ present}"
    if list(folder.glob("solution_*.vtu")):
        yield "there are files in one piece, too"
    if len(files(folder / names[-1])) != n_processes:
        yield f"the last file has not {n_processes} pieces"


def compare(whole, pieces):
    """What differs between the files of two runs."""
    if [name.replace(".pvtu", ".vtu") for name in listed(pieces)] != listed(whole):
        yield "there are other files in one piece"
    for name in listed(whole):
        in_pieces = pieces / name.replace(".vtu", ".pvtu")
        one, joined = Volume(whole / name), Volume(in_pieces)
        if names_in(in_pieces) != names_in(whole / name):
            yield f"{name}: names of bodies {names_in(in_pieces)}"
        if len(joined.corners) != len(one.corners):
            yield f"{name}: {sizes(in_pieces)} cells of {len(one.corners)}"
        elif fields(joined) != fields(one):
            yield f"{name}: fields {fields(joined)}, not {fields(one)}"
        elif not np.array_equal(rows(in_pieces), rows(whole / name)):
            yield f"{name}: other values in pieces"
        yield from check_with_vtk(in_pieces, joined)


def check(program, mpiexec, folder):
    pieces, whole = folder / "pieces", folder / "whole"

    def run(n_processes, output, *options, settings=()):
        command = [mpiexec, "-np", str(n_processes), program, "scene.prm", *options]
        given = [f"Output/Output directory={output.name}",
                 f"Output/Volume pieces={'true' if output == pieces else 'false'}"]
        for setting in [*SETTINGS, *given, *settings]:
            command += ["--set", setting]
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)

    scene = read_scene(pathlib.Path(__file__).resolve().parent)
    (folder / "scene.prm").write_text(scene, encoding="utf-8")
    run(3, whole)
    run(3, pieces)
    yield from check_folder(pieces, 3)
    yield from compare(whole, pieces)

    states = sorted((pieces / "checkpoints").glob("*.state"))
    for state in states[len(states) // 2:]:
        state.unlink()
    run(4, pieces, "--restart")
    yield from check_folder(pieces, 4)

    few_cells = ["Time/End time=0.1"]
    for body in ("lower", "upper"):
        few_cells += [f"Bodies/{body}/Coarse cells=1, 1",
                      f"Bodies/{body}/Refinement passes=0"]
    run(4, whole, "--overwrite", settings=few_cells)
    run(4, pieces, "--overwrite", settings=few_cells)
    yield from check_folder(pieces, 4)
    yield from compare(whole, pieces)
    if 0 not in sizes(pieces / listed(pieces)[0]):
        yield "no piece is empty"

    again = pieces.rename(folder / "again")
    run(1, again, "--overwrite", settings=few_cells)
    if list(again.glob("*/*.vtu")) or list(again.glob("*.pvtu")):
        yield "a new run leaves pieces of the earlier one"


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        problems = list(check(sys.argv[1], sys.argv[2], pathlib.Path(folder)))
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
