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
