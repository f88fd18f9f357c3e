#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run a benchmark of the SEAS project and put it beside published numbers.

Usage: contrib/seas NAME [--cell M]... [--years Y] [--drawn-only] [--image]
                    [--set ENTRY=VALUE]... [--program FILE]

NAME is that of a scene of parameters/seas, as bp1. Cells on the fault have M metres,
those of the scene over or times a power of two (of BP3 they reach as far from the fault
when they are smaller); Y are years of 365 days. The run goes
to output/seas/NAME_M/, its figure to figure.png there, profiles of slip and stresses
in the form of the benchmarks to slip.dat, shear_stress.dat and normal_stress.dat, and
a table of the events to the screen: an event begins when the largest slip rate passes
1e-3 m/s; of bp5 also their moments, and when the first rupture arrives where. With
several --cell the errors against the cost come last. With --drawn-only earlier runs are
taken, with --image the figure goes to doc/images as well; --set is passed on.
"""

import pathlib

from common import figures, programs
from experiments.seas import profiles, rupture, sequences, stations
from experiments.seas.benchmarks import BENCHMARKS, settings

# Processor time of a run, s, kept for tables that are made later.
COST = "processor_time.txt"


def run(given, cell, folder):
    command = [given.program, programs.PROJECT / f"parameters/seas/{given.name}.prm",
               "--overwrite"]
    for entry in given.set:
        command += ["--set", entry]
    used, note = programs.run_measured(
        command + programs.options(settings(given.name, cell, given.years, folder)), 86400)
    print(f"Cells of {cell:g} m: {used:.0f} s of processor time; {note or 'to the end'}")
    (folder / COST).write_text(f"{used:.1f}\n")


def look_at(given, folder):
    """Tables and figure of a run, whose sequence is returned."""
    benchmark = BENCHMARKS[given.name]
    sequence = sequences.read(folder)
    sequences.show(given.name, sequence)
    if given.name == "bp5":
        history = rupture.read(folder)
        rupture.show(history)
        rupture.show_arrivals(history)
        figure = rupture.draw(folder, sequence, history)
    else:
        stations.show(given.name, folder, sequence.starts,
                      sequences.reference(benchmark)[1])
        history = profiles.read_fault(folder, benchmark.slope)
        profiles.write(folder, history)
        figure = profiles.draw(given.name, folder, sequence, history)
    path = folder / "figure.png"
    figure.savefig(path, dpi=110)
    if given.image:
        path = figures.save(figure, f"seas_{given.name}")
    print(f"The figure is {path}.")
    return sequence


def from_summary(folder, section, entry):
    """A number of a run's summary."""
    inside = False
    for line in (folder / "summary.txt").read_text().splitlines():
        if line and not line.startswith(" "):
            inside = line == section
        elif inside and line.split()[:-1] == entry.split():
            return int(line.split()[-1])
    raise KeyError(entry)


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("name", choices=sorted(BENCHMARKS))
    parser.add_argument("--cell", type=float, action="append")
    parser.add_argument("--years", type=float)
    parser.add_argument("--drawn-only", action="store_true")
    parser.add_argument("--image", action="store_true")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--program", default=programs.PROGRAM)
    given = parser.parse_args()
    runs = []
    for cell in sorted(given.cell or [BENCHMARKS[given.name].cell], reverse=True):
        folder: pathlib.Path = programs.PROJECT / f"output/seas/{given.name}_{cell:g}"
        if not given.drawn_only:
            run(given, cell, folder)
        sequence = look_at(given, folder)
        cost = folder / COST
        runs.append((cell, from_summary(folder, "Mesh of all bodies", "vertices"),
                     from_summary(folder, "Steps", "accepted"),
                     float(cost.read_text()) if cost.exists() else float("nan"), sequence))
    if len(runs) > 1:
        sequences.show_convergence(given.name, runs)


if __name__ == "__main__":
    main()
