#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Measure how large the errors are, what halving them costs, and which hard cases hold.

Usage: contrib/accuracy [--quick] [--only SECTION] [--keep FOLDER]

Writes
doc/data/speed_against_error.csv row by row, then the tables between the marks in
doc/accuracy.md and the figures in doc/images; with --quick a few short runs are
shown, and nothing is written. The results of sections that are not measured stay.
The sections verification, hard, moving and shipped have no rows in this table: the first
takes its figures from the tests that compare with solutions from elsewhere, the second
writes doc/hard_cases.md, the others tables of doc/meshes.md. Takes three hours on one core,
with --quick a minute.
--keep keeps finished runs in a folder, and takes from it those that are there.
"""

import sys
import time

from common import programs

from . import others, sections
from .records import make_record, put, read, write
from .slider import SliderStore


def measure(section, store, quick, records):
    """Run the cases of a section; the table on disk grows with each."""
    own = []
    for case in section.cases(quick):
        if section.reference:
            reference = section.reference(case, store)
        else:
            reference = store.result(case.reference) if case.reference else None
        record = make_record(case, store.result(case), reference)
        put(records, record)
        own.append(record)
        if not quick:
            write(records)
    return own


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", choices=[*sections.SECTIONS, *others.SECTIONS],
                        metavar="SECTION")
    parser.add_argument("--keep", metavar="FOLDER")
    arguments = parser.parse_args()

    begin = time.monotonic()

    def log(message):
        print(f"{time.monotonic() - begin:.0f} s: {message}", flush=True)

    records = [] if arguments.quick else read()
    with programs.temporary_folder() as temporary:
        folder = arguments.keep or temporary
        store = SliderStore(folder, log=log)
        for name, section in sections.SECTIONS.items():
            if arguments.only not in (None, name):
                continue
            own = measure(section, store, arguments.quick, records)
            if not arguments.quick:
                # What the section no longer runs goes once all else is there.
                records = [r for r in records if r["section"] != name] + own
                write(records)
            elif own:
                print("\n" + section.text(own), flush=True)
        for name, section in others.SECTIONS.items():
            if arguments.only == name or not (arguments.only or arguments.quick):
                log(name)
                section(arguments.quick, folder)
    if not arguments.quick:
        for path in sections.publish(read()):
            print(f"{path} is written.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
