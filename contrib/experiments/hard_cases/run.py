# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run a scene and read what it leaves."""

import dataclasses
import re
import shutil
import subprocess

import h5py
import numpy as np

from common import runs

@dataclasses.dataclass
class Result:
    """Files of a run. `message` is empty where it reached its end, `report` is what it
    prints at the start, `events` are the times at which they start, in s, `openings`
    the number of those that faults have been through."""

    message: str
    report: str
    summary: dict
    fields: dict
    events: list
    openings: int

    def number(self, name):
        """Of the summary, 'section/name'; None where there is none."""
        value = self.summary.get(name)
        return float(value.split()[0]) if value else None


def read_fields(path):
    """For each fault its node positions and its last record."""
    fields = {}
    if not path.is_file():
        return fields
    with h5py.File(path, "r") as file:
        for fault, group in file.items():
            if len(group["time"]) == 0:
                continue
            fields[fault] = {
                "x": np.array(group["coordinates"])[:, 0],
                "weight": np.array(group["weight"]),
                "time": float(np.array(group["time"]).ravel()[-1]),
            }
            for name in ("slip", "slip_rate", "state", "shear_traction",
                         "normal_stress", "gap"):
                if name in group:
                    fields[fault][name] = np.array(group[name][-1])
    return fields


def count_rows(path):
    return len(path.read_text().splitlines()) - 1 if path.is_file() else 0


def run(program, text, folder, timeout):
    """Run the scene in that parameter file's text; its files go to folder."""
    folder.mkdir(parents=True, exist_ok=True)
    scene, output = folder / "scene.prm", folder / "output"
    scene.write_text(text, encoding="utf-8")
    # Programs of other revisions may not know --overwrite.
    shutil.rmtree(output, ignore_errors=True)
    command = [str(program), str(scene), "--set", f"Output/Output directory={output}"]
    printed = folder / "printed.txt"
    try:
        with open(printed, "w", encoding="utf-8") as file:
            process = subprocess.run(
                command,
                timeout=timeout,
                text=True,
                stdout=file,
                stderr=subprocess.PIPE,
            )
        message = process.stderr.strip()
        if process.returncode != 0 and not message:
            message = f"exit status {process.returncode} without a message"
        if process.returncode == 0:
            message = ""
    except subprocess.TimeoutExpired:
        message = f"more than {timeout:g} s"
    summary = runs.results(output)
    return Result(
        re.sub(r"^stickslip: ", "", message),
        printed.read_text(encoding="utf-8"),
        summary,
        read_fields(output / "faults.h5"),
        sorted(start for starts in summary["events"].values() for start in starts),
        count_rows(output / "openings.csv"),
    )
