# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Figure of the errors over meshes and tolerances together."""

from common import figures
from common.figures import (
    BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, YELLOW,
)

from . import front, mesh_and_time_text as texts
from .cases import DEFAULT_TOLERANCE
from .tables import value

STYLES = {
    "published": (BLACK, "o", "-"),
    "40 x 8 cells, 1 pass": (GREY, "s", "--"),
    "80 x 16 cells, 1 pass": (GREY, "D", "--"),
    "accuracy 3e-2": (YELLOW, "o", "-"),
    "accuracy 1.5e-2": (ORANGE, "o", "-"),
    "accuracy 1e-2": (ORANGE, "^", "-"),
    "accuracy 7.5e-3": (VERMILION, "o", "-"),
    "accuracy 6e-3": (PURPLE, "^", "-"),
    "accuracy 5e-3": (PURPLE, "o", "-"),
    "accuracy 3e-3": (SKY, "o", "-"),
    "accuracy 2e-3": (BLUE, "o", "-"),
    "at least 40 x 8 cells, accuracy 3e-3": (YELLOW, "D", "-."),
    "at least 64 x 12 cells, accuracy 3e-3": (VERMILION, "D", "-."),
    "at least 64 x 12 cells, accuracy 2e-3": (PURPLE, "D", "-."),
    "at least 80 x 16 cells, accuracy 2e-3": (SKY, "D", "-."),
}


def draw(records, label_ticks):
    """Error against two costs, a line for each mesh, with the default tolerance
    marked."""
    figure, panels = figures.new_panels(2, 10.0, 4.6)
    grid = texts.grid_of(records)
    labels = ("CPU seconds to t = 28.5 s, search included",
              "millions of cycles times vertices to t = 28.5 s")
    for axes, (cost, _), label in zip(panels, texts.COSTS, labels):
        scale = 1e-6 if cost == "work" else 1.0
        best = front.efficient(grid, cost)
        axes.plot(
            [scale * value(r, cost) for r in best], [texts.percent(r) for r in best],
            color=GREEN, alpha=0.2, linewidth=9, solid_capstyle="round",
            label="efficient front",
        )
        for mesh in (name for name in STYLES if texts.find(grid, name)):
            colour, marker, dashes = STYLES[mesh]
            own = sorted((r for r in grid if r["mesh"] == mesh),
                         key=lambda r: float(r["tolerance"]))
            axes.loglog(
                [scale * value(r, cost) for r in own], [texts.percent(r) for r in own],
                color=colour, marker=marker, linestyle=dashes, markersize=4.5,
                linewidth=1.3, label=mesh,
            )
        defaults = [r for r in grid if r["tolerance"] == DEFAULT_TOLERANCE]
        axes.plot(
            [scale * value(r, cost) for r in defaults],
            [texts.percent(r) for r in defaults], "o", markersize=10, linestyle="none",
            markerfacecolor="none", color=BLACK, markeredgewidth=0.7,
            label=f"default tolerance {DEFAULT_TOLERANCE}",
        )
        axes.axhline(texts.GOAL, color=GREY, linestyle=":", linewidth=1,
                     label=f"{texts.GOAL:g} %")
        axes.set_xlabel(label)
        label_ticks(axes.xaxis)
    label_ticks(panels[0].yaxis)
    panels[0].set_ylabel("error of the first four event times, rms,\n% of an interval")
    panels[1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False,
                     fontsize=8)
    return figure
