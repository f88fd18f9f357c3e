# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Whole runs of the spring slider, each kept so that it is done only once."""

import dataclasses
import hashlib
import json
import pathlib
import resource
import shutil
import signal
import subprocess

from measure import programs, runs

from . import reduced

SCENE = "parameters/spring_slider.prm"
# s: after the first four events, and after eleven or twelve; a bit more than where
# slip is compared, to interpolate.
SHORT, LONG = 28.5, 40.5
# Records are dense enough to resolve the waves in the bodies (a layer is crossed
# in 18 ms), so that the error is not that of interpolating between them.
OUTPUT = {"Output/Write volume": "false", "Output/Fault longest interval": "0.01"}


@dataclasses.dataclass(frozen=True)
class Case:
    """A run: which error it contributes to, and what it sets."""

    section: str
    family: str
    # What is varied within the family, as it stands in tables.
    tolerance: str
    settings: tuple = ()
    mesh: str = "published"
    reference: "Case | None" = None
    end_time: float = SHORT
    # Time in s after which the run is interrupted.
    longest: float = 1500.0
    scene: str = SCENE

    def all_settings(self):
        return {
            **OUTPUT, "Time/End time": f"{self.end_time:g}", **dict(self.settings)
        }

    def digest(self):
        """Names the run by what is computed, whatever it is used for."""
        text = json.dumps([self.scene, self.all_settings()], sort_keys=True)
        return hashlib.sha1(text.encode()).hexdigest()[:12]

    def title(self):
        return f"{self.mesh}, {self.family}, {self.tolerance}"


class Store:
    """The folder of finished runs."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def result(self, case):
        """What came out of a case, computed if that has not been done.

        A dictionary with cpu_seconds, note (empty unless it failed), summary and
        events, and the arrays of reduced.reduce."""
        path = self.folder / case.digest()
        if not (path / "run.json").is_file():
            shutil.rmtree(path, ignore_errors=True)
            compute(case, path)
        result = json.loads((path / "run.json").read_text())
        return result | reduced.load(path)

    def has(self, case):
        return (self.folder / case.digest() / "run.json").is_file()


def compute(case, path):
    """Run the program, reduce its files, and say at last that it is done."""
    path.mkdir(parents=True)
    command = [str(programs.PROJECT / "build/stickslip"), case.scene]
    settings = case.all_settings() | {"Output/Output directory": path / "files"}
    for entry, value in settings.items():
        command += ["--set", f"{entry}={value}"]
    seconds, note = run_measured(command, case.longest)
    result = {
        "title": case.title(),
        "settings": case.all_settings(),
        "cpu_seconds": seconds,
        "note": note,
        **outputs(path / "files"),
    }
    reduced.reduce(path)
    write_done(path, result)
    shutil.rmtree(path / "files", ignore_errors=True)


def run_measured(command, longest):
    """User and system time of a program in s, and what went wrong, if anything."""
    before = cpu_of_children()
    process = subprocess.Popen(
        command,
        cwd=programs.PROJECT,
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


def outputs(files):
    """What the summary and the list of events say."""
    results = runs.results(files)
    events = next(iter(results.pop("events").values()), [])
    return {"summary": results, "events": events}


def write_done(path, result):
    """Last, and in one piece: a run broken off before leaves nothing to trust."""
    temporary = path / "run.json.new"
    temporary.write_text(json.dumps(result, indent=1))
    temporary.rename(path / "run.json")


def summary_number(result, name):
    """A number of the summary, or nan where the run has not written it."""
    value = result["summary"].get(name, "nan")
    return float(value.split()[0])
