# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""What the tables of a run say over time."""

import numpy as np

from .style import BLACK, BLUE, COLOURS, GREY, VERMILION
from .style import rate_limits, say, scaled, time_scale, title


def time_axis(axis, run):
    """Label and limits of an axis of the whole run; what times are multiplied by."""
    begin, end = run.times
    factor, unit = time_scale(end)
    if end > begin:
        axis.set_xlim(factor * begin, factor * end)
    axis.set_xlabel(f"time [{unit}]")
    axis.grid(alpha=0.3)
    return factor


def slip_rates(axis, run, faults):
    """The largest and the mean slip rate of the faults, with their events."""
    factor = time_axis(axis, run)
    t = factor * run.series["time"]
    is_one = len(faults) == 1
    for number, fault in enumerate(faults):
        colour = COLOURS[number % len(COLOURS)]
        own = run.events_of(fault)
        name = "" if is_one else f"{fault}: "
        axis.semilogy(t, run.of(fault, "max_slip_rate"), color=colour, linewidth=0.9,
                      label=f"{name}largest")
        axis.semilogy(t, run.of(fault, "mean_slip_rate"), linewidth=0.9,
                      color=BLUE if is_one else colour, linestyle="-" if is_one else ":",
                      label="mean" if is_one else None)
        axis.plot(factor * own["peak_time"], own["peak_mean_slip_rate"], "o",
                  color=BLACK if is_one else colour, markersize=3, linestyle="none",
                  label=f"{name}{len(own['start'])} events")
    axis.set_ylim(rate_limits([run.of(fault, f"{which}_slip_rate") for fault in faults
                               for which in ("max", "mean")]))
    axis.set_ylabel("slip rate [m/s]")
    title(axis, "Slip rate of " + ", ".join(faults)
          + ("" if is_one else " (dotted: mean)"))
    if is_one:
        # Events take the room up and down.
        axis.legend(loc="lower right", bbox_to_anchor=(1, 0.98), ncol=3)
    else:
        axis.legend(loc="lower right", ncol=3)


def means(axis, run, faults, column, name, unit):
    """The mean of a field over each fault."""
    factor = time_axis(axis, run)
    values = [run.of(fault, column) for fault in faults]
    by, unit = scaled(np.nanmax(np.abs(values)), unit)
    for number, (fault, of_fault) in enumerate(zip(faults, values)):
        axis.plot(factor * run.series["time"], by * of_fault, linewidth=0.9,
                  color=COLOURS[number % len(COLOURS)], label=fault)
    axis.set_ylabel(f"{name} [{unit}]")
    title(axis, f"Mean {name} of " + ", ".join(faults))
    if len(faults) > 1:
        axis.legend(loc="best", ncol=4)


def openings(axis, run, faults):
    """Largest gap and open area of the faults that may open, and their openings."""
    factor = time_axis(axis, run)
    t, dimension = factor * run.series["time"], 2 if run.fields(faults[0]).is_plane else 3
    by, unit = scaled(max(np.nanmax(run.of(f, "largest_gap")) for f in faults), "m")
    of_all = run.table("openings.csv")
    area = axis.twinx()
    for number, fault in enumerate(faults):
        colour = COLOURS[number % len(COLOURS)]
        own = of_all["fault"] == fault
        axis.plot(t, by * run.of(fault, "largest_gap"), color=colour, linewidth=0.9,
                  label=f"{fault}: {own.sum()} openings")
        area.plot(t, run.of(fault, "open_area"), color=colour, linewidth=0.9,
                  linestyle=":")
        for opens, closes in zip(of_all["opens"][own], of_all["closes"][own]):
            axis.axvspan(factor * opens,
                         factor * closes if np.isfinite(closes) else t[-1],
                         color=colour, alpha=0.08, linewidth=0)
    axis.set_ylim(bottom=0)
    area.set_ylim(bottom=0)
    axis.set_ylabel(f"largest gap [{unit}]")
    what = "open length" if dimension == 2 else "open area"
    area.set_ylabel(what + (" [m]" if dimension == 2 else " [m²]"))
    area.spines["right"].set_visible(True)
    title(axis, "Gap of " + ", ".join(faults) + f" (dotted: {what})")
    axis.legend(loc="lower right", bbox_to_anchor=(1, 0.97), ncol=4)


ENERGIES = (
    ("driven_sides", "work of driven sides", BLACK, "-"),
    ("loads", "work of loads", GREY, "-"),
    ("elastic", "elastic energy, change", BLUE, "-"),
    ("kinetic", "kinetic energy", COLOURS[3], "-"),
    ("friction", "dissipated by friction", VERMILION, "-"),
    ("viscosity", "by viscosity", COLOURS[2], "-"),
    ("radiation", "by radiation", COLOURS[5], "-"),
    ("contact", "taken by contacts", COLOURS[4], "-"),
    ("mappings", "added by contact mappings", GREY, "--"),
    ("missing", "missing", BLACK, ":"),
)


def energies(axis, run):
    """Energies and work since the first step."""
    factor = time_axis(axis, run)
    title(axis, "Energy since the first step")
    table = run.table("energy.csv")
    if table is None or len(table["time"]) == 0:
        say(axis, "no energy.csv")
        return
    # Earlier versions have no energy of contact mappings.
    terms = [term for term in ENERGIES if term[0] in table]
    changes = {name: table[name] - table[name][0] for name, _, _, _ in terms}
    largest = max(np.abs(values).max() for values in changes.values())
    unit = "J/m" if run.fields(run.faults[0]).is_plane else "J"
    by, unit = scaled(largest, unit)
    for name, label, colour, style in terms:
        # What would lie on the axis all the time is left out.
        if np.abs(changes[name]).max() > 2e-3 * largest or name == "missing":
            axis.plot(factor * table["time"], by * changes[name], color=colour,
                      linestyle=style, linewidth=0.9, label=label)
    axis.set_ylabel(f"energy [{unit}]")
    axis.legend(loc="best", ncol=2)
