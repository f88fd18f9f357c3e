# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Run a scene and read what it leaves."""

import csv
import dataclasses
import os
import pathlib
import re
import subprocess

import h5py
import numpy as np

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = PROJECT / "build" / "stickslip"


@dataclasses.dataclass
class Result:
    """What a run has left. `message` is empty where it reached its end."""

    message: str
    summary: dict
    fields: dict
    events: list

    def number(self, section, key):
        value = self.summary.get((section, key))
        return float(value.split()[0]) if value else None

    def is_complete(self):
        return self.message == ""

    def n_messages(self):
        return len([line for line in self.message.splitlines() if line.strip()])


def environment():
    return os.environ | {
        "OMP_NUM_THREADS": "1",
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
    }


def read_summary(path):
    """Values as text by section and key."""
    values, section = {}, ""
    if path.is_file():
        for line in path.read_text(encoding="utf-8").splitlines():
            if line and not line.startswith(" "):
                section = line.strip()
            elif line.strip():
                key, _, value = line.strip().partition("  ")
                values[section, key.strip()] = value.strip()
    return values


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
                         "normal_stress"):
                fields[fault][name] = np.array(group[name][-1])
    return fields


def run(program, text, folder, timeout):
    """Run the scene in that parameter file's text; its files go to folder."""
    folder.mkdir(parents=True, exist_ok=True)
    scene, output = folder / "scene.prm", folder / "output"
    scene.write_text(text, encoding="utf-8")
    command = [str(program), str(scene), "--set", f"Output/Output directory={output}"]
    try:
        process = subprocess.run(
            command,
            timeout=timeout,
            text=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            env=environment(),
        )
        message = process.stderr.strip()
        if process.returncode != 0 and not message:
            message = f"exit status {process.returncode} without a message"
        if process.returncode == 0:
            message = ""
    except subprocess.TimeoutExpired:
        message = f"more than {timeout:g} s"
    message = re.sub(r"^stickslip: ", "", message)
    events = output / "events.csv"
    return Result(
        message,
        read_summary(output / "summary.txt"),
        read_fields(output / "faults.h5"),
        list(csv.DictReader(events.open())) if events.is_file() else [],
    )
