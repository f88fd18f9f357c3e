#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the VTU files of the faults agree with the other files of a run.

Usage: check_fault_surfaces.py [--box] FOLDER FAULT...

Prints one line for each contradiction and returns 1 if there are any. Files are read
without VTK, and once more with it where its Python modules are there:

- faults.pvd lists all files, at the times of solution.pvd;
- a node is where a point of the bodies with the same reference position is that has
  been displaced with them;
- fields and axes are those of the last record in faults.h5;
- axes are orthonormal, and the normal is normal to the faces around a node;
- cells of bodies that fill a box (--box) do so as VTK sees them;
- faces join all nodes, and in two dimensions the way along the fault is the length of
  the faces on it.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "contrib"))

from common.vtu_file import decode

UNITS = {"slip": "m", "slip_rate": "m/s", "shear_traction": "Pa", "normal_stress": "Pa",
         "state": "s", "contact_pressure": "Pa", "gap": "m", "opening_rate": "m/s",
         "contact_state": "1"}
CORNERS = {3: 2, 5: 3, 9: 4}
# The bodies' files are of single precision.
PRECISION = 3e-7


class Surface:
    """One file, read by the rules of the format."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.time = float(root.find(".//FieldData/DataArray[@Name='TIME']").text)
        piece = root.find(".//Piece")
        self.arrays, self.units = {}, {}
        for array in piece.iter("DataArray"):
            values = decode(array)
            n = int(array.get("NumberOfComponents"))
            self.arrays[array.get("Name")] = values.reshape(-1, n) if n > 1 else values
            key = array.find("InformationKey")
            self.units[array.get("Name")] = None if key is None else key.text
        self.points = self.arrays["Points"]
        ends = self.arrays["offsets"]
        begins = np.concatenate(([0], ends[:-1]))
        self.cells = [self.arrays["connectivity"][a:b] for a, b in zip(begins, ends)]


def listed(path):
    return [(float(entry.get("timestep")), int(entry.get("part")), entry.get("file"))
            for entry in ElementTree.parse(path).getroot().iter("DataSet")]


def points_of_bodies(path):
    """Reference positions and displacements of all points in a file of the bodies."""
    piece = ElementTree.parse(path).getroot().find(".//Piece")
    arrays = {array.get("Name"): array for array in piece.iter("DataArray")}
    return (decode(piece.find("Points/DataArray")).reshape(-1, 3).astype(float),
            decode(arrays["displacement"]).reshape(-1, 3).astype(float))


def check_positions(name, reference, surface, bodies):
    points, displacement = bodies
    size = np.abs(points).max()
    moved = np.abs(displacement).max()
    for node, now in zip(reference, surface.points):
        here = np.abs(points - node).max(axis=1) < 1e-6 * size
        if not here.any():
            yield f"{name}: no body has a point at {node}"
            return
        error = np.abs(node + displacement[here] - now).max(axis=1).min()
        if error > PRECISION * moved:
            yield f"{name}: the node of {node} is at {now}, off by {error}"
            return


def check_shape(name, group, surface, dim):
    n_nodes = len(group["coordinates"])
    cells = np.concatenate(surface.cells)
    if set(range(n_nodes)) - set(cells):
        yield f"{name}: nodes without a face"
    for cell, kind in zip(surface.cells, surface.arrays["types"]):
        if CORNERS[kind] != len(cell):
            yield f"{name}: a cell of kind {kind} has {len(cell)} corners"
    faces = [list(face[face >= 0]) for face in group["faces"][...]]
    if [list(cell) for cell in surface.cells] != faces:
        yield f"{name}: other faces in faults.h5"

    tangents = ["tangent"] if dim == 2 else ["tangent_1", "tangent_2"]
    axes = np.stack([surface.arrays[axis] for axis in tangents + ["normal"]], axis=1)
    products = np.einsum("kid,kjd->kij", axes, axes)
    if np.abs(products - np.eye(dim)).max() > 1e-12:
        yield f"{name}: the axes are not orthonormal"
    if np.abs(axes[..., :dim] - group["axes"][...]).max() > 1e-12:
        yield f"{name}: other axes in faults.h5"

    # Normals at nodes against those of the faces, which turn by less than this.
    points = np.zeros((n_nodes, 3))
    points[:, :dim] = group["coordinates"][...]
    for face in faces:
        x = points[face]
        sides = [x[1] - x[0]] if dim == 2 else [x[1] - x[0], x[-1] - x[0]]
        for side in sides:
            if np.abs(axes[face, -1] @ side).max() > 0.3 * np.linalg.norm(side):
                yield f"{name}: at the face {face} the normal is not normal"

    if dim == 2:
        along = group["arc_length"][...]
        for face in faces:
            length = np.linalg.norm(points[face[1]] - points[face[0]])
            way = along[face[1]] - along[face[0]]
            # One face closes a ring.
            is_closing = abs(abs(way) + length - sum(
                np.linalg.norm(points[f[1]] - points[f[0]]) for f in faces)) < 1e-12
            if abs(abs(way) - length) > 1e-12 and not is_closing:
                yield f"{name}: {way} m along the face {face} of {length} m"
            tangent = axes[face, 0].mean(axis=0)
            if not is_closing and way * (tangent @ (points[face[1]] - points[face[0]])) < 0:
                yield f"{name}: the way along it does not follow the tangents"
        if along.min() != 0:
            yield f"{name}: the way along it begins at {along.min()}"


def check_fields(name, group, surface):
    if group["time"][-1] != surface.time:
        yield f"{name}: the last record is of {group['time'][-1]}, not {surface.time}"
        return
    for field, units in UNITS.items():
        if (field in group) != (field in surface.arrays):
            yield f"{name}: {field} is in one of the files only"
        elif field in group:
            if surface.units[field] != units:
                yield f"{name}: {field} has the units {surface.units[field]}"
            n_nodes = len(group["coordinates"])
            if not np.array_equal(surface.arrays[field][:n_nodes], group[field][-1]):
                yield f"{name}: {field} differs"
    if "position" in group and not np.array_equal(
            group["position"][-1], surface.points[:, :group["position"].shape[2]]):
        yield f"{name}: other positions in faults.h5"


def check_with_vtk(name, path, surface):
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkDataArray
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        return
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    if not np.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), surface.points):
        yield f"{name}: VTK reads other points"
    cells = [[grid.GetCell(c).GetPointId(v)
              for v in range(grid.GetCell(c).GetNumberOfPoints())]
             for c in range(grid.GetNumberOfCells())]
    if cells != [list(cell) for cell in surface.cells]:
        yield f"{name}: VTK reads other cells"
    data = grid.GetPointData()
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if not np.array_equal(vtk_to_numpy(array), surface.arrays[array.GetName()]):
            yield f"{name}: VTK reads another {array.GetName()}"
        units = array.GetInformation().Get(vtkDataArray.UNITS_LABEL())
        if (units or "").strip() != (surface.units[array.GetName()] or ""):
            yield f"{name}: VTK reads {array.GetName()} in {units}"


def check_bodies_with_vtk(path, size):
    """VTK reads cells of the bodies that fill their box, SIZE in area or volume."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        return
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    cells = sizes.GetOutput().GetCellData()
    is_plane = not vtk_to_numpy(sizes.GetOutput().GetPoints().GetData())[:, 2].any()
    found = vtk_to_numpy(cells.GetArray("Area" if is_plane else "Volume"))
    if not found.min() > 0 or abs(found.sum() - size) > 1e-5 * size:
        yield f"{path.name}: VTK reads cells of {found.min()} to a sum of {found.sum()}"


def check(folder, faults, is_box):
    files, volumes = listed(folder / "faults.pvd"), listed(folder / "solution.pvd")
    expected = [(time, part, f"fault_{fault}_{number:05d}.vtu")
                for number, (time, _, _) in enumerate(volumes)
                for part, fault in enumerate(faults)]
    if files != expected:
        yield f"faults.pvd lists {files}"
        return
    if {name for _, _, name in files} != {p.name for p in folder.glob("fault_*.vtu")}:
        yield "there are other files than in faults.pvd"
    bodies = points_of_bodies(folder / volumes[-1][2])
    if is_box:
        yield from check_bodies_with_vtk(
            folder / volumes[-1][2], np.prod([e for e in np.ptp(bodies[0], axis=0) if e]))
    with h5py.File(folder / "faults.h5", "r") as file:
        for time, _, name in files[-len(faults):]:
            fault = name[len("fault_"):-len("_00000.vtu")]
            surface, group = Surface(folder / name), file[fault]
            if surface.time != time:
                yield f"{name} is of the time {surface.time}"
            dim = group["coordinates"].shape[1]
            reference = np.zeros((len(group["coordinates"]), 3))
            reference[:, :dim] = group["coordinates"][...]
            yield from check_positions(fault, reference, surface, bodies)
            yield from check_shape(fault, group, surface, dim)
            yield from check_fields(fault, group, surface)
            yield from check_with_vtk(fault, folder / name, surface)


def main():
    is_box = sys.argv[1] == "--box"
    folder, *faults = sys.argv[2 if is_box else 1:]
    problems = list(check(pathlib.Path(folder), faults, is_box))
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
