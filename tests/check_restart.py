#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that runs which are killed go on as if they had not been.

Usage: check_restart.py PROGRAM MPIEXEC TESTS_FOLDER [--long] [--seed N] [NAME...]

Each case runs once without checkpoints, and once with many and killed by
SIGKILL at random moments, after each of which it goes on with --restart. Files
must be the same byte by byte, faults.h5 value by value. Prints one line for each
difference and returns 1 if there are any.
"""

import argparse
import fcntl
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

# Checkpoints after almost every step, so that most kills meet one.
OFTEN = ["Output/Checkpoint wall time=0.005"]
NONE = ["Output/Checkpoints kept=0"]

FAST = [
    "Boundary conditions/upper top/x value=0.25",
    "Boundary conditions/upper top/Ramp length=0.2",
    "Faults/fault/Reference slip rate=0.25",
    "Faults/fault/Characteristic slip=0.25",
    "Faults/fault/Normal stress function=1e3",
    "Time/End time=1.2",
    "Time/Largest step=0.02",
    "Time/Tolerance=1e-4",
    "Output/Event start slip rate=0.1",
    "Output/Volume longest interval=0.2",
]
FOLLOWING = [
    "Gravity/Acceleration=1",
    "Faults/fault/Normal stress=lithostatic",
    "Faults/fault/Normal stress follows=true",
]
PLANE = [
    "Bodies/lower/Lower lateral corner=-1",
    "Bodies/lower/Upper lateral corner=1",
    "Bodies/lower/Coarse cells=4, 1",
    "Bodies/upper/Lower lateral corner=-1",
    "Bodies/upper/Upper lateral corner=1",
    "Bodies/upper/Coarse cells=4, 1",
]
BENT = ["Faults/fault/Elevation=0.005*sin(3*x)"]
SPACE = [
    "Dimension=3",
    "Bodies/lower/Lower lateral corner=-1, -0.25",
    "Bodies/lower/Upper lateral corner=1, 0.25",
    "Bodies/lower/Coarse cells=4, 1, 1",
    "Bodies/lower/Refinement passes=1",
    "Bodies/upper/Lower lateral corner=-1, -0.25",
    "Bodies/upper/Upper lateral corner=1, 0.25",
    "Bodies/upper/Coarse cells=4, 1, 1",
    "Bodies/upper/Refinement passes=1",
    "Boundary conditions/upper top/y condition=velocity",
    "Boundary conditions/upper top/y value=0.1*t",
    "Boundary conditions/lower bottom/z condition=fixed",
]
EXPLICIT = [
    "Time/Step size control=Runge-Kutta",
    "Time/Inertia=quasi-dynamic",
    "Bodies/lower/Material/Shear viscosity=0",
    "Bodies/lower/Material/Bulk viscosity=0",
    "Bodies/upper/Material/Shear viscosity=0",
    "Bodies/upper/Material/Bulk viscosity=0",
]
# The sides part and meet again, and every file is written.
OPENING = [
    "Faults/fault/Contact=unilateral",
    "Boundary conditions/upper top/y condition=velocity",
    "Boundary conditions/upper top/y value=0.05*sin(8*t)",
    "Output/Energy balance=true",
    "Output/Stations=middle: fault 0 0, above: upper 0 0.25",
]

# Settings, number of processes, and whether the case takes long.
CASES = {
    "sliding": (FAST + PLANE, 1, False),
    "following": (FAST + PLANE + FOLLOWING, 1, False),
    "bent": (FAST + PLANE + BENT, 2, False),
    "doubling": (
        FAST + PLANE + ["Time/Step size control=step doubling", "Time/Doubling threshold=1e-3"],
        1,
        False,
    ),
    "condensed": (FAST + PLANE + ["Time/Rate solver=condensed Newton"], 1, False),
    "space": (FAST + SPACE, 1, False),
    "quasi-static": (FAST + PLANE + ["Time/Inertia=quasi-static"], 1, True),
    "quasi-dynamic": (FAST + PLANE + ["Time/Inertia=quasi-dynamic"], 3, True),
    "nested": (FAST + PLANE + ["Time/Rate-state method=nested"], 1, True),
    "constant": (FAST + PLANE + ["Time/Step size control=constant"], 1, True),
    "bent and following": (FAST + PLANE + BENT + FOLLOWING, 4, True),
    "amg": (FAST + PLANE + ["TNNMG/Coarse solver=AMG"], 1, True),
    "umfpack": (FAST + PLANE + ["TNNMG/Linear correction=UMFPACK"], 1, True),
    "space and following": (FAST + SPACE + FOLLOWING, 2, True),
    "oscillating": (
        FAST + PLANE + ["Boundary conditions/upper top/x value=0.25+0.1*sin(5*t)"],
        2,
        True,
    ),
    "explicit": (FAST + PLANE + EXPLICIT, 1, True),
    "central differences": (
        FAST + PLANE + ["Time/Step size control=central differences"],
        1,
        True,
    ),
    "opening": (FAST + PLANE + OPENING, 1, True),
}


def read_scene(tests):
    """The creeping scene, but for entries with as many numbers as the space has
    dimensions, which are in the settings."""
    text = (tests / "creeping_scene.h").read_text()
    scene = re.search(r'R"\((.*?)\)"', text, re.DOTALL).group(1)
    return re.sub(r"^.*(corner|Coarse cells).*\n", "", scene, flags=re.MULTILINE)


class Runs:
    """Runs of the program in one folder."""

    def __init__(self, arguments, folder, n_processes):
        self.arguments = arguments
        self.n_processes = n_processes
        self.folder = folder
        self.has_gone_on = False

    def start(self, settings, more=()):
        command = [self.arguments.program, "scene.prm"]
        if self.n_processes > 1:
            launcher = [self.arguments.mpiexec, "-np", str(self.n_processes)]
            command = launcher + command
        for setting in settings:
            command += ["--set", setting]
        return subprocess.Popen(
            command + list(more),
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )

    def run(self, settings, more=()):
        process = self.start(settings, more)
        output = process.communicate()[0]
        return process.returncode, output


def children_of(pid):
    """All processes below one."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = int(path.read_text().rsplit(")", 1)[1].split()[1])
        except (OSError, IndexError):
            continue
        if parent == pid:
            found.append(int(path.parent.name))
    return found + [below for child in found for below in children_of(child)]


def kill(process):
    """Kill a run at once, all processes of it."""
    for pid in children_of(process.pid) + [process.pid]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    output = process.communicate()[0]
    return output


def differences(first, second):
    """Yield a sentence for each difference between two output folders."""
    names = [
        sorted(str(p.relative_to(folder)) for p in folder.rglob("*")
               if p.is_file() and p.relative_to(folder).parts[0] not in IGNORED)
        for folder in (first, second)
    ]
    if names[0] != names[1]:
        yield f"files {sorted(set(names[0]) ^ set(names[1]))} are in one folder only"
    for name in set(names[0]) & set(names[1]):
        if name == "faults.h5":
            yield from history_differences(first / name, second / name)
        elif contents(first / name) != contents(second / name):
            yield f"{name} differs"


IGNORED = ("summary.txt", "parameters.prm", "checkpoints")


def contents(path):
    """Bytes of a file; of a VTU file without the time at which it was made, of a
    station without the name of the run."""
    return re.sub(rb"<!--.*?-->|^# problem=[^\n]*", b"", path.read_bytes(),
                  flags=re.DOTALL | re.MULTILINE)


def history_differences(first, second):
    with h5py.File(first, "r") as a, h5py.File(second, "r") as b:
        paths = []
        a.visit(paths.append)
        for path in paths:
            if isinstance(a[path], h5py.Dataset) and not numpy.array_equal(
                a[path][()], b[path][()], equal_nan=True
            ):
                yield f"faults.h5: {path} differs"


def wait_for_checkpoint(process, folder):
    """Wait until there is a new one, or the run has ended."""
    before = set(folder.glob("checkpoints/*.state"))
    while process.poll() is None and before == set(folder.glob("checkpoints/*.state")):
        time.sleep(0.005)


def wait_for_lock(folder):
    """Wait until nobody writes there any more: processes end after mpirun."""
    handle = os.open(folder, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    os.close(handle)


def goes_on(runs, settings):
    """Go on with a run that was killed, or begin it again."""
    folder = runs.folder / "killed"
    folder.mkdir(exist_ok=True)
    wait_for_lock(folder)
    if list(folder.glob("checkpoints/*.state")):
        runs.has_gone_on = True
        return runs.start(settings, ["--restart"])
    return runs.start(settings, ["--overwrite"])


def check_kills(runs, settings, n_kills, generator):
    """Yield what is different in a run that is killed so many times."""
    began = time.monotonic()
    status, output = runs.run(settings + NONE + ["Output/Output directory=reference"])
    duration = time.monotonic() - began
    if status != 0:
        yield f"the run without checkpoints fails: {output[-300:]}"
        return
    settings = settings + OFTEN + ["Output/Output directory=killed"]
    shutil.rmtree(runs.folder / "killed", ignore_errors=True)
    process = runs.start(settings)
    for _ in range(n_kills):
        # Most kills while steps are made, some at the start.
        if generator.random() < 0.8:
            wait_for_checkpoint(process, runs.folder / "killed")
        time.sleep(generator.uniform(0, duration / n_kills))
        kill(process)
        process = goes_on(runs, settings)
    output = process.communicate()[0]
    if process.returncode != 0:
        yield f"the run that goes on fails: {output[-300:]}"
        return
    yield from differences(runs.folder / "reference", runs.folder / "killed")
    summary = (runs.folder / "killed/summary.txt").read_text()
    if runs.has_gone_on and "restarts" not in summary:
        yield "no restart in summary.txt"


def check_damage(runs, settings):
    """Yield what is wrong with the use of damaged checkpoints."""
    settings = settings + ["Output/Output directory=killed"]
    often = settings + OFTEN + ["Output/Checkpoints kept=3"]
    status, output = runs.run(often, ["--overwrite"])
    files = sorted((runs.folder / "killed/checkpoints").glob("*.state"))
    if status != 0 or len(files) != 3:
        yield f"{len(files)} checkpoints in place of 3: {output[-300:]}"
        return
    table = (runs.folder / "killed/time_series.csv").read_bytes()
    whole = files[2].read_bytes()
    files[2].write_bytes(whole[: len(whole) // 2])
    other = bytearray(files[1].read_bytes())
    other[len(other) // 3] ^= 4
    files[1].write_bytes(bytes(other))
    status, output = runs.run(settings, ["--restart"])
    if status != 0 or output.count("is damaged. The one before is used.") != 2:
        yield f"damaged checkpoints: {output[-500:]}"
    if f"({files[0].relative_to(runs.folder)})" not in output:
        yield f"not the checkpoint {files[0]}: {output[-500:]}"
    if (runs.folder / "killed/time_series.csv").read_bytes() != table:
        yield "time_series.csv differs after a restart from an older checkpoint"
    for path in (runs.folder / "killed/checkpoints").iterdir():
        path.write_bytes(b"")
    status, output = runs.run(settings, ["--restart"])
    if status != 1 or "there is no whole checkpoint" not in output:
        yield f"without a checkpoint: {status} {output[-500:]}"
    if (runs.folder / "killed/time_series.csv").read_bytes() != table:
        yield "a restart without a checkpoint has touched the results"


def check_other_numbers(runs, settings):
    """Yield what is different where other numbers of processes go on."""
    runs.run(settings + NONE + ["Output/Output directory=reference"], ["--overwrite"])
    reference = table(runs.folder / "reference/time_series.csv")
    settings = settings + OFTEN + ["Output/Output directory=killed"]
    shutil.rmtree(runs.folder / "killed", ignore_errors=True)
    process = runs.start(settings)
    for n_processes in (3, 1):
        for _ in range(20):
            wait_for_checkpoint(process, runs.folder / "killed")
        kill(process)
        runs.n_processes = n_processes
        process = goes_on(runs, settings)
    output = process.communicate()[0]
    if process.returncode != 0 or not runs.has_gone_on:
        yield f"on other numbers of processes: {output[-300:]}"
        return
    other = table(runs.folder / "killed/time_series.csv")
    if len(other) != len(reference):
        yield f"{len(other)} records on other numbers of processes, not {len(reference)}"
        return
    # Sums in another order, and what solvers leave at their tolerance; counts of
    # iterations may change.
    for name in reference.dtype.names:
        if "iterations" in name or "cycles" in name or "error" in name:
            continue
        scale = numpy.max(numpy.abs(reference[name]))
        difference = numpy.max(numpy.abs(reference[name] - other[name]))
        if difference > 1e-5 * scale:
            yield f"{name} differs by {difference:.1e} of {scale:.1e}"


def table(path):
    return numpy.genfromtxt(path, delimiter=",", names=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("mpiexec")
    parser.add_argument("tests", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--long", action="store_true", help="all cases, 20 kills each")
    parser.add_argument("--seed", type=int)
    arguments = parser.parse_intermixed_args()
    seed = random.randrange(10**6) if arguments.seed is None else arguments.seed
    scene = read_scene(arguments.tests)
    n_problems = 0
    for name, (settings, n_processes, is_long) in CASES.items():
        if (name not in arguments.names) if arguments.names else (
            is_long and not arguments.long
        ):
            continue
        with tempfile.TemporaryDirectory(prefix="stickslip-") as path:
            folder = pathlib.Path(path)
            (folder / "scene.prm").write_text(scene)
            runs = Runs(arguments, folder, n_processes)
            generator = random.Random(f"{seed} {name}")
            n_kills = 20 if arguments.long else 3
            problems = list(check_kills(runs, settings, n_kills, generator))
            if name == "sliding":
                problems += check_damage(runs, settings)
            if n_processes == 2:
                problems += check_other_numbers(runs, settings)
        for problem in problems:
            print(f"{name}, seed {seed}: {problem}", flush=True)
        n_problems += len(problems)
    return 1 if n_problems else 0


if __name__ == "__main__":
    sys.exit(main())
