#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run the shipped scenes and measure what they teach.

Usage: scenes.py [--only SECTION] [--keep FOLDER] [--program FILE] [--print]

To be started by contrib/scenes, which builds the program. Writes the tables between
the marks in doc/scenes.md and the figures doc/images/scene_*.png; with --print the
tables are printed only.
"""

import argparse
import sys

import matplotlib

matplotlib.use("Agg")

from measure import page, programs
from published import store
from shipped import common, large_slip, nine_bodies, slow_slip, weakening_patch

PAGE = programs.PROJECT / "doc/scenes.md"
SECTIONS = {
    "slow_slip": slow_slip.outcome,
    "weakening_patch": weakening_patch.outcome,
    "large_slip": large_slip.outcome,
    "nine_body_stack": nine_bodies.outcome,
}


def main():
    parser = argparse.ArgumentParser()
    store.add_arguments(parser, SECTIONS)
    parser.add_argument("--print", action="store_true")
    arguments = parser.parse_args()

    with store.opened(arguments) as runs:
        for name, section in SECTIONS.items():
            if arguments.only not in (None, name):
                continue
            outcome = section(runs)
            if arguments.print:
                print("\n" + outcome.text, flush=True)
            else:
                page.replace_section(name, outcome.text, PAGE, "contrib/scenes")
            for figure_name, draw in outcome.figures.items():
                print(f"{common.save(draw(), figure_name)} is written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
