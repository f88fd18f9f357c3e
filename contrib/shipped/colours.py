# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Colours, and slip rates over time and position."""

import numpy as np
from matplotlib.colors import LogNorm
from measure.figures import BLACK, BLUE, GREEN, GREY, ORANGE, VERMILION
from plot_run import edges

__all__ = ["BLACK", "BLUE", "GREEN", "GREY", "ORANGE", "VERMILION", "draw_map"]


def draw_map(figure, axes, history, window, limits):
    """Slip rates along a fault within a window of time."""
    chosen = (history.time >= window[0]) & (history.time <= window[1])
    time, rate = history.time[chosen], history.rate()[chosen]
    image = axes.pcolormesh(
        edges(time), edges(history.x), np.clip(rate, *limits).T, norm=LogNorm(*limits),
        cmap="viridis", shading="flat", rasterized=True,
    )
    axes.set(xlim=(time[0], time[-1]), xlabel="time [s]", ylabel="x [m]")
    figure.colorbar(image, ax=axes, label="slip rate [m/s]", pad=0.01)
