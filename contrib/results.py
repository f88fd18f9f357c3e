#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run the published experiments and put what comes out beside what was published.

Usage: results.py [--quick] [--only SECTION] [--keep FOLDER] [--program FILE]

To be started by contrib/results, which builds the program. Writes the tables between
the marks in doc/results.md, the figures doc/images/results_*.png and the data
doc/data/results_*.csv; with --quick the first moments of each run are computed, tables
are printed, figures are drawn, and nothing is written. The results of sections that
are not done stay.
"""

import argparse
import sys
import time

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from measure import programs
from published import sections
from published.store import Store


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", choices=list(sections.SECTIONS), metavar="SECTION")
    parser.add_argument("--keep", metavar="FOLDER")
    parser.add_argument("--program", default=programs.PROJECT / "build/stickslip")
    arguments = parser.parse_args()

    begin = time.monotonic()

    def log(message):
        print(f"{time.monotonic() - begin:.0f} s: {message}", flush=True)

    with programs.temporary_folder() as folder:
        store = Store(arguments.keep or folder, arguments.program, log)
        for name, section in sections.SECTIONS.items():
            if arguments.only not in (None, name):
                continue
            outcome = section(store, arguments.quick)
            if arguments.quick:
                print("\n" + outcome.text, flush=True)
                for draw in outcome.figures.values():
                    plt.close(draw())
                continue
            for path in sections.publish(name, outcome):
                print(f"{path} is written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
