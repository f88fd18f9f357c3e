# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Finished runs in a folder, each done only once."""

import contextlib
import dataclasses
import hashlib
import json
import pathlib
import shutil
import time

import plot_run
from measure import programs, runs
from study.slider import run_measured, write_done


@dataclasses.dataclass(frozen=True)
class Case:
    """A run of the program: its title, the file of the scene, and what is set anew."""

    title: str
    scene: str
    settings: tuple = ()
    # s of computing after which it is interrupted.
    longest: float = 14400.0

    def all_settings(self):
        return dict(self.settings)


class Run:
    """The files of a finished run."""

    def __init__(self, experiment, folder):
        self.experiment = experiment
        self.folder = folder
        self.record = json.loads((folder / "run.json").read_text())
        self.files = folder / "files"

    @property
    def cpu_seconds(self):
        return self.record["cpu_seconds"]

    @property
    def note(self):
        return self.record["note"]

    def summary(self):
        """Entries of summary.txt by 'section/name', as text."""
        return runs.results(self.files)

    def summary_number(self, name):
        """A number of the summary, or nan where there is none."""
        return float(self.summary().get(name, "nan").split()[0])

    def series(self):
        """Columns of time_series.csv by name."""
        if not hasattr(self, "_series"):
            self._series = plot_run.read_table(self.files / "time_series.csv")
        return self._series

    def end(self):
        """Simulated time in s that was reached."""
        return float(self.series()["time"][-1])

    def events(self, fault):
        """Columns of events.csv for one fault, in the order of their starts."""
        table = plot_run.read_table(self.files / "events.csv")
        own = table["fault"] == fault
        return {name: values[own] for name, values in table.items()}

    def history(self):
        return self.files / "faults.h5"


class Store:
    """Finished runs of a program in a folder."""

    def __init__(self, folder, program, log=print):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.log = log

    def run(self, experiment):
        """The run, computed if that has not been done."""
        folder = self.folder / digest(experiment)
        if not (folder / "run.json").is_file():
            shutil.rmtree(folder, ignore_errors=True)
            compute(experiment, folder, self.program)
            done = Run(experiment, folder)
            self.log(f"{experiment.title}: {done.cpu_seconds:.0f} s {done.note}")
        return Run(experiment, folder)


def add_arguments(parser, sections):
    """What a script takes that runs sections of a page."""
    parser.add_argument("--only", choices=list(sections), metavar="SECTION")
    parser.add_argument("--keep", metavar="FOLDER")
    parser.add_argument("--program", default=programs.PROJECT / "build/stickslip")


@contextlib.contextmanager
def opened(arguments):
    """The store that such a script was asked for; it tells when a run is done."""
    begin = time.monotonic()

    def log(message):
        print(f"{time.monotonic() - begin:.0f} s: {message}", flush=True)

    with programs.temporary_folder() as folder:
        yield Store(arguments.keep or folder, arguments.program, log)


def digest(experiment):
    """Names the run by what is computed."""
    text = json.dumps([experiment.scene, experiment.all_settings()], sort_keys=True)
    return hashlib.sha1(text.encode()).hexdigest()[:12]


def compute(experiment, folder, program):
    folder.mkdir(parents=True)
    command = [str(program), experiment.scene]
    settings = experiment.all_settings() | {"Output/Output directory": folder / "files"}
    for entry, value in settings.items():
        command += ["--set", f"{entry}={value}"]
    seconds, note = run_measured(command, experiment.longest)
    if note.startswith("failed"):
        raise programs.Failed(f"{experiment.title}: {note}")
    write_done(
        folder,
        {
            "title": experiment.title,
            "settings": experiment.all_settings(),
            "cpu_seconds": seconds,
            "note": note,
        },
    )
