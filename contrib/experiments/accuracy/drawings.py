# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Figures of doc/accuracy.md."""

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from common import figures
from common.figures import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION

from . import cases, front, mesh_and_time, mesh_and_time_drawing
from .tables import by_family, value

STYLES = {
    cases.DEFAULT: (VERMILION, "o", "-"),
    "embedded, implicit Euler, interleaved": (ORANGE, "s", "-"),
    "embedded, exponential, nested": (PURPLE, "D", "-"),
    "step doubling, exponential, interleaved": (SKY, "^", "-"),
    cases.PUBLISHED: (BLUE, "v", "-"),
    "condensed Newton": (GREEN, "P", "-"),
    "TNNMG tolerance 1e-6": (GREY, "x", "--"),
    "TNNMG tolerance 1e-9": (GREY, "+", ":"),
    "TNNMG tolerance 1e-6, one cycle a correction": (BLACK, "*", "--"),
}


def save(figure, name):
    path = figures.IMAGES / f"accuracy_{name}.svg"
    figures.IMAGES.mkdir(exist_ok=True)
    # The same results give the same file.
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
    return path


def milliseconds(record):
    return 1e3 * value(record, front.ERROR)


def line(axes, points, label, style, size=5):
    """Markers larger than the usual ones are open, to be seen around others."""
    colour, marker, dashes = style
    if points:
        axes.loglog(
            *zip(*points), color=colour, marker=marker, markersize=size,
            markerfacecolor=colour if size <= 5 else "none", linestyle=dashes,
            linewidth=1.3, label=label,
        )


def draw_front(records):
    """Error in event times against the cost, by two measures of it."""
    figure, panels = figures.new_panels(2, 10.0, 4.2)
    own = front.points(records)
    default = front.default(records)
    for axes, cost, label in zip(
        panels,
        ("cycles", "cpu_seconds"),
        ("multigrid cycles to t = 28.5 s", "CPU seconds to t = 28.5 s"),
    ):
        best = front.efficient(own, cost)
        axes.plot(
            [value(r, cost) for r in best], [milliseconds(r) for r in best],
            color=BLACK, alpha=0.15, linewidth=9, solid_capstyle="round",
            label="efficient front",
        )
        families = by_family(own)
        for family in (name for name in STYLES if name in families):
            points = [
                (value(r, cost), milliseconds(r))
                for r in families[family]
                if value(r, cost) > 0
            ]
            line(axes, points, family, STYLES[family])
        if default:
            axes.plot(
                value(default, cost), milliseconds(default), "o", markersize=13,
                markerfacecolor="none", color=BLACK, label="default settings",
            )
        axes.set_xlabel(label)
        label_ticks(axes.xaxis, (1.0, 3.0))
    label_ticks(panels[0].yaxis)
    panels[0].set_ylabel("error of the first four event times, rms, ms")
    handles = dict(zip(*reversed(panels[1].get_legend_handles_labels())))
    handles |= dict(zip(*reversed(panels[0].get_legend_handles_labels())))
    panels[1].legend(
        handles.values(), handles, loc="center left", bbox_to_anchor=(1.0, 0.5),
        frameon=False, fontsize=8,
    )
    return figure


def label_ticks(axis, numbers=(1.0, 2.0, 5.0)):
    """Few decades, in plain numbers."""
    axis.set_major_locator(LogLocator(subs=numbers))
    axis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:,.6g}"))
    axis.set_minor_formatter(NullFormatter())


def slope(axes, x, y, order, text):
    """A line of an order to compare with, named at its end."""
    axes.loglog(
        x, [y, y * (x[1] / x[0]) ** order], color=GREY, linestyle=":", linewidth=1
    )
    axes.annotate(
        text, (x[1], y * (x[1] / x[0]) ** order), fontsize=8, color=GREY,
        xytext=(4, -2), textcoords="offset points", ha="left",
    )


def by_tolerance(records):
    return sorted(
        (float(r["tolerance"]), milliseconds(r))
        for r in records
        if milliseconds(r) > 0
    )


def draw_convergence(records):
    """Error against the tolerance, beside both references, and the mesh width."""
    figure, panels = figures.new_panels(3, 10.0, 3.8)
    of_section = {
        name: by_family([r for r in records if r["section"] == name])
        for name in ("time", "independent", "space")
    }
    for family, own in of_section["time"].items():
        if family in STYLES and family.startswith("embedded"):
            label, size = family.split(" (")[0], 9 if "nested" in family else 5
            line(panels[0], by_tolerance(own), label, STYLES[family], size)
    slope(panels[0], (1e-6, 1e-4), 0.06, 2 / 3, "2/3")
    slope(panels[1], (1e-6, 1e-4), 0.02, 2 / 3, "2/3")
    panels[0].set_title("published mesh, own reference", fontsize=9)
    styles = ((VERMILION, "o", "-"), (BLUE, "v", "-"))
    for (family, own), style in zip(of_section["independent"].items(), styles):
        line(panels[1], by_tolerance(own), family, style)
    panels[1].set_title("coarse mesh, independent reference", fontsize=9)
    styles = ((VERMILION, "o", "-"), (BLUE, "s", "-"), (GREEN, "^", "-"))
    for family, style in zip(("all cells", "bulk", "fault"), styles):
        own = of_section["space"].get(family, [])
        points = [
            (2.0 ** doublings(own, r), milliseconds(r))
            for r in own
            if milliseconds(r) > 0
        ]
        size = 9 if family == "all cells" else 5
        line(panels[2], points, f"{family} smaller", style, size)
    panels[2].set_title("meshes, finest as reference", fontsize=9)
    slope(panels[2], (0.25, 1.0), 2.5, 1.5, "3/2")
    for axes, label in zip(
        panels, ("tolerance", "tolerance or threshold", "cells, of the published size")
    ):
        axes.set_xlabel(label)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(frameon=False, fontsize=7, loc="upper left")
    ticks = [2.0**k for k in range(-3, 3)]
    panels[2].set_xticks(ticks, ["1/8", "1/4", "1/2", "1", "2", "4"])
    panels[2].minorticks_off()
    panels[0].set_ylabel("error of the first four event times, rms, ms")
    return figure


def doublings(family, record):
    """How often the cells are doubled against the published mesh, which is the one
    that sets nothing of the bodies."""
    published = next(
        i for i, r in enumerate(family) if "Bodies/" not in r["settings"])
    return published - family.index(record)


def draw_mesh_and_time(records):
    own = [r for r in records if r["section"] == mesh_and_time.SECTION]
    return mesh_and_time_drawing.draw(own, label_ticks)


FIGURES = {
    "front": draw_front,
    "convergence": draw_convergence,
    "mesh_and_time": draw_mesh_and_time,
}


def draw(records):
    """All figures; their paths."""
    return [save(make(records), name) for name, make in FIGURES.items()]
