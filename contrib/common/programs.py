# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Where the project is, how its programs are started, and on what machine."""

import argparse
import os
import pathlib
import resource
import signal
import subprocess
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = PROJECT / "build/stickslip"


class Failed(Exception):
    """A measurement that did not come to its end, with the reason in short."""


def argument_parser(description):
    """A parser that shows a script's own text for --help."""
    return argparse.ArgumentParser(
        description=description, usage=argparse.SUPPRESS,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )


def options(settings):
    """Settings, a dictionary from 'Section/Entry' to a value, as the program's options."""
    return [word for entry, value in settings.items()
            for word in ("--set", f"{entry}={value}")]


def run_measured(command, longest):
    """User and system time of a program in s, and what went wrong, if anything."""
    before = cpu_of_children()
    process = subprocess.Popen(
        command,
        cwd=PROJECT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    note = ""
    try:
        _, errors = process.communicate(timeout=longest)
    except subprocess.TimeoutExpired:
        # The program ends after its time step, with complete files.
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        note = f"interrupted after {longest:.0f} s"
    if process.returncode != 0 and not note:
        lines = [line.strip() for line in errors.splitlines() if line.strip()]
        note = "failed: " + (lines[-1] if lines else f"status {process.returncode}")
    return cpu_of_children() - before, note


def cpu_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def machine():
    model = next(
        line.split(":", 1)[1].strip()
        for line in open("/proc/cpuinfo")
        if line.startswith("model name")
    )
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    cores = len(os.sched_getaffinity(0))
    return f"{model}, {cores} cores, {memory:.0f} GiB"


def temporary_folder():
    return tempfile.TemporaryDirectory(prefix="stickslip-")
