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

from pictures.run_files import read_table

from . import programs, runs


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

    def __init__(self, case, folder):
        self.case = case
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
            self._series = read_table(self.files / "time_series.csv")
        return self._series

    def end(self):
        """Simulated time in s that was reached."""
        return float(self.series()["time"][-1])

    def events(self, fault):
        """Columns of events.csv for one fault, in the order of their starts."""
        table = read_table(self.files / "events.csv")
        own = table["fault"] == fault
        return {name: values[own] for name, values in table.items()}

    def history(self):
        return self.files / "faults.h5"


class Store:
    """Finished runs of a program in a folder."""

    def __init__(self, folder, program=programs.PROGRAM, log=print):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.log = log

    def run(self, case):
        return Run(case, self.folder_of(case))

    def folder_of(self, case):
        """The folder of a run, computed if that has not been done."""
        folder = self.folder / digest(case)
        if not (folder / "run.json").is_file():
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            files = {"Output/Output directory": folder / "files"}
            seconds, note = programs.run_measured(
                [str(self.program), case.scene]
                + programs.options(case.all_settings() | files),
                case.longest,
            )
            record = {
                "title": case.title,
                "scene": case.scene,
                "settings": case.all_settings(),
                "cpu_seconds": seconds,
                "note": note,
            }
            write_done(folder, record | self.finish(folder, record))
            self.log(f"{case.title}: {seconds:.0f} s {note}")
        return folder

    def finish(self, folder, record):
        """What a run's record says besides; a run that failed is none."""
        if record["note"].startswith("failed"):
            raise programs.Failed(f"{record['title']}: {record['note']}")
        return {}


def add_arguments(parser, sections):
    """What a script takes that runs sections of a page."""
    parser.add_argument("--only", choices=list(sections), metavar="SECTION")
    parser.add_argument("--keep", metavar="FOLDER")
    parser.add_argument("--program", default=programs.PROGRAM)


@contextlib.contextmanager
def opened(arguments):
    """The store that such a script was asked for; it tells when a run is done."""
    begin = time.monotonic()

    def log(message):
        print(f"{time.monotonic() - begin:.0f} s: {message}", flush=True)

    with programs.temporary_folder() as folder:
        yield Store(arguments.keep or folder, arguments.program, log)


def digest(case):
    """Names the run by what is computed, whatever it is used for."""
    text = json.dumps([case.scene, case.all_settings()], sort_keys=True)
    return hashlib.sha1(text.encode()).hexdigest()[:12]


def write_done(path, record):
    """Last, and in one piece: a run broken off before leaves nothing to trust."""
    temporary = path / "run.json.new"
    temporary.write_text(json.dumps(record, indent=1))
    temporary.rename(path / "run.json")
