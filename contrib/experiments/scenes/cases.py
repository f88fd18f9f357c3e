# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""What is run for doc/scenes.md, and what all its sections use."""

import dataclasses

import numpy as np

from common.store import Case

PARAMETERS = "parameters"


@dataclasses.dataclass
class Outcome:
    """What a section has to tell: tables in Markdown, and functions that draw its
    figures, by name."""

    text: str
    figures: dict


def case(title, name, settings=None):
    """A shipped scene with some entries set anew."""
    return Case(
        title, f"{PARAMETERS}/{name}.prm", tuple(sorted((settings or {}).items()))
    )


def cost(run):
    """Steps, iterations a step and time of a run, as the cells of a table."""
    series = run.series()
    steps = len(series["time"])
    return (
        f"{steps:,}",
        f"{run.summary_number('Steps/rejected'):.0f}",
        f"{series['tnnmg_iterations'].mean():.2f}",
        f"{series['multigrid_cycles'].mean():.2f}",
        f"{run.cpu_seconds:.0f}",
    )


COST_TITLES = (
    "steps", "rejected", "TNNMG iterations a step", "multigrid cycles a step",
    "CPU seconds",
)


def maxima(time, values):
    """Times and values of the local maxima, each from the parabola through three
    points."""
    middle = np.flatnonzero(
        (values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:])
    ) + 1
    found = []
    for k in middle:
        t = time[k - 1 : k + 2] - time[k]
        a, b, c = np.polyfit(t, values[k - 1 : k + 2], 2)
        found.append((time[k] - b / (2 * a), c - b * b / (4 * a)))
    return np.array(found).reshape(-1, 2).T
