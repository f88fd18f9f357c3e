# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Colours, units and limits of figures, and their files."""

import io

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

# Okabe and Ito's colours, which the colour-blind can tell apart.
BLUE, ORANGE, GREEN, VERMILION, SKY, PURPLE, YELLOW, BLACK, GREY = (
    "#0072b2", "#e69f00", "#009e73", "#d55e00",
    "#56b4e9", "#cc79a7", "#b8a800", "#000000", "#777777",
)
COLOURS = (VERMILION, BLUE, ORANGE, GREEN, SKY, PURPLE, YELLOW, BLACK)
# Inches: the width of a page.
WIDTH = 9.0
YEAR = 365 * 86400.0


def panels(heights, columns=1, width=WIDTH):
    """A figure with that many rows of panels (inches high) and columns; the panels."""
    plt.rcParams.update({
        "font.size": 9, "axes.titlesize": 10, "legend.frameon": False,
        "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False,
    })
    return plt.subplots(len(heights), columns, figsize=(width, sum(heights)),
                        layout="constrained", squeeze=False,
                        gridspec_kw={"height_ratios": heights})


def png(figure, dpi=110):
    """The bytes of a picture of a figure, which is closed."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=dpi)
    plt.close(figure)
    return buffer.getvalue()


def scaled(size, unit):
    """By what to multiply numbers of this size and SI unit for a figure, and their
    unit then."""
    if unit == "m^2" or not (np.isfinite(size) and size > 0):
        return 1.0, unit
    smallest = 0.5 if unit == "m" else 0.999
    prefixes = {"m": ((1e-3, "k"), (1, ""), (1e3, "m"), (1e6, "µ"), (1e9, "n"))}.get(
        unit, ((1e-9, "G"), (1e-6, "M"), (1e-3, "k"), (1, ""), (1e3, "m"), (1e6, "µ")))
    for factor, prefix in prefixes:
        # Lengths of a few kilometres and more are in these.
        if factor * size >= (5 if (unit, prefix) == ("m", "k") else smallest):
            return factor, prefix + unit
    return prefixes[-1][0], prefixes[-1][1] + unit


def time_scale(extent):
    """The same for times, by the length of what is shown, s."""
    for length, unit in ((YEAR, "yr"), (86400.0, "d")):
        if extent > 3 * length:
            return 1 / length, unit
    return (1, "s") if extent >= 0.05 else (1e3, "ms")


def rate_limits(rates):
    """The powers of ten that slip rates are drawn between: all of them, but twelve at
    most below the largest."""
    rates = np.concatenate([np.ravel(r) for r in rates])
    rates = rates[np.isfinite(rates) & (rates > 0)]
    if len(rates) == 0:
        return 1e-12, 1e-6
    top = 10 ** np.ceil(np.log10(rates.max()) + 0.05)
    bottom = 10 ** np.floor(np.log10(rates.min()))
    return max(bottom, top * 1e-12) if bottom < top / 10 else top / 100, top


def edges(centres):
    """Limits of the cells around the given points."""
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middle = (centres[1:] + centres[:-1]) / 2
    return np.concatenate(([centres[0]], middle, [centres[-1]]))


def say(axis, text):
    """A few words in place of curves."""
    axis.text(0.5, 0.5, text, transform=axis.transAxes, ha="center", va="center")


def title(axis, text):
    axis.set_title(text, loc="left")
