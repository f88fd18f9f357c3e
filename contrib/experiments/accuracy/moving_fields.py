# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Fields of the spring slider in the bodies, through a nucleation and a rupture, on
cells of one size."""

import dataclasses
import xml.etree.ElementTree as ElementTree

import numpy as np

from common.vtu_file import decode
from pictures.run_files import read_table

from .cases import bodies, pairs
from .slider import SCENE

# Halvings of the 10 x 2 coarse cells of each body.
LEVELS = 5
# s: after the second event.
END = 24.5
# s: before that displacements since the start are lost in the digits of the files.
BEGIN = 1.0


@dataclasses.dataclass(frozen=True)
class FieldsCase:
    """A run with its fields in the bodies at many times, in the form of the store."""

    title: str = "fields on cells of one size"
    scene: str = SCENE
    longest: float = 3000.0

    def all_settings(self):
        return dict(pairs(
            bodies(Refinement_passes=0, Uniform_refinements=LEVELS) | {
                "Time/End time": f"{END:g}",
                "Output/Volume fields": "displacement, velocity",
                "Output/Write fault surfaces": "false",
                "Output/Volume slip rate factor": "2",
                "Output/Volume slip interval": "1e-5",
                "Output/Volume shortest interval": "2e-4",
                "Output/Volume longest interval": "0.5",
            }))


class Fields:
    """Displacements since the start and velocities of both bodies, set by set."""

    def __init__(self, run):
        self.folder = run.files
        collection = ElementTree.parse(self.folder / "solution.pvd").getroot()
        sets = [(float(d.get("timestep")), d.get("file"))
                for d in collection.iter("DataSet")]
        first = sets[0][1]
        self.sets = [(time, name) for time, name in sets if time >= BEGIN]
        self.order = None
        self.start = self.read(first)["displacement"]
        steps = read_table(self.folder / "time_series.csv")["time"]
        self.steps = steps[steps >= BEGIN]
        self.events = [
            (start, end) for start, end in zip(*(
                read_table(self.folder / "events.csv")[name]
                for name in ("start", "end")))]

    @property
    def times(self):
        return np.array([time for time, _ in self.sets])

    def weights(self):
        """How many steps are nearer to each set than to others."""
        times = self.times
        between = 0.5 * (times[1:] + times[:-1])
        numbers = np.searchsorted(self.steps, between)
        return np.diff(numbers, prepend=0, append=len(self.steps))

    def in_events(self):
        """Which of the sets are in an event."""
        return np.any([(self.times >= start) & (self.times <= end)
                       for start, end in self.events], axis=0)

    def at(self, number):
        """The fields of a set, each a list of arrays of nodes, body by body."""
        values = self.read(self.sets[number][1])
        return {
            "displacement": [now - before for now, before in
                             zip(values["displacement"], self.start)],
            "velocity": values["velocity"],
        }

    def read(self, name):
        root = ElementTree.parse(self.folder / name).getroot()
        arrays = {a.get("Name"): a for a in root.iter("DataArray")}
        if self.order is None:
            points = decode(arrays["Points"]).reshape(2, -1, 3)
            # The points of a body are together, in no order.
            self.order = [np.lexsort((p[:, 0].round(4), p[:, 1].round(4)))
                          for p in points]
            self.shape = (len(np.unique(points[0, :, 1].round(4))), -1, 2)
        return {
            field: [
                part[order, :2].astype(float).reshape(self.shape)
                for part, order in zip(
                    decode(arrays[field]).reshape(2, -1, 3), self.order)]
            for field in ("displacement", "velocity")
        }
