#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Measure the solver and what it is compared with, section by section.

Usage: contrib/benchmark [--quick] [--only SECTION]

Writes the
tables between the marks in doc/performance.md, the figures in doc/images and
doc/data/performance.csv; with --quick the tables are shown, and nothing is
written. The results of sections that are not measured
stay. Takes half an hour on two cores and 10 GiB of memory, with --quick three
minutes. The machine should have nothing else to do.
"""

import sys
import time

from common import page, programs

from . import (
    comparison, crossings, figures, iterations, kernels, measuring, newton, runs,
    tetrahedra,
)

PAGE = programs.PROJECT / "doc/performance.md"

# What takes longest and needs the quiet machine least comes last.
SECTIONS = {
    section.SECTION: section
    for section in (
        comparison,
        iterations.Levels,
        iterations.Curved,
        iterations.Bodies,
        crossings,
        tetrahedra,
        kernels.Costs,
        kernels.Kernels,
        newton,
        runs,
    )
}


def measure_triad():
    rows = measuring.run("kernel_speed", ["--triad"], 60)
    return float(rows[0]["GB_per_s"])


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", choices=SECTIONS, metavar="SECTION")
    arguments = parser.parse_args()

    begin = time.monotonic()
    where = (
        f"Measured on: {programs.machine()}; triad of STREAM on one core "
        f"{measure_triad():.1f} GB/s.\n\n"
    )
    print(where, end="", flush=True)
    used = {}
    for name, section in SECTIONS.items():
        if arguments.only not in (None, name):
            continue
        start = time.monotonic()

        def log(message):
            print(f"{name}, {time.monotonic() - start:.0f} s: {message}", flush=True)

        try:
            records, results = section.measure(arguments.quick, log)
        except programs.Failed as reason:
            log(f"nothing measured: {reason}")
            continue
        used[name] = time.monotonic() - start
        text = section.text(records, results)
        if arguments.quick:
            print("\n" + text, flush=True)
            continue
        # At once, so that a failure later on costs nothing.
        page.replace_section(name, where + text, PAGE, "contrib/benchmark")
        others = [r for r in measuring.read() if r["section"] != name]
        measuring.write(others + records)

    for name, seconds in used.items():
        print(f"{name}: {seconds:.0f} s")
    print(f"all: {time.monotonic() - begin:.0f} s")
    if not arguments.quick:
        for path in figures.draw(measuring.read()):
            print(f"{path} is written.")
        print(f"{PAGE} and {measuring.DATA} are written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
