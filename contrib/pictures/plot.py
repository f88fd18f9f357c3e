# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Draw a run: contrib/plot FOLDER [--fault NAME[,NAME...]] [--event N] [-o FIGURE]

Writes two files into the output folder: run.html, a page with all figures, the events,
the summary and the scene, which needs no network; and run.png, one figure of what
matters most. Drawn are

- the bodies and the faults at the start;
- slip rates, slip, shear traction and gap of the faults over time, with their events;
- in two dimensions slip rates, shear traction and gap over position and time, the slip
  at equal times (a large spacing between events, a small one within them), and one
  event: its slip rates with the front of the rupture, and slip and traction before and
  after it;
- in three dimensions maps over the fault, unfolded into a plane along strike and down
  dip: slip, largest slip rate, change of the shear traction, gap, and lines of the
  front at equal times in the event;
- energies, step sizes, and the iterations that steps took.

The fault is the one with most events, the event the one in the middle of those of the
first fault. Files of a run that has not ended are drawn as far as they go.
"""

import argparse
import pathlib
import sys

from . import page, sections
from .run_error import RunError
from .run_files import Run
from .style import png

# A page may hold many events, but nobody reads them all.
MOST_EVENTS = 2000


def event_table(run):
    columns = list(run.events)
    units = {}
    described = run.table_of_columns()
    for row in described:
        if row["file"] == "events.csv" and row["unit"]:
            units[row["column"]] = f" [{row['unit']}]"
    rows = [[k + 1] + [run.events[column][k] for column in columns]
            for k in range(min(len(run.events["fault"]), MOST_EVENTS))]
    return page.table(
        [""] + [column.replace("_", " ") + units.get(column, "") for column in columns],
        rows)


def parts_of_page(run, faults, number):
    for title, figure in sections.of_run(run, faults, number):
        yield title, page.image(png(figure), title)
    yield f"{len(run.events['fault'])} events", event_table(run)
    if run.text("summary.txt"):
        yield "Summary", page.text(run.text("summary.txt"))
    if run.text("parameters.prm"):
        yield "Scene", page.folded(page.text(run.text("parameters.prm")),
                                   "parameters.prm, all entries")


def introduction(run, faults):
    begin, end = run.times
    if faults == run.faults:
        return (f"Simulated time {end:.6g} s, {len(run.series['time'])} time steps. "
                "Numbers are in SI units unless they have another one.")
    return (f"Simulated time {end:.6g} s, {len(run.series['time'])} time steps. "
            f"Of the faults {', '.join(run.faults)} are drawn: {', '.join(faults)}. "
            "Numbers are in SI units unless they have another one.")


def draw(folder, figure, wanted_faults=None, number=None):
    """Write both files; the page stands next to the figure. Returns their paths."""
    run = Run(folder)
    faults = run.chosen_faults(wanted_faults)
    figure.write_bytes(png(sections.overview(run, faults, number), dpi=150))
    path = figure.with_suffix(".html")
    path.write_text(page.page(run.name, introduction(run, faults),
                              list(parts_of_page(run, faults, number))),
                    encoding="utf-8")
    return figure, path


def main():
    parser = argparse.ArgumentParser(
        prog="contrib/plot", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER",
                        help="the output folder of a run")
    parser.add_argument("-o", metavar="FIGURE", type=pathlib.Path,
                        help="default: run.png in the folder; the page is next to it")
    parser.add_argument("--fault", metavar="NAME[,NAME...]",
                        help="or 'all'; default: the fault with most events")
    parser.add_argument("--event", metavar="N", type=int,
                        help="counted from 1; default: the middle one")
    arguments = parser.parse_args()
    figure = arguments.o or arguments.folder / "run.png"
    try:
        for path in draw(arguments.folder, figure, arguments.fault, arguments.event):
            print(path)
    except RunError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyError as error:
        print(f"A file of the run has no {error}.", file=sys.stderr)
        return 1
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
