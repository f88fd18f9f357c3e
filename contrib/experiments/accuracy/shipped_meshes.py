# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The meshes of the other shipped scenes beside those that the program finds for the
same error."""

import re
import subprocess
import tempfile

from common import page, programs

from .mesh_search import ENTRY

PAGE = programs.PROJECT / "doc/meshes.md"
SCENES = (
    "first_on_earth", "subduction_wedge", "slow_slip", "weakening_patch", "large_slip",
    "rough_fault", "nine_body_stack", "listric_thrust", "thrust_sequence", "crack",
    "crossing_faults", "branching_fault", "opening_wave", "lifted_patch",
    "lifted_corner",
)
# Slip that varies over the process zone may have that many times the error.
ALLOWANCE = 30.0
# The program tells what half of the difference of a mesh and the one with all cells
# halved is, the error that is left on the finer one; the coarser one has both.
OF_COARSER = 3.0
# s for a search.
LONGEST = 30.0
# With more of the energy a field has no energy, on no mesh: it jumps.
UNBOUNDED = 0.1


def ask(scene, settings, option="--check"):
    """What the program prints of a scene; None if that takes too long."""
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        settings = settings | {"Output/Output directory": folder}
        try:
            return subprocess.run(
                [programs.PROGRAM, f"parameters/{scene}.prm", option,
                 *programs.options(settings)],
                cwd=programs.PROJECT, capture_output=True, text=True, timeout=LONGEST,
            ).stdout
        except subprocess.TimeoutExpired:
            return None


def unrefined(scene):
    """Settings with which all meshes of a scene are their coarse cells."""
    sections, settings = [], {}
    for line in ask(scene, {}, "--print-parameters").splitlines():
        words = line.split()
        if words[:1] == ["subsection"]:
            sections.append(" ".join(words[1:]))
        elif words == ["end"]:
            sections.pop()
        elif len(sections) == 2 and sections[0] == "Bodies":
            for entry in ("Refinement passes", "Uniform refinements"):
                if line.strip().startswith(f"set {entry}"):
                    settings[f"Bodies/{sections[1]}/{entry}"] = "0"
    return settings


def errors(text):
    """Relative errors of the energy by name, as the program counts them."""
    found = re.search(r"relative errors of the energy: (.*)\.\n", text)
    result = {}
    for part in found[1].split(", "):
        name, error = part.rsplit(" ", 1)
        result[name] = float(error) / (ALLOWANCE if "fronts" in name else 1.0)
    return result


def unknowns(text):
    return re.search(r"([\d,]+) unknowns", text)[1]


def faces(text):
    """Of a process zone, on the fault where they are the fewest."""
    found = re.findall(r"process zone [^=;]*= ([\d.e+]+) faces", text)
    return page.number(min(map(float, found))) if found else "–"


def coarser(error):
    """That of today's mesh in %, as text."""
    return ("not bounded" if error > UNBOUNDED
            else page.number(100 * OF_COARSER * error))


def row(scene):
    today = ask(scene, {})
    halved = errors(ask(scene, {ENTRY: "0.99"}))
    of_loading, of_slip = halved.pop("loading", 0.0), max(halved.values())
    cells = [f"`{scene}`", unknowns(today), faces(today), coarser(of_slip),
             coarser(of_loading)]
    worst = max(of_loading, of_slip)
    if worst > UNBOUNDED:
        return [*cells, "–", "–"]
    found = ask(scene, unrefined(scene) | {ENTRY: f"{OF_COARSER * worst:.3g}"})
    if found is None:
        return [*cells, f"not within {LONGEST:.0f} s", "–"]
    return [*cells, unknowns(found), faces(found)]


def measure(quick):
    text = page.table(
        ["scene", "unknowns", "faces a process zone", "error of slip and fronts, %",
         "of the loading, %", "unknowns of the program's mesh",
         "its faces a process zone"],
        map(row, SCENES))
    if quick:
        print("\n" + text, flush=True)
    else:
        page.replace_section("shipped", text, PAGE, "contrib/accuracy")
