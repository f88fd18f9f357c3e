# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Colours, frames and files of figures."""

import io

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from PIL import Image

from pictures.style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION
from pictures.style import WIDTH, YELLOW, edges, title

from .programs import PROJECT

IMAGES = PROJECT / "doc/images"


def new_figure(rows, columns=1, height=8.0, ratios=None, **options):
    plt.rcParams.update({
        "font.size": 9, "axes.titlesize": 9.5, "legend.frameon": False,
        "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False,
    })
    return plt.subplots(
        rows, columns, figsize=(WIDTH, height), layout="constrained",
        gridspec_kw={"height_ratios": ratios} if ratios else None, **options,
    )


def new_panels(n, width, height):
    """A row of panels with a common y axis, for lines over each other."""
    plt.rcParams["svg.hashsalt"] = "stickslip"
    plt.rcParams["font.size"] = 9
    figure, panels = plt.subplots(
        1, n, figsize=(width, height), sharey=True, squeeze=False, layout="constrained"
    )
    for axes in panels[0]:
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(alpha=0.3, linewidth=0.5)
    return figure, panels[0]


def save(figure, name):
    """A PNG file of at most 256 colours, which is small, in doc/images; its path."""
    path = IMAGES / f"{name}.png"
    IMAGES.mkdir(exist_ok=True)
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    plt.close(figure)
    image = Image.open(buffer).convert("RGB")
    image.quantize(
        256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE
    ).save(path, optimize=True)
    return path


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
