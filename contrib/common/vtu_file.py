# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The arrays of VTU files and of PVTU files, which join some, read without VTK."""

import base64
import pathlib
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

TYPES = {"Float32": np.float32, "Float64": np.float64, "Int64": np.int64,
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


def files(path):
    """The VTU files that a PVTU file joins, or a VTU file itself."""
    path = pathlib.Path(path)
    if path.suffix != ".pvtu":
        return [path]
    return [path.parent / piece.get("Source")
            for piece in ElementTree.parse(path).getroot().iter("Piece")]


def sections(path):
    """All arrays by section and name, such as sections(path)["CellData"]["body"], with
    a row for each point or cell where there are several components; those of the files
    of a PVTU file one after the other, so that points between them are there twice."""
    parts = {name: {} for name in ("Points", "Cells", "PointData", "CellData")}
    first_point = first_corner = 0
    for file in files(path):
        piece = ElementTree.parse(file).getroot().find(".//Piece")
        for section, arrays in parts.items():
            for element in piece.find(section):
                name, n = element.get("Name"), int(element.get("NumberOfComponents"))
                values = decode(element)
                if name == "connectivity":
                    values = values + first_point
                elif name == "offsets":
                    values = values + first_corner
                arrays.setdefault(name, []).append(
                    values.reshape(-1, n) if n > 1 else values)
        first_point += int(piece.get("NumberOfPoints"))
        first_corner += len(parts["Cells"]["connectivity"][-1])
    return {section: {name: np.concatenate(values) for name, values in arrays.items()}
            for section, arrays in parts.items()}


def names_in(path, title="body_names"):
    """The strings of an array of a file; none where it has no such array."""
    array = ElementTree.parse(files(path)[0]).getroot().find(
        f".//FieldData/DataArray[@Name='{title}']")
    if array is None:
        return []
    text = bytes(int(code) for code in array.text.split())
    return text.decode().split("\0")[:-1]
