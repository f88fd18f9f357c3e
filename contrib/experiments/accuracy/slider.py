# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Whole runs of the published scenes, each kept so that it is done only once."""

import dataclasses
import json
import shutil

from common import runs
from common.store import Store

from . import mesh_search, reduced

SCENE = "parameters/spring_slider.prm"
FIVE_BODIES = "parameters/layered_five_bodies.prm"
# That has events; the others of five bodies hardly slip.
TOP_FAULTS = {SCENE: "fault", FIVE_BODIES: "fault4"}
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

    @property
    def title(self):
        return f"{self.mesh}, {self.family}, {self.tolerance}"


class SliderStore(Store):
    """Runs of which the record and some arrays stay, also where they failed."""

    def finish(self, folder, record):
        results = runs.results(folder / "files")
        fault = TOP_FAULTS[record["scene"]]
        events = results.pop("events").get(fault, [])
        reduced.reduce(folder, fault)
        search = self.search_seconds(folder / "files", record)
        shutil.rmtree(folder / "files", ignore_errors=True)
        return {"summary": results, "events": events, **search}

    def search_seconds(self, files, record):
        """For the mesh; nothing where there is no search."""
        cells = files / "refined_cells.txt"
        if not cells.is_file():
            return {}
        seconds = mesh_search.seconds(
            self.program, record["scene"], record["settings"], cells)
        return {"search_cpu_seconds": seconds}

    def result(self, case):
        """A dictionary with cpu_seconds, note (empty unless the run failed), summary
        and events, and the arrays of reduced.reduce."""
        folder = self.folder_of(case)
        return json.loads((folder / "run.json").read_text()) | reduced.load(folder)


def summary_number(result, name):
    """A number of the summary, or nan where the run has not written it."""
    value = result["summary"].get(name, "nan")
    return float(value.split()[0])
