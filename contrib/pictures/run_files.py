# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The tables and texts of a run, and its events."""

import csv
import dataclasses
import pathlib

import numpy as np

from .fault_fields import FaultFields
from .run_error import RunError


def read_table(path):
    """The columns of a CSV file by name; numbers where they are numbers."""
    if not path.is_file():
        raise RunError(f"There is no file {path}.")
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    if not rows:
        raise RunError(f"{path} is empty.")
    # The last row of a run that goes on may not be whole yet.
    names, rows = rows[0], [row for row in rows[1:] if len(row) == len(rows[0])]
    table = {}
    for column, name in enumerate(names):
        values = [row[column] for row in rows]
        table[name] = np.array(
            values if name == "fault" else [float(v or "nan") for v in values],
            dtype=str if name == "fault" else float,
        )
    return table


@dataclasses.dataclass
class Event:
    """One event: its number among those of its fault, from 1, when it starts and ends,
    times around both that show it, s, and the slip rate that it begins at, m/s."""

    number: int
    start: float
    end: float
    window: tuple
    threshold: float


class Run:
    """The files of a run in their folder, complete or not."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.series = read_table(self.folder / "time_series.csv")
        self.events = read_table(self.folder / "events.csv")
        if len(self.series["time"]) == 0:
            raise RunError(f"{self.folder / 'time_series.csv'} holds no step.")
        self.faults = [name[: -len(".max_slip_rate")] for name in self.series
                       if name.endswith(".max_slip_rate")]
        if not self.faults:
            raise RunError("time_series.csv has no column of slip rates.")
        self._fields = {}

    @property
    def name(self):
        return self.folder.resolve().name

    @property
    def times(self):
        """When the first and the last step end, s."""
        return self.series["time"][0], self.series["time"][-1]

    def table(self, name):
        """The columns of another table, or None if there is no such file."""
        path = self.folder / name
        return read_table(path) if path.is_file() else None

    def table_of_columns(self):
        """The rows of columns.csv, dictionaries; none of earlier versions' runs."""
        path = self.folder / "columns.csv"
        if not path.is_file():
            return []
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def text(self, name):
        path = self.folder / name
        return path.read_text(encoding="utf-8") if path.is_file() else ""

    def fields(self, fault):
        if fault not in self._fields:
            self._fields[fault] = FaultFields(self.folder / "faults.h5", fault)
        return self._fields[fault]

    def may_open(self, fault):
        return f"{fault}.open_area" in self.series

    def of(self, fault, column):
        """A column of a fault in time_series.csv."""
        return self.series[f"{fault}.{column}"]

    def events_of(self, fault):
        own = self.events["fault"] == fault
        return {name: values[own] for name, values in self.events.items()}

    def chosen_faults(self, wanted=None):
        """Faults by their names with commas between them, or 'all'; by default the one
        with most events."""
        if wanted == "all":
            return self.faults
        if wanted is not None:
            for name in wanted.split(","):
                if name not in self.faults:
                    raise RunError(
                        f"No fault {name}; there are {', '.join(self.faults)}.")
            return wanted.split(",")
        # On a tie the last fault: the topmost one, nearest to the usual loading.
        return [max(reversed(self.faults),
                    key=lambda name: int(np.sum(self.events["fault"] == name)))]

    def event(self, fault, number=None):
        """One event of a fault, by default the one in the middle; None: there are
        none."""
        own = self.events_of(fault)
        count = len(own["start"])
        if count == 0:
            return None
        index = count // 2 if number is None else number - 1
        if not 0 <= index < count:
            raise RunError(f"There is no event {number}; there are {count}.")
        start, end = own["start"][index], own["end"][index]
        if not np.isfinite(end):
            end = max(own["peak_time"][index], self.times[1])
        margin = 0.5 * max(end - start, 1e-3)
        # Events begin where the mean slip rate passes the threshold.
        rate = np.maximum(self.of(fault, "mean_slip_rate"), 1e-300)
        threshold = np.exp(np.interp(start, self.series["time"], np.log(rate)))
        return Event(index + 1, start, end, (start - margin, end + margin), threshold)
