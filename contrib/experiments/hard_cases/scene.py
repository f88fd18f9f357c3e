# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Scenes as dictionaries from 'Section/Entry' to a value, and their files."""

import dataclasses

# What the published spring slider has, in all bodies and on all faults.
BODY = {
    "Lower lateral corner": "-2.5",
    "Upper lateral corner": "2.5",
    "Thickness": "1",
    "Coarse cells": "10, 2",
    "Refinement passes": "4",
}
FAULT = {"a": "0.010", "b": "0.015", "Characteristic slip": "2e-5"}

# Between neighbouring nodes of the fault of that mesh.
NODE_DISTANCE = 5 / 160

CONDENSED = {
    "Time/Rate solver": "condensed Newton",
    "TNNMG/Tolerance": "1e-12",
    "Time/Rate-state tolerance": "1e-9",
}
UMFPACK = {"TNNMG/Linear correction": "UMFPACK", "TNNMG/Tolerance": "1e-12"}


@dataclasses.dataclass
class Case:
    """A scene, and what its result is compared with: the same scene with the
    entries of `reference` changed, or nothing. `disturbed`: entries that are changed
    by as much as rounding does, where the scene amplifies that."""

    group: str
    name: str
    scene: dict
    reference: dict | None = None
    reference_name: str = "condensed Newton"
    disturbed: dict | None = None
    note: str = ""
    timeout: float = 300.0
    # Part of the message with which the program is expected to end, if any.
    refused: str = ""
    # Part of a warning at the start that what comes out is wrong, if any.
    warned: str = ""


def bodies(names, body=None, fault=None):
    """Bodies on each other like those of the spring slider, the lowest one held
    at its bottom, the uppermost one dragged along at its top."""
    faults = [f"fault{i + 1}" for i in range(len(names) - 1)]
    scene = {
        "Bodies/Names": ", ".join(names),
        "Faults/Names": ", ".join(faults),
        "Boundary conditions/Sides": f"{names[0]} bottom, {names[-1]} top",
        f"Boundary conditions/{names[0]} bottom/x condition": "fixed",
        f"Boundary conditions/{names[0]} bottom/y condition": "fixed",
        f"Boundary conditions/{names[-1]} top/x condition": "velocity",
        f"Boundary conditions/{names[-1]} top/x value": "2e-4",
        "Output/Write volume": "false",
        # So that what is compared is not how far the iteration went.
        "TNNMG/Tolerance": "1e-9",
    }
    for name in names:
        for entry, value in (BODY | (body or {})).items():
            scene[f"Bodies/{name}/{entry}"] = value
    for name in faults:
        for entry, value in (FAULT | (fault or {})).items():
            scene[f"Faults/{name}/{entry}"] = value
    return scene


def slider(end_time, overrides=None, body=None, fault=None):
    """The spring slider; it slips first at 22.3 s."""
    scene = bodies(["lower", "upper"], body, fault)
    return scene | {"Time/End time": f"{end_time:g}"} | (overrides or {})


def material(name, **entries):
    """Entries such as young_modulus=1 of the material of a body."""
    return {
        f"Bodies/{name}/Material/{entry.replace('_', ' ').capitalize()}": f"{value:g}"
        for entry, value in entries.items()
    }


def text(scene):
    """The parameter file of a scene."""
    lines = []
    for path, value in scene.items():
        *sections, entry = path.split("/")
        lines += [f"subsection {section}" for section in sections]
        lines += [f"set {entry} = {value}"] + ["end"] * len(sections)
    return "\n".join(lines) + "\n"
