# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The arrays of VTU files, read without VTK."""

import base64
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


def names_in(path, title="body_names"):
    """The strings of an array of a file; none where it has no such array."""
    array = ElementTree.parse(path).getroot().find(
        f".//FieldData/DataArray[@Name='{title}']")
    if array is None:
        return []
    text = bytes(int(code) for code in array.text.split())
    return text.decode().split("\0")[:-1]
