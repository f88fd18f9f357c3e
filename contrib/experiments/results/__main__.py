#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run the published experiments and put what comes out beside what was published.

Usage: contrib/results [--quick] [--only SECTION] [--keep FOLDER] [--program FILE]

Writes the tables between
the marks in doc/results.md, the figures doc/images/results_*.png and the data
doc/data/results_*.csv; with --quick the first moments of each run are computed, tables
are printed, figures are drawn, and nothing is written. The results of sections that
are not done stay. Takes 75 minutes on one core, with --quick half a minute. --keep
keeps finished runs in a folder, and takes from it those that are there.
"""

import sys

import matplotlib.pyplot as plt

from common import programs, store

from . import sections


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--quick", action="store_true")
    store.add_arguments(parser, sections.SECTIONS)
    arguments = parser.parse_args()

    with store.opened(arguments) as runs:
        for name, section in sections.SECTIONS.items():
            if arguments.only not in (None, name):
                continue
            outcome = section(runs, arguments.quick)
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
