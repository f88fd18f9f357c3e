#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the fields in a run's last VTU file and in faults.h5 belong together.

Usage: check_output_fields.py FOLDER LOAD

For a run of two plane bodies of the default material without gravity that has
written all fields. Prints one line for each contradiction and returns 1 if there are
any:

- the strain of each cell is that of the displacement, the stress follows from it by
  Hooke's law;
- the stress out of the plane is that of plane strain;
- VTK reads the same from the file, with units and the names of the bodies;
- the forces on the upper body, that of the contact and LOAD from above, N/m, give it
  its vertical acceleration.
"""

import pathlib
import sys

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "contrib"))

from experiments.scenes.volume import Volume, volumes

YOUNGS_MODULUS, POISSONS_RATIO, DENSITY = 4.12e7, 0.3, 5000.0
BODIES = ["lower", "upper"]
UNITS = {"displacement": "m", "velocity": "m/s", "acceleration": "m/s^2",
         "stress": "Pa", "strain": "1"}
# Files hold numbers of single precision.
PRECISION = 2e-6


def strains(volume):
    """xx, xy, yy at the centres of cells that are parallel to the axes."""
    centred = volume.points - volume.points.mean(axis=1, keepdims=True)
    sides = np.sign(centred)
    size = np.stack(volume.sizes(), axis=-1)
    u = volume.displacement()
    # gradient[cell, component, axis]
    gradient = np.einsum("kic,kia->kca", u, sides) / 2 / size[:, None, :]
    return np.stack(
        [gradient[:, 0, 0], (gradient[:, 0, 1] + gradient[:, 1, 0]) / 2,
         gradient[:, 1, 1]], axis=-1,
    )


def tensor(volume, name):
    return np.stack(
        [volume.field(f"{name}_{axes}")[:, 0] for axes in ("xx", "xy", "yy")], axis=-1
    )


def is_near(a, b, size):
    return np.abs(a - b).max() <= PRECISION * size


def check_with_vtk(path, volume):
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkDataArray
        from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        return
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    names = grid.GetFieldData().GetAbstractArray("body_names")
    if [names.GetValue(k) for k in range(names.GetNumberOfValues())] != BODIES:
        yield "VTK reads other names of bodies"
    for data, arrays in ((grid.GetPointData(), volume.at_points),
                         (grid.GetCellData(), volume.at_cells)):
        if {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())} != set(arrays):
            yield f"VTK does not read {sorted(arrays)}"
            return
        for name, values in arrays.items():
            array = data.GetArray(name)
            if not np.array_equal(vtk_to_numpy(array), values):
                yield f"VTK reads another {name}"
            unit = array.GetInformation().Get(vtkDataArray.UNITS_LABEL())
            if unit != UNITS.get(name.split("_")[0]):
                yield f"VTK reads {name} in {unit}"
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    areas = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Area"))
    if not is_near(areas, np.prod(volume.sizes(), axis=0), areas.max()):
        yield "VTK has cells of another size"


def check(folder, load):
    volume = Volume(volumes(folder)[1][-1])
    strain = tensor(volume, "strain")
    size = np.abs(volume.displacement()).max() / min(map(np.min, volume.sizes()))
    if not is_near(strain, strains(volume), size):
        yield "the strain is not that of the displacement"
    shear = YOUNGS_MODULUS / 2 / (1 + POISSONS_RATIO)
    lame = shear * 2 * POISSONS_RATIO / (1 - 2 * POISSONS_RATIO)
    stress = 2 * shear * strain
    stress[:, [0, 2]] += lame * (strain[:, [0]] + strain[:, [2]])
    if not is_near(tensor(volume, "stress"), stress, np.abs(stress).max()):
        yield "the stress does not follow from the strain"

    out_of_plane = POISSONS_RATIO * (stress[:, 0] + stress[:, 2])
    if not is_near(volume.field("stress_zz")[:, 0], out_of_plane, np.abs(stress).max()):
        yield "the stress out of the plane is not that of plane strain"
    yield from check_with_vtk(volumes(folder)[1][-1], volume)

    area = np.prod(volume.sizes(), axis=0)
    upper = volume.body == 1
    acceleration = volume.field("acceleration")[..., 1].mean(axis=1)
    inertia = DENSITY * (area * acceleration)[upper].sum()
    with h5py.File(folder / "faults.h5") as file:
        fault = file["fault"]
        contact = fault["contact_weight"][-1] @ fault["contact_pressure"][-1]
        if not np.array_equal(fault["contact_weight"][0], fault["weight"]):
            yield "the weights of the first record are not those of the start"
    size_of_forces = abs(contact) + abs(load) + abs(inertia)
    if abs(inertia) < 1e-3 * size_of_forces:
        yield f"the inertia is too small to tell anything: {inertia} N/m"
    if not is_near(contact, load + inertia, size_of_forces):
        yield f"contact {contact} N/m, load {load} N/m, inertia {inertia} N/m"


def main():
    problems = list(check(pathlib.Path(sys.argv[1]), float(sys.argv[2])))
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
