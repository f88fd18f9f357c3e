# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Figures of the measurements in doc/performance.md."""

import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator

from common.figures import (
    BLACK, BLUE, GREEN, IMAGES, ORANGE, PURPLE, SKY, VERMILION, YELLOW,
    new_panels,
)

STATE_STYLES = {
    "stuck": (BLUE, "o"),
    "nucleating": (VERMILION, "s"),
    "slipping": (GREEN, "^"),
    "half": (ORANGE, "D"),
    "random": (PURPLE, "v"),
}
# Title, colour, marker, dashes; linear problems dashed.
SOLVER_STYLES = {
    "TNNMG": ("TNNMG, rate problem", VERMILION, "o", "-"),
    "exact, UMFPACK": ("exact correction, UMFPACK", BLUE, "s", "-"),
    "exact, MUMPS": ("exact correction, MUMPS", SKY, "D", "-"),
    "CG with ML": ("correction by CG with ML", GREEN, "^", "-"),
    "Newton, UMFPACK": ("Newton without smoother, UMFPACK", PURPLE, "v", "-"),
    "condensed": ("condensed Newton", YELLOW, "P", "-"),
    "geometric": ("deal.II's multigrid, linear", BLACK, "o", "--"),
    "coupled": ("our cycle, linear", VERMILION, "o", "--"),
    "algebraic": ("ML, linear", GREEN, "^", "--"),
    "umfpack": ("UMFPACK with factorisation, linear", BLUE, "s", "--"),
    "mumps": ("MUMPS with factorisation, linear", SKY, "D", "--"),
}


def save(figure, name):
    path = IMAGES / f"performance_{name}.svg"
    IMAGES.mkdir(exist_ok=True)
    # The same results give the same file.
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
    return path


def shortest_times(records, solver, tau):
    """Microseconds for an unknown, by the number of unknowns: two dimensions,
    cells of one size, and of the rate problems the nucleating one."""
    points = {}
    for record in records:
        if (
            record["solver"] == solver
            and record["section"] in ("linear", "newton", "levels")
            and record["problem"].startswith("uniform-")
            and record["state"] in ("welded", "nucleating")
            and float(record["tau"]) == tau
            and record["solve_s"]
            and not record["note"]
            and float(record["error"] or 0) < 1e-6
        ):
            n = float(record["unknowns"])
            time = float(record["solve_s"]) / n * 1e6
            points[n] = min(time, points.get(n, time))
    return sorted(points.items())


def draw_times(records):
    """For a small and a large step size, side by side."""
    figure, panels = new_panels(2, 8.6, 3.8)
    handles = {}
    for axes, tau in zip(panels, (1e-3, 1e-1)):
        for solver, (title, colour, marker, dashes) in SOLVER_STYLES.items():
            points = shortest_times(records, solver, tau)
            if points:
                (handles[title],) = axes.loglog(
                    *zip(*points),
                    linestyle=dashes,
                    color=colour,
                    marker=marker,
                    markersize=5,
                    markerfacecolor=colour if dashes == "-" else "white",
                    linewidth=1.4,
                )
        axes.set_xlabel("unknowns")
        axes.set_title(f"tau = {tau:g} s", fontsize=9)
    panels[0].set_ylabel("µs an unknown for a solution")
    titles = [style[0] for style in SOLVER_STYLES.values() if style[0] in handles]
    panels[-1].legend(
        [handles[title] for title in titles],
        titles,
        loc="center left",
        bbox_to_anchor=(1.0, 0.5),
        frameon=False,
        fontsize=8,
    )
    return save(figure, "time")


def draw_iterations(records, section, abscissa, label):
    """For a small and a large step size, side by side."""
    own = [r for r in records if r["section"] == section and r["iterations"]]
    taus = sorted({float(r["tau"]) for r in own})
    figure, panels = new_panels(len(taus), 3.2 * len(taus) + 1.0, 3.0)
    ticks = sorted({abscissa(r) for r in own})
    for axes, tau in zip(panels, taus):
        for k, (state, (colour, marker)) in enumerate(STATE_STYLES.items()):
            # A little aside, so that equal numbers do not hide each other.
            points = sorted(
                (abscissa(r) * 1.05 ** (k - 2), int(r["iterations"]))
                for r in own
                if r["state"] == state and float(r["tau"]) == tau
            )
            if not points:
                continue
            axes.semilogx(
                *zip(*points),
                color=colour,
                marker=marker,
                markersize=5,
                linewidth=1.4,
                label=state,
            )
        axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.minorticks_off()
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
        axes.set_xlabel(label)
        axes.set_title(f"tau = {tau:g} s", fontsize=9)
    # Once all is drawn, since this ends the search for the other limit.
    panels[0].set_ylim(bottom=0)
    panels[0].set_ylabel("TNNMG iterations")
    panels[-1].legend(
        loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False
    )
    return save(figure, f"iterations_{section}")


def refinements(record):
    """Cells over the height of a body."""
    return 3 * 2 ** int(record["problem"].rsplit("-", 1)[1])


def draw(records):
    """Draw what there are results for; returns the files."""
    present = {record["section"] for record in records}
    if present & {"linear", "newton"}:
        yield draw_times(records)
    if "levels" in present:
        yield draw_iterations(
            records, "levels", refinements, "cells over the height of a body"
        )
    if "bodies" in present:
        yield draw_iterations(
            records, "bodies", lambda r: int(r["bodies"]), "bodies"
        )
