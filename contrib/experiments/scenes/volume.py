# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Displacement and stress of the bodies of a plane scene, from VTU files."""

import pathlib
import xml.etree.ElementTree as ElementTree

import numpy as np

from common.vtu_file import sections


class Volume:
    """Quadrilaterals of one VTU or PVTU file, with their four corners in a row around
    them; arrays are (cells x 4) or (cells x 4 x 2), in SI units, fields of cells at each
    corner."""

    def __init__(self, path):
        arrays = sections(path)
        self.corners = arrays["Cells"]["connectivity"].reshape(-1, 4)
        self.points = arrays["Points"]["Points"][self.corners][..., :2].astype(float)
        self.at_points, self.at_cells = arrays["PointData"], arrays["CellData"]
        self.body = self.field("body")[:, 0].astype(int)

    def field(self, name):
        if name in self.at_cells:
            values = self.at_cells[name].astype(float)
            return np.repeat(values[:, None], 4, axis=1)
        return self.at_points[name].astype(float)[self.corners][..., :2]

    def displacement(self):
        return self.field("displacement")

    def sizes(self):
        """Width and height of each cell."""
        return np.ptp(self.points[..., 0], axis=1), np.ptp(self.points[..., 1], axis=1)


def volumes(folder):
    """Times and paths of all files of a run."""
    record = ElementTree.parse(pathlib.Path(folder, "solution.pvd")).getroot()
    entries = record.findall(".//DataSet")
    return (
        np.array([float(entry.get("timestep")) for entry in entries]),
        [pathlib.Path(folder, entry.get("file")) for entry in entries],
    )
