# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Displacement and stress of the bodies of a plane scene, from VTU files."""

import base64
import pathlib
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

TYPES = {"Float32": np.float32, "Float64": np.float64, "Int32": np.int32,
         "UInt8": np.uint8}


def decode(element):
    """The numbers of a DataArray: sizes of the blocks, then the compressed blocks."""
    kind = TYPES[element.get("type")]
    text = element.text.strip()
    if element.get("format") == "ascii":
        return np.array(text.split(), dtype=kind)
    n_blocks = int(np.frombuffer(base64.b64decode(text[:8])[:4], np.uint32)[0])
    header_length = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    sizes = np.frombuffer(base64.b64decode(text[:header_length]), np.uint32)[3:]
    data, result, begin = base64.b64decode(text[header_length:]), b"", 0
    for size in sizes[:n_blocks]:
        result += zlib.decompress(data[begin : begin + int(size)])
        begin += int(size)
    return np.frombuffer(result, kind)


class Volume:
    """Cells of one file: each has four corners of its own, in the order in which they
    are written; arrays are (cells x 4) or (cells x 4 x 2), in SI units."""

    def __init__(self, path):
        piece = ElementTree.parse(path).getroot().find(".//Piece")
        cells = decode(piece.find("Cells/DataArray[@Name='connectivity']"))
        corners = cells.reshape(-1, 4)
        points = decode(piece.find("Points/DataArray")).reshape(-1, 3)
        self.points = points[corners][..., :2].astype(float)
        self.fields = {
            array.get("Name"): array for array in piece.findall("PointData/DataArray")
        }
        self.corners = corners
        self.body = self.field("body")[:, 0].astype(int)

    def field(self, name):
        array = self.fields[name]
        values = decode(array).astype(float)
        if array.get("NumberOfComponents") == "3":
            return values.reshape(-1, 3)[self.corners][..., :2]
        return values[self.corners]

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
