# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Lay two runs side by side: contrib/compare A B [-o PAGE] [--fault NAME] [--event N]

Writes a page, comparison.html unless another name is given, that needs no network: the
slip rates of both runs in one panel, then of each run beside the other, with the same
limits, slip rates along the fault and one event, the work of the steps, the events in
their order with what they differ by, the summaries, and the entries of the scenes that
differ. The fault is the first one of A that B has, unless one is chosen.
"""

import argparse
import pathlib
import re
import sys

import numpy as np

from . import along_fault, over_time, page, sections, steps
from .run_error import RunError
from .run_files import Run
from .style import BLUE, VERMILION, panels, png, rate_limits, time_scale, title


def common_fault(runs, wanted):
    if wanted is not None:
        return [run.chosen_faults(wanted)[0] for run in runs][0]
    shared = [fault for fault in runs[0].faults if fault in runs[1].faults]
    if not shared:
        raise RunError("The runs have no fault of the same name.")
    return max(shared, key=lambda fault: len(runs[0].events_of(fault)["start"]))


def overlay(runs, fault, names):
    """Largest slip rate and mean slip of both runs in the same panels."""
    figure, axes = panels([2.4, 1.8])
    factor, unit = time_scale(max(run.times[1] for run in runs))
    for run, name, colour, style in zip(runs, names, (VERMILION, BLUE), ("-", "--")):
        t = factor * run.series["time"]
        options = {"color": colour, "linewidth": 0.9, "linestyle": style, "label": name}
        axes[0][0].semilogy(t, run.of(fault, "max_slip_rate"), **options)
        axes[1][0].plot(t, run.of(fault, "mean_slip"), **options)
    axes[0][0].set_ylim(rate_limits([run.of(fault, "max_slip_rate") for run in runs]))
    axes[0][0].set_ylabel("slip rate [m/s]")
    axes[1][0].set_ylabel("mean slip [m]")
    title(axes[0][0], f"Largest slip rate of {fault}")
    for (axis,) in axes:
        axis.set_xlabel(f"time [{unit}]")
        axis.grid(alpha=0.3)
        axis.legend(loc="lower right")
    return figure


def beside(runs, draw, *arguments):
    """A figure of each run beside the other's, with the same limits of panels that lie
    at the same place."""
    figures = [draw(run, *arguments) for run in runs]
    for one, other in zip(*(figure.axes for figure in figures)):
        # Panels of colours have their own.
        if one.get_label() == "<colorbar>" or one.get_ylabel() != other.get_ylabel():
            continue
        for get, put in (("get_xlim", "set_xlim"), ("get_ylim", "set_ylim")):
            limits = np.array([getattr(axis, get)() for axis in (one, other)])
            both = limits.min(), limits.max()
            if (limits[:, 0] < limits[:, 1]).all():
                for axis in (one, other):
                    getattr(axis, put)(*both)
    return page.pair(*(page.image(png(figure), run.name)
                       for figure, run in zip(figures, runs)))


def rates_along(run, fault, number, limits):
    fields, event = run.fields(fault), run.event(fault, number)
    if not fields.is_plane:
        return sections.maps_over(run, fault, event)
    figure, axes = panels([2.4] * (2 if event else 1), width=7)
    along_fault.slip_rates(axes[0][0], fields, limits=limits)
    if event:
        along_fault.slip_rates(axes[1][0], fields, event, limits)
    return figure


def work(run):
    figure, axes = panels([1.6, 1.1, 1.1, 1.3], width=7)
    steps.sizes(axes[0][0], run)
    steps.iterations(axes[1:, 0], run)
    return figure


def energy(run):
    figure, axes = panels([3.0], width=7)
    over_time.energies(axes[0][0], run)
    return figure


def event_table(runs, fault):
    """Events of the same number beside each other."""
    events = [run.events_of(fault) for run in runs]
    rows = []
    for k in range(max(len(own["start"]) for own in events)):
        values = [[own[column][k] if k < len(own["start"]) else np.nan for own in events]
                  for column in ("start", "end", "peak_slip_rate", "mean_slip")]
        rows.append([k + 1] + [value for both in values for value in both]
                    + [values[0][1] - values[0][0]])
    return page.table(["", "start, A [s]", "B", "end, A [s]", "B", "peak, A [m/s]", "B",
                       "mean slip, A [m]", "B", "start, B - A [s]"], rows)


def entries(text):
    """Values of a parameter file by their paths."""
    found, path = {}, []
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            path.append(line[len("subsection "):])
        elif line == "end":
            path.pop()
        elif line.startswith("set "):
            name, value = (part.strip() for part in line[4:].split("=", 1))
            found["/".join(path + [re.sub(" +", " ", name)])] = value
    return found


def summary(text):
    """Lines of a summary by section and name."""
    found, section = {}, ""
    for line in text.splitlines():
        if line and not line.startswith(" "):
            section = line
        elif line:
            name, value = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            found[f"{section}: {name}"] = value
    return found


def differences(one, other, all_rows):
    """A table of what both have by name; ALL_ROWS, or only those that differ."""
    rows = [[key, one.get(key, ""), other.get(key, "")]
            for key in [*one, *(key for key in other if key not in one)]
            if all_rows or one.get(key) != other.get(key)]
    if not rows:
        return "<p>No differences.</p>"
    return page.table(["", "A", "B"], rows,
                      lambda row, column: column > 0 and rows[row][1] != rows[row][2])


def compare(runs, fault, number):
    names = ["A", "B"]
    limits = None
    if runs[0].fields(fault).is_plane:
        limits = rate_limits([run.fields(fault).size("slip_rate") for run in runs])
    yield "Both runs", page.image(png(overlay(runs, fault, names)), "Both runs")
    yield f"Slip rates along {fault}", beside(runs, rates_along, fault, number, limits)
    yield "Energy", beside(runs, energy)
    yield "Time steps", beside(runs, work)
    yield f"Events of {fault}", event_table(runs, fault)
    yield "Entries that differ", differences(
        *(entries(run.text("parameters.prm")) for run in runs), all_rows=False)
    yield "Summaries", differences(
        *(summary(run.text("summary.txt")) for run in runs), all_rows=True)


def main():
    parser = argparse.ArgumentParser(
        prog="contrib/compare", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", type=pathlib.Path, nargs=2, metavar="FOLDER",
                        help="the output folders of two runs")
    parser.add_argument("-o", metavar="PAGE", type=pathlib.Path,
                        default=pathlib.Path("comparison.html"))
    parser.add_argument("--fault", metavar="NAME")
    parser.add_argument("--event", metavar="N", type=int,
                        help="counted from 1; default: the middle one of each")
    arguments = parser.parse_args()
    try:
        runs = [Run(folder) for folder in arguments.folders]
        fault = common_fault(runs, arguments.fault)
        arguments.o.write_text(page.page(
            f"{runs[0].name} and {runs[1].name}",
            f"A is {arguments.folders[0]}, B is {arguments.folders[1]}.",
            list(compare(runs, fault, arguments.event))), encoding="utf-8")
    except RunError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyError as error:
        print(f"A file of a run has no {error}.", file=sys.stderr)
        return 1
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    print(arguments.o)
    return 0


if __name__ == "__main__":
    sys.exit(main())
