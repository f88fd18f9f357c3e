# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Scenes of parameters/seas, the mesh of each, and what others found."""

import dataclasses
import math
import sys

import numpy as np

YEAR = 365 * 86400.
# Slip rate, m/s, above which an event goes on.
THRESHOLD = 1e-3
# Pieces of a sequence that are closer to each other, s, are one event.
SHORTEST_INTERVAL = 30 * 86400.

STRIKE_SLIP = ("minus", "plus")
PLANE = ("footwall", "hanging_wall")
ELEMENTS = "boundary elements, 50 m"


@dataclasses.dataclass
class Benchmark:
    """Bodies and mesh of a scene, and the events of other programs."""

    bodies: tuple
    # Cells of the file, m, and its refinement passes.
    cell: float
    passes: int
    # Times of events by program, yr; those of contrib/tools/half_space_cycles.py are the
    # boundary elements.
    events: dict
    # Distance down the dip over depth.
    slope: float = 1.
    # Rows of cells of one size in the file, where smaller cells come in as many rows more:
    # the stiffness of the medium depends on how far they reach.
    rows: int = 0
    # Largest slip rate, m/s, as published.
    largest: float = math.nan


def sums(*intervals):
    return tuple(np.cumsum(intervals).round(3))


BENCHMARKS = {
    "bp1": Benchmark(STRIKE_SLIP, 100., 14, {
        "published, 50 m": sums(196.5, 75.67, 77.87, 78.35, 78.40),
        ELEMENTS: sums(196.50, 75.65, 77.86, 78.34, 78.38, 78.39, 78.39),
    }, largest=4.18),
    "bp2": Benchmark(STRIKE_SLIP, 50., 15, {
        ELEMENTS: (151.3, 210.5, 234.1, 317.8, 339.6, 421.3, 443.1),
    }),
    "bp3_thrust60": Benchmark(PLANE, 50., 15, {
        "FDRA, 25 m": (177.22, 277.53, 334.53, 421.54, 514.05, 611.52, 674.79),
        ELEMENTS: (177.25, 277.68, 334.63, 421.63, 514.08, 611.62, 674.87),
    }, slope=2. / math.sqrt(3.), rows=8),
    "bp3_normal60": Benchmark(PLANE, 50., 15, {
        ELEMENTS: (194.63, 286.38, 381.48, 477.58, 572.45, 667.64),
    }, slope=2. / math.sqrt(3.), rows=8),
    "bp3_thrust30": Benchmark(PLANE, 50., 15, {
        ELEMENTS: (176.31, 263.42, 328.15, 414.79, 479.50, 566.13, 630.85),
    }, slope=2., rows=16),
    "bp3_normal30": Benchmark(PLANE, 50., 15, {
        "FDRA, 25 m": (206.84, 279.40, 392.23, 465.71, 576.42, 650.34),
        ELEMENTS: (206.87, 279.42, 392.24, 465.71, 576.41, 650.32),
    }, slope=2., rows=16),
    # The first event begins at once.
    "bp5": Benchmark(STRIKE_SLIP, 2000., 7, {
        "TriBIE, 1 km": (239.0, 477.3),
        "tandem, 4 km, order 4": (240.87, 480.54),
    }),
}


def settings(name, cell, years, folder):
    """Entries of a run with cells of that size, m."""
    benchmark = BENCHMARKS[name]
    passes = benchmark.passes + math.log2(benchmark.cell / cell)
    if passes != round(passes):
        sys.exit(f"contrib/seas: --cell must be {benchmark.cell:.0f} over or times a power "
                 "of two.")
    result = {f"Bodies/{body}/Refinement passes": round(passes)
              for body in benchmark.bodies}
    if benchmark.rows and cell < benchmark.cell:
        for body in benchmark.bodies:
            result[f"Bodies/{body}/Refinement rows"] = round(
                benchmark.rows * benchmark.cell / cell)
    result["Output/Output directory"] = folder
    if years:
        result["Time/End time"] = years * YEAR
    return result
