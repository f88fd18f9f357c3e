# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Step sizes, and the iterations that each step took."""

import numpy as np

from .over_time import time_axis
from .style import BLUE, GREEN, VERMILION, title

# Parts of the time axis in which steps are looked at together.
N_PARTS = 300

COUNTS = (
    ("rate_state_iterations", "rate-state\niterations", GREEN),
    ("tnnmg_iterations", "TNNMG\niterations", VERMILION),
    ("multigrid_cycles", "multigrid\ncycles", BLUE),
)


def sizes(axis, run):
    factor = time_axis(axis, run)
    axis.semilogy(factor * run.series["time"], run.series["step_size"], color=BLUE,
                  linewidth=0.8)
    axis.set_ylabel("step size [s]")
    title(axis, f"{len(run.series['time'])} time steps")


def in_parts(time, values):
    """Least, mean and largest of the values in each part of the time, where there are
    any; the middle of these parts."""
    begin, end = time[0], time[-1]
    part = np.minimum(
        ((time - begin) / max(end - begin, 1e-300) * N_PARTS).astype(int), N_PARTS - 1)
    found, first, count = np.unique(part, return_index=True, return_counts=True)
    middle = begin + (found + 0.5) / N_PARTS * (end - begin)
    return (middle, np.minimum.reduceat(values, first),
            np.add.reduceat(values, first) / count, np.maximum.reduceat(values, first))


def iterations(axes, run):
    """Each count on a panel of its own: mean and range of the steps at a time."""
    for axis, (column, label, colour) in zip(axes, COUNTS):
        factor = time_axis(axis, run)
        values = run.series[column]
        middle, least, mean, largest = in_parts(run.series["time"], values)
        axis.fill_between(factor * middle, least, largest, color=colour, alpha=0.25,
                          linewidth=0)
        axis.plot(factor * middle, mean, color=colour, linewidth=0.9)
        axis.set_ylim(0, 1.1 * max(values.max(), 1))
        axis.set_ylabel(label)
        axis.text(0.995, 0.97, f"mean {values.mean():.1f}, most {values.max():.0f}",
                  transform=axis.transAxes, ha="right", va="top", fontsize=8)
        if axis is not axes[-1]:
            axis.set_xlabel("")
            axis.tick_params(labelbottom=False)
    title(axes[0], "Work of a time step: mean, and range (shaded)")
