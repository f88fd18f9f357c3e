#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that a process that fails ends all of them, with one sentence and whole files.

Usage: check_failures.py PROGRAM MPIEXEC LIBRARY TESTS_FOLDER [--places N] [--seed N]

On two processes one of them runs out of memory at an allocation that is chosen at
random (LIBRARY, failing_allocations.cc, loads before the program), wherever that is.
The run must end within a minute, say so in one line, and leave tables of whole rows and
a faults.h5 whose data sets have records for all of its times. Prints what is not so and
returns 1 if there is anything.
"""

import argparse
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import h5py

from check_restart import FAST, PLANE, read_scene

LONGEST = 60
SETTINGS = FAST + PLANE + ["Time/End time=0.2", "Output/Energy balance=true",
                           "Output/Volume longest interval=0.05",
                           "Output/Stations=middle: fault 0 0"]


def run(given, folder, process, allocation):
    """Status, nothing if it had to be stopped, and what it said."""
    command = [given.mpiexec, "-np", "2",
               "-x", f"LD_PRELOAD={given.library}",
               "-x", f"FAILING_PROCESS={process}",
               "-x", f"FAILING_ALLOCATION={allocation}",
               given.program, "scene.prm", "--overwrite"]
    for setting in SETTINGS:
        command += ["--set", setting]
    process = subprocess.Popen(command, cwd=folder, text=True, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, start_new_session=True)
    try:
        _, said = process.communicate(timeout=LONGEST)
        return process.returncode, said
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        return None, process.communicate()[1]


def n_steps(output):
    path = output / "time_series.csv"
    return len(path.read_text().splitlines()) - 1 if path.exists() else 0


def faults_of_tables(output):
    """Tables whose last row is not a whole one."""
    for path in [*output.glob("*.csv"), *output.glob("stations/*.dat")]:
        text = path.read_text()
        if text and not text.endswith("\n"):
            yield f"{path.name} ends in the midst of a row"
        separator = "," if path.suffix == ".csv" else None
        rows = [line for line in text.splitlines() if not line.startswith("#")]
        if path.name != "columns.csv" and len({len(row.split(separator)) for row in rows}) > 1:
            yield f"{path.name} has rows of different lengths"


def faults_of_records(output):
    """What cannot be read of faults.h5."""
    path = output / "faults.h5"
    if not path.exists():
        return
    try:
        with h5py.File(path) as file:
            for fault, group in file.items():
                if "time" not in group:
                    continue
                n_times = len(group["time"][:])
                for name, data in group.items():
                    if data.attrs.get("units") is None or name == "time":
                        continue
                    if data.maxshape[0] is None and len(data[:]) < n_times:
                        yield f"{fault}/{name} has fewer records than times"
    except OSError as error:
        yield f"faults.h5 cannot be read: {error}"


def faults_of(status, said, output):
    if status is None:
        yield f"did not end within {LONGEST} s"
    elif status == 0:
        yield "ended as if nothing had been"
    sentences = re.findall(r"^stickslip: .*$", said, re.MULTILINE)
    if sentences != ["stickslip: There is not enough memory."]:
        yield f"said {sentences or said.strip()!r}"
    yield from faults_of_tables(output)
    yield from faults_of_records(output)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("mpiexec")
    parser.add_argument("library", type=os.path.abspath)
    parser.add_argument("tests", type=pathlib.Path)
    parser.add_argument("--places", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    choose = random.Random(given.seed)
    is_right = True
    is_in_steps = False
    with tempfile.TemporaryDirectory(prefix="stickslip-failures-") as temporary:
        folder = pathlib.Path(temporary)
        (folder / "scene.prm").write_text(read_scene(given.tests))
        for process in range(2):
            status, said = run(given, folder, process, 0)
            counted = re.search(r"allocations: (\d+)", said)
            if status != 0 or not counted:
                print(f"The run without failures: status {status}, {said}")
                return 1
            for i in range(given.places // 2):
                # By turns in the first part, most of which is the start, and in the
                # steps. Runs differ a little in how many there are: progress and
                # checkpoints go by the time.
                part = choose.random()
                part = 0.5 * part ** 2 if i % 2 == 0 else 0.5 + 0.4 * part
                at = round(int(counted[1]) * part) + 1
                shutil.rmtree(folder / "output", ignore_errors=True)
                status, said = run(given, folder, process, at)
                output = folder / "output/scene"
                reached = re.search(r"allocations: (\d+)", said)
                if status == 0 and reached and int(reached[1]) < at:
                    continue
                is_in_steps |= n_steps(output) > 0
                for fault in faults_of(status, said, output):
                    is_right = False
                    print(f"allocation {at} of {counted[1]} on process {process}: {fault}")
    if not is_in_steps:
        print("All places were before the first step.")
    return 0 if is_right and is_in_steps else 1


if __name__ == "__main__":
    sys.exit(main())
