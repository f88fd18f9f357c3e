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

SETTINGS = FAST + PLANE + [
    "Output/Volume longest interval=0.05",
    "Output/Volume fields=displacement, velocity, acceleration, stress, strain, body",
    "Output/Checkpoint interval=0.05", "Output/Checkpoints kept=100",
]


class Volume:
    """A VTU or PVTU file; a row for each cell, in the order of their centres: corners,
    and all that it and they have."""

    def __init__(self, path):
        self.names, self.sizes = names_in(path), []
        for file in files(path):
            piece = ElementTree.parse(file).getroot().find(".//Piece")
            self.sizes.append(int(piece.get("NumberOfCells")))
        arrays = sections(path)
        corners = arrays["Cells"]["connectivity"].reshape(-1, 4)
        found = {name: values[corners].reshape(len(corners), -1)
                 for name, values in arrays["PointData"].items()}
        found |= arrays["CellData"]
        self.fields = sorted(found)
        points = arrays["Points"]["Points"][corners]
        # Bodies lie on top of each other, and are told apart by their number.
        keys = np.column_stack([points.mean(axis=1), found["body"]])
        rows = [points.reshape(-1, 12), *(found[name] for name in self.fields)]
        self.rows = np.column_stack(rows)[np.lexsort(np.round(keys, 6).T)]


def listed(folder):
    record = ElementTree.parse(folder / "solution.pvd").getroot()
    return [item.get("file") for item in record.iter("DataSet")]


def check_with_vtk(path, volume):
    try:
        from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader
    except ImportError:
        return
    reader = vtkXMLPUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetNumberOfCells() != sum(volume.sizes):
        yield f"VTK reads {grid.GetNumberOfCells()} cells of {sum(volume.sizes)}"
    names = [data.GetArrayName(k)
             for data in (grid.GetPointData(), grid.GetCellData())
             for k in range(data.GetNumberOfArrays())]
    if sorted(names) != volume.fields:
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
        one = Volume(whole / name)
        joined = Volume(pieces / name.replace(".vtu", ".pvtu"))
        if joined.names != one.names:
            yield f"{name}: names of bodies {joined.names}"
        if sum(joined.sizes) != one.sizes[0]:
            yield f"{name}: {joined.sizes} cells of {one.sizes}"
        elif joined.fields != one.fields:
            yield f"{name}: fields {joined.fields}, not {one.fields}"
        elif not np.array_equal(joined.rows, one.rows):
            yield f"{name}: other values in pieces"
        yield from check_with_vtk(pieces / name.replace(".vtu", ".pvtu"), joined)


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
    if 0 not in Volume(pieces / listed(pieces)[0]).sizes:
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
