# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Processor time that the search for a mesh takes."""

import tempfile

from common import programs

ENTRY = "Mesh/Accuracy"
# Short runs, of which the fastest counts.
REPEATS = 3
END = {"Time/End time": "1e-3"}


def seconds(program, scene, settings, refined_cells):
    """User and system time in s that a run takes longer which searches than one that
    reads the file of cells that the search has found."""
    found = {ENTRY: "0", "Mesh/Refined cells": str(refined_cells)}
    return (fastest(program, scene, settings | END)
            - fastest(program, scene, settings | END | found))


def fastest(program, scene, settings):
    times = []
    for _ in range(REPEATS):
        with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
            files = {"Output/Output directory": folder}
            used, note = programs.run_measured(
                [str(program), scene] + programs.options(settings | files), 300.0
            )
        if note:
            raise programs.Failed(f"{scene}: {note}")
        times.append(used)
    return min(times)
