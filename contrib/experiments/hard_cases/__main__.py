#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run the hard cases and compare each with a reference.

Usage: contrib/hard_cases [--only TEXT]... [--list] [--dry] [--keep FOLDER]
                          [--program PROGRAM] [--ringing] [--locking]

Each case is a scene made from the spring slider; its reference is the same scene, solved
in another way. What no scene can state is taken from a test. Writes
doc/data/hard_cases.csv and the table in doc/hard_cases.md; with --dry only
prints. --only takes the cases with that text in their group or name, the rows
of all others stay. --keep keeps all files of the runs in that folder.

--ringing and --locking print what the other two tables of that page are made
from.

A case holds if the run reaches its end, if the reference does and both agree to
1e-5 (see compare.py), or to what a load that is disturbed by 1e-14 changes where the
scene amplifies that, if a run with a tenth of the tolerances of the steps agrees
to 0.05 ('in time'), and if no more than 1e-3 of the work is missing in the
balance of energy, or 1e-8 of the elastic energy, which is rounding. It is
'refused' if the program says no as it should, and 'warned' if it is wrong and the
program says that steps are too long or cells too stiff.
"""

import pathlib
import sys
import tempfile
import time

from common import csv_file, page, programs
from common.programs import PROGRAM, PROJECT

from . import compare, friction, locking, opening, ringing, space, stepping, tests
from .run import run
from .scene import text

DATA = PROJECT / "doc/data/hard_cases.csv"
PAGE = PROJECT / "doc/hard_cases.md"
COLUMNS = ["case", "holds", "steps", "iterations", "error", "in time", "note"]
LARGEST_ERROR, LARGEST_ERROR_IN_TIME, LARGEST_DEFECT = 1e-5, 0.05, 1e-3
# Digits to which an elastic energy is known where bodies are pressed far.
ROUNDING = 1e-8
TOLERANCE = "Time/Tolerance"
LARGEST_STEPS = ("Time/Largest step", "Time/Initial step")
# Defaults of the program.
STEP_TOLERANCES = {TOLERANCE: 1.3e-6, "Time/Body tolerance": 1e-3,
                   "Time/Doubling threshold": 4.5e-6}


def with_finer_steps(scene):
    """The scene with a tenth of the tolerances of its steps, and a quarter of their
    largest and first size where it has them, as small as they may be."""
    finer = scene | {"Time/Smallest step": "1e-12"} | {
        entry: f"{float(scene.get(entry, default)) / 10:g}"
        for entry, default in STEP_TOLERANCES.items()
    }
    for entry in LARGEST_STEPS:
        if entry in scene:
            finer[entry] = f"{float(scene[entry]) / 4:g}"
    return finer


def measure(program, case, folder):
    """The row of a case."""
    result = run(program, text(case.scene), folder / "run", case.timeout)
    steps = result.number("Steps/accepted")
    row = dict.fromkeys(COLUMNS, "") | {
        "case": f"{case.group}: {case.name}",
        "holds": "yes",
        "steps": f"{steps:.0f}" if steps is not None else "",
    }
    is_constant = case.scene.get("Time/Step size control") == "constant"
    is_wrong = is_warned = False
    notes = [case.note] if case.note else []
    iterations = result.number("Iterations/TNNMG, per accepted step")
    if iterations and steps:
        row["iterations"] = f"{iterations:.2f}"
    rejected = result.number("Steps/rejected")
    if rejected:
        notes.append(f"{rejected:.0f} steps rejected")
    estimate = result.number("Steps/largest estimated error") or 0
    allowed = float(case.scene.get(TOLERANCE, STEP_TOLERANCES[TOLERANCE]))
    if is_constant and estimate > allowed:
        is_warned = True
        notes.append(f"warns that the estimated error is {estimate:.0e}")
    if case.warned:
        is_wrong = True
        is_warned = case.warned in result.report
        notes.append(f"warns that cells are {case.warned}")
    if result.message:
        clear = case.refused and case.refused in result.message
        row["holds"] = "refused" if clear else "warned" if is_warned else "no"
        notes.append(f"ends with: {result.message}")
    elif case.refused:
        row["holds"] = "no"
        notes.append("should have been refused")
    else:
        low, high = compare.slip_rate_range(result)
        notes.append(f"{low:.0e} to {high:.0e} m/s at the end")
        if result.events:
            notes.append(f"{len(result.events)} events")
        if result.openings:
            notes.append(f"{result.openings} openings")
        if result.number("Energy/taken by contacts"):
            notes.append(
                f"contacts take {result.number('Energy/taken by contacts'):.0e} J/m"
            )
        defect = result.number("Energy/missing, over the largest work")
        if defect is not None:
            notes.append(f"energy defect {abs(defect):.0e}")
            elastic = result.number("Energy/elastic, at the end") or 0
            missing = abs(result.number("Energy/missing") or 0)
            is_wrong |= (abs(defect) > LARGEST_DEFECT
                         and missing > ROUNDING * elastic)

    def distance_from(scene, name, column):
        """How far the run is from that of another scene, if that reaches its end."""
        other = run(program, text(scene), folder / column, 5 * case.timeout)
        if other.message:
            notes.append(f"{name}: {other.message}")
            row["holds"] = "unknown"
            return None
        slip = min(float(value) for entry, value in case.scene.items()
                   if entry.endswith("/Characteristic slip"))
        return compare.difference(result, other, slip)

    def is_far_from(scene, name, column, largest):
        """Note how far the run is from that of another scene in a column."""
        error = distance_from(scene, name, column)
        if error is None:
            return False
        row[column] = f"{error:.0e}"
        return not error <= largest

    if case.reference is not None and not result.message:
        largest = LARGEST_ERROR
        if case.disturbed:
            change = distance_from(case.scene | case.disturbed, "disturbed",
                                   "disturbed")
            if change is not None:
                notes.append(f"{change:.0e} from a load disturbed by 1e-14")
                largest = max(largest, change)
        is_wrong |= is_far_from(case.scene | case.reference,
                                f"reference ({case.reference_name})", "error",
                                largest)
        if row["error"]:
            notes.append(f"reference: {case.reference_name}")
    # The reference of constant steps is in time already, and what has none cannot
    # be compared.
    if not result.message and not is_constant and case.reference is not None:
        is_wrong |= is_far_from(with_finer_steps(case.scene),
                                "with a tenth of the tolerances", "in time",
                                LARGEST_ERROR_IN_TIME)
    if is_wrong:
        row["holds"] = "warned" if is_warned else "no"
    row["note"] = "; ".join(notes)
    return row


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--dry", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--ringing", action="store_true")
    parser.add_argument("--locking", action="store_true")
    arguments = parser.parse_args()

    for asked, what in ((arguments.ringing, ringing), (arguments.locking, locking)):
        if asked:
            with tempfile.TemporaryDirectory(prefix="stickslip-hard-") as temporary:
                what.measure(arguments.program, pathlib.Path(temporary))
    if arguments.ringing or arguments.locking:
        return 0

    everything = [*friction.cases(), *stepping.cases(), *space.cases(),
                  *opening.cases()]
    names = [f"{case.group}: {case.name}" for case in everything]
    names += tests.ROWS
    everything += tests.ROWS.values()
    # Rows from before a column was there, and those of tests, have nothing in it.
    empty = dict.fromkeys(COLUMNS, "")
    rows = {row["case"]: empty | row
            for row in csv_file.read(DATA) if row["case"] in names}
    with tempfile.TemporaryDirectory(prefix="stickslip-hard-") as temporary:
        for number, (name, case) in enumerate(zip(names, everything)):
            if arguments.only and not any(t in name for t in arguments.only):
                continue
            if arguments.list:
                print(name)
                continue
            begin = time.monotonic()
            folder = (arguments.keep or pathlib.Path(temporary)) / str(number)
            row = rows[name] = empty | (
                case(folder)
                if name in tests.ROWS
                else measure(arguments.program, case, folder)
            )
            print(f"{time.monotonic() - begin:5.1f} s  ",
                  " | ".join(row.values()), flush=True)
            if not arguments.dry:
                csv_file.write(DATA, COLUMNS, [rows[n] for n in names if n in rows])
    if not arguments.list and not arguments.dry:
        cells = [
            [rows[n][column].replace("|", "\\|") for column in COLUMNS]
            for n in names if n in rows
        ]
        page.replace_section(
            "table", page.table(COLUMNS, cells), PAGE, "contrib/hard_cases"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
