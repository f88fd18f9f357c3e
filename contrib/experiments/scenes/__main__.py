#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run the shipped scenes and measure what they teach.

Usage: contrib/scenes [--only SECTION] [--keep FOLDER] [--program FILE] [--print]

Writes the tables between
the marks in doc/scenes.md and the figures doc/images/scene_*.png; with --print the
tables are printed only. Takes twenty minutes on one core. --keep keeps finished runs
in a folder, and takes from it those that are there.
"""

import sys

from common import figures, page, programs, store

from . import (
    crack,
    curved_strike_slip,
    junctions,
    large_slip,
    lifted_slabs,
    nine_bodies,
    opening_wave,
    rough_fault,
    slow_slip,
    thrusts,
    weakening_patch,
)

PAGE = programs.PROJECT / "doc/scenes.md"
SECTIONS = {
    "slow_slip": slow_slip.outcome,
    "weakening_patch": weakening_patch.outcome,
    "large_slip": large_slip.outcome,
    "rough_fault": rough_fault.outcome,
    "nine_body_stack": nine_bodies.outcome,
    "listric_thrust": thrusts.listric,
    "thrust_sequence": thrusts.sequence,
    "crack": crack.outcome,
    "curved_strike_slip": curved_strike_slip.outcome,
    "crossing_faults": junctions.crossing,
    "branching_fault": junctions.branching,
    "opening_wave": opening_wave.outcome,
    "lifted_patch": lifted_slabs.patch,
    "lifted_corner": lifted_slabs.corner,
}


def main():
    parser = programs.argument_parser(__doc__)
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
                path = figures.save(draw(), f"scene_{figure_name}")
                print(f"{path} is written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
