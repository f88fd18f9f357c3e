#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the program refuses bad inputs with one clear sentence.

Usage: check_bad_inputs.py PROGRAM TABLE [PART]

The table says what it holds. All scenes of a part are checked in one start of the
program (`stickslip --check FILE...`), those of the part 'run' are run. With PART
only what has it in the scene, the edits or the words is looked at. Prints one
paragraph for each answer that is not as the table says, and returns 1 if there
are any.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

BODY = [
    ("Lower lateral corner", "-1"),
    ("Upper lateral corner", "1"),
    ("Thickness", "0.5"),
    ("Coarse cells", "4, 1"),
    ("Refinement passes", "2"),
    ("Material/Shear viscosity", "2e5"),
    ("Material/Bulk viscosity", "2e5"),
]
FAULT = [
    ("a", "0.02"),
    ("b", "0.01"),
    ("Reference friction coefficient", "0"),
    ("Reference slip rate", "1e-3"),
    ("Characteristic slip", "1e-3"),
    ("Regularisation", "arcsinh"),
    ("Initial state", "1"),
    ("Normal stress", "function"),
    ("Normal stress function", "2e4"),
]


def with_section(section, entries):
    return [(f"{section}/{name}", value) for name, value in entries]


PLANE = (
    [("Bodies/Names", "lower, upper"), ("Bodies/Base elevation", "-0.5")]
    + with_section("Bodies/lower", BODY)
    + with_section("Bodies/upper", BODY)
    + [("Faults/Names", "main")]
    + with_section("Faults/main", FAULT)
    + [("Boundary conditions/Sides", "lower bottom, upper top")]
    + with_section(
        "Boundary conditions/lower bottom",
        [("x condition", "fixed"), ("y condition", "fixed")],
    )
    + with_section(
        "Boundary conditions/upper top",
        [("x condition", "velocity"), ("x value", "1e-3"), ("Ramp length", "0")],
    )
    + [("Gravity/Acceleration", "0"), ("Time/End time", "1")]
)


def changed(scene, changes):
    """A copy of a scene with entries set; an entry without a value goes."""
    result = dict(scene)
    for path, value in changes.items():
        if value is None:
            result.pop(path, None)
        else:
            result[path] = value
    return list(result.items())


def space():
    changes = {"Dimension": "3", "Boundary conditions/lower bottom/z condition": "fixed"}
    for body in ("lower", "upper"):
        changes[f"Bodies/{body}/Lower lateral corner"] = "-1, -1"
        changes[f"Bodies/{body}/Upper lateral corner"] = "1, 1"
        changes[f"Bodies/{body}/Coarse cells"] = "2, 2, 1"
        changes[f"Bodies/{body}/Refinement passes"] = "1"
    return changed(PLANE, changes)


def blocks():
    changes = {
        "Bodies/Base elevation": None,
        "Bodies/lower/Corners": "-1 -0.5, 1 -0.5, 1 0, -1 0",
        "Bodies/upper/Corners": "-1 0, 1 0, 1 0.5, -1 0.5",
        "Faults/main/Between": "lower top, upper bottom",
    }
    for body in ("lower", "upper"):
        for entry in ("Lower lateral corner", "Upper lateral corner", "Thickness"):
            changes[f"Bodies/{body}/{entry}"] = None
    return changed(PLANE, changes)


SCENES = {
    "plane": PLANE,
    "space": space(),
    "blocks": blocks(),
    "open": changed(PLANE, {"Faults/main/Contact": "unilateral"}),
    "regions": changed(
        PLANE,
        {
            "Faults/main/Regions/Names": "middle",
            "Faults/main/Regions/middle/Where": "abs(x) < 0.5",
            "Faults/main/Regions/middle/a": "0.03",
        },
    ),
    # The fault goes on beyond its part with friction.
    "half space": changed(
        PLANE,
        {
            "Faults/main/Initial slip rate along x": "1e-9",
            "Faults/main/Initial shear stress along x": "1e3",
            "Faults/main/Initial state": None,
            "Faults/main/Reference friction coefficient": "0.6",
            "Faults/main/Regions/Names": "beyond",
            "Faults/main/Regions/beyond/Where": "abs(x) - 0.05",
            "Faults/main/Regions/beyond/Friction": "prescribed slip rate",
            "Faults/main/Regions/beyond/Slip rate along x": "1e-9",
        },
    ),
}


def text_of(entries, more_lines):
    """Lines of a parameter file, and the line of each entry, from one."""
    lines, line_of, is_open = [], {}, []
    for path, value in entries:
        *sections, name = path.split("/")
        # The value may be a fraction, but names of entries have no slash.
        while is_open != sections[: len(is_open)]:
            is_open.pop()
            lines.append("end")
        for section in sections[len(is_open) :]:
            is_open.append(section)
            lines.append(f"subsection {section}")
        lines.append(f"set {name} = {value}")
        line_of[path] = len(lines)
    lines += ["end"] * len(is_open) + more_lines
    return lines, line_of


class Case:
    def __init__(self, number, part, columns):
        self.part = part
        self.row = " | ".join(columns)
        self.columns = columns
        self.name = f"scene_{number}.prm"
        changes, more_lines, self.path = {}, [], None
        for edit in (e.strip(" ") for e in columns[1].split(" ; ")):
            edit = edit.encode("utf-8").replace(b"\\0", b"\0").replace(b"\\t", b"\t")
            edit = edit.replace(b"\\r", b"\r").replace(b"\\x1b", b"\x1b")
            edit = edit.replace(b"\\x85", "\x85".encode("utf-8"))
            edit = edit.decode("utf-8")
            if edit.startswith("- "):
                changes[edit[2:].strip()] = None
            elif edit.startswith("+ "):
                more_lines.append(edit[2:])
            else:
                path, value = re.match(r"(.*?) =(.*)", edit, re.DOTALL).groups()
                changes[path], self.path = value.strip(), path
        entries = changed(SCENES[columns[0]], changes)
        # Entries of a section that is open already stay in it.
        order = {}
        for path, _ in entries:
            order.setdefault(path.split("/")[0], len(order))
        entries.sort(key=lambda item: order[item[0].split("/")[0]])
        lines, line_of = text_of(entries, more_lines)
        self.text = "\n".join(lines) + "\n"
        self.line = line_of.get(self.path, len(lines)) if not more_lines else len(lines)

    def words(self):
        return [w.strip() for w in self.columns[2].split("&") if w.strip()]


def read_table(path):
    part, cases = None, []
    for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        if line.startswith("== "):
            part = line[3:]
        elif line and not line.startswith("#"):
            columns = [column.strip(" ") for column in line.split("|")]
            cases.append(Case(len(cases) + 1, part, columns))
    return cases


def missing(words, answer):
    return [f"'{word}' is missing" for word in words if word not in answer]


def wrong_sentence(answer):
    """What is wrong with the form of a message that follows 'stickslip: '."""
    if not answer:
        return ["there is no message"]
    if answer.count("\n") > 0:
        return ["there is more than one line"]
    if not answer.endswith("."):
        return ["it does not end with a full stop"]
    if re.search(r"dealii|terminate|std::|/usr/|source/", answer):
        return ["it is text of a library"]
    return []


def check_scenes(program, folder, cases):
    """Answers of one start of the program that are not as they should be."""
    run = subprocess.run(
        [program, "--check"] + [case.name for case in cases],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=600,
    )
    if run.returncode not in (0, 1):
        yield f"status {run.returncode}\n{run.stdout[-500:]}{run.stderr[-2000:]}"
    messages = dict(re.findall(r"^stickslip: (scene_\d+\.prm): (.*)$", run.stderr, re.M))
    reports = {}
    for part in re.split(r"^(?=scene_\d+\.prm:$)", run.stdout, flags=re.M):
        reports[part.split(":")[0]] = part
    for line in run.stderr.splitlines():
        if not line.startswith("stickslip: scene_"):
            yield f"this line stands alone: {line}"
    for case in cases:
        message, report = messages.get(case.name, ""), reports.get(case.name, "")
        has_folder = (folder / "output" / case.name[:-4]).exists()
        if case.part == "warned":
            warnings = re.findall(r"^Warning: .*$", report, re.M)
            wrong = missing(case.words(), "\n".join(warnings))
            wrong += [w for line in warnings for w in wrong_sentence(line)]
            if message or not has_folder:
                wrong.append("it is refused")
            answer = message or report
        else:
            wrong = wrong_sentence(message) + missing(case.words(), message)
            if case.part == "refused, with its line":
                wrong += missing([f"{case.name}, line {case.line}"], message)
            if has_folder:
                wrong.append("there is an output folder")
            answer = message
        if wrong:
            yield f"{case.row}\n  {'; '.join(wrong)}:\n  {answer}"


def run_scene(program, folder, case):
    """What is wrong with a run of its own."""
    status, words = re.match(r"(\d+) ?(.*)", case.columns[2]).groups()
    wanted = case.columns[3].split()
    before = set(os.listdir(folder))
    run = subprocess.run(
        [program, case.name],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=120,
    )
    wrong = missing([w.strip() for w in words.split("&")], run.stdout + run.stderr)
    if run.returncode != int(status):
        wrong.append(f"the status is {run.returncode}")
    if run.returncode == 1 and not run.stderr.startswith("stickslip: "):
        wrong.append("there is no message")
    if run.returncode == 1:
        wrong += wrong_sentence(run.stderr.rstrip("\n"))
    output = folder / "output" / case.name[:-4]
    if wanted == ["none"]:
        if output.exists() or set(os.listdir(folder)) != before:
            wrong.append("there are new files")
    else:
        wrong += [f"{name} is missing" for name in wanted if not (output / name).is_file()]
    if wrong:
        yield f"{case.row}\n  {'; '.join(wrong)}:\n  {run.stdout}{run.stderr}"


def main():
    program, table = os.path.abspath(sys.argv[1]), sys.argv[2]
    cases = read_table(table)
    if len(sys.argv) > 3:
        cases = [case for case in cases if sys.argv[3] in case.row]
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "elsewhere.txt").write_text("x\n5 0.01\n6 0.01\n")
        (folder / "with_zero.txt").write_text("x\n0 \0\n1 2\n")
        (folder / "in_km.txt").write_text("x value (km)\n-1 1\n1 2\n")
        (folder / "file").write_text("")
        (folder / "results").mkdir()
        (folder / "results" / "events.csv").write_text("of another run\n")
        for case in cases:
            (folder / case.name).write_text(case.text, encoding="utf-8")
        checked = [case for case in cases if case.part != "run"]
        if checked:
            wrong += check_scenes(program, folder, checked)
        for case in cases:
            if case.part == "run":
                wrong += run_scene(program, folder, case)
        if (folder / "results" / "events.csv").read_text() != "of another run\n":
            wrong.append("results of another run have been replaced")
    for paragraph in wrong:
        print(paragraph + "\n")
    print(f"{len(cases)} inputs, {len(wrong)} answers are wrong.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
