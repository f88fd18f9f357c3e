#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Measure what each feature of the model costs, feature by feature.

Usage: contrib/feature_cost [--program FILE] [--rounds N] [--instructions | --tables]

Writes doc/data/feature_cost.csv and the tables between the marks in
doc/feature_cost.md. The spring slider is run with one feature changed at a time:

- on a mesh refined twice more, steps of one size; the CPU seconds for a step are
  those of a long run less those of a short one, over the steps between. All
  variants take turns, round after round, and of the rounds the median is taken,
  of ratios to the run before as well: other programs disturb both alike;
- on the published mesh to the end of the first event, with the default control.

All runs are on one core. CPU seconds are those spent in the program (user time); those
of the start are what is left of the short run without its steps. With --instructions
nothing of this is measured, but the instructions that valgrind (which must be there)
counts in the steps of the first kind and at the start: no other program disturbs them.
With --tables nothing is measured; the tables are written anew.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

from common import csv_file, page, programs, runs

SECTION = "feature cost"
PAGE = programs.PROJECT / "doc/feature_cost.md"
DATA = programs.PROJECT / "doc/data/feature_cost.csv"
COLUMNS = (
    "variant step_instructions start_instructions "
    "step_s ratio start_s hierarchy_MiB resident_MiB iterations cycles "
    "event_steps event_iterations event_cycles event_s event_start_s"
).split()

MATERIALS = [f"Bodies/{body}/Material" for body in ("lower", "upper")]
INVISCID = {
    f"{material}/{kind} viscosity": 0
    for material in MATERIALS
    for kind in ("Shear", "Bulk")
}
PRESSED = {
    "Faults/fault/Normal stress": "function",
    "Faults/fault/Normal stress function": 49050,
}
# Everything that is not asked for is as in the shipped scene.
VARIANTS = {
    "default: dynamic, viscous, gravity": {},
    "quasi-dynamic": {"Time/Inertia": "quasi-dynamic"},
    "quasi-static": {"Time/Inertia": "quasi-static"},
    "no viscosity": INVISCID,
    "quasi-dynamic, no viscosity": INVISCID | {"Time/Inertia": "quasi-dynamic"},
    "normal stress given": PRESSED,
    "normal stress given, no gravity": PRESSED | {"Gravity/Acceleration": 0},
    "contact stays (small slip)": {"Contact/Follow slip": "false"},
    "no balance of energy": {"Output/Energy balance": "false"},
    "no files of the bodies": {"Output/Write volume": "false"},
    "no files but events and summary": {
        "Output/Write volume": "false", "Output/Write faults": "false",
        "Output/Write fault surfaces": "false", "Output/Time series steps": 0,
    },
    "all fields in the files": {
        "Output/Fault fields": "slip, slip_rate, shear_traction, normal_stress, "
        "state, contact_pressure, contact_weight",
        "Output/Volume fields": "displacement, velocity, acceleration, stress, "
        "strain, body, material",
    },
    "a and b as expressions": {
        "Faults/fault/a": "0.010 + 0*x", "Faults/fault/b": "0.015 + 0*x",
    },
    "Young modulus as an expression": {
        f"{material}/Young modulus": "4.12e7 + 0*x" for material in MATERIALS
    },
    "a region with the same friction": {
        "Faults/fault/Regions/Names": "middle",
        "Faults/fault/Regions/middle/Where": "abs(x) < 1",
    },
    "fault that bends": {"Faults/fault/Elevation": "0.05*sin(2*pi*x/5)"},
    "normal stress follows": {"Faults/fault/Normal stress follows": "true"},
    "fault that may open (and does not)": {"Faults/fault/Contact": "unilateral"},
    "fault that is open over 2 of 5 m": {
        "Faults/fault/Contact": "unilateral",
        "Faults/fault/Initial gap": "if(abs(x) < 1, 0.01, 0)",
    },
    "lower body rigid": {
        "Bodies/lower/Rigid": "true", "Faults/fault/Normal stress": "lithostatic",
    },
    "velocity strengthening": {"Faults/fault/Friction": "velocity strengthening"},
    "Coulomb": {"Faults/fault/Friction": "Coulomb"},
    "frictionless": {"Faults/fault/Friction": "frictionless"},
    "welded": {"Faults/fault/Friction": "welded"},
    "prescribed slip rate": {
        "Faults/fault/Friction": "prescribed slip rate",
        "Faults/fault/Slip rate along x": 2e-4,
        "Faults/fault/Slip rate ramp length": 1,
    },
}
STEP, SHORT, LONG = 0.01, 20, 220
# Steps at the end of a run whose instructions are counted.
LONG_COUNTED = 70
REFINED = {
    f"Bodies/{body}/Uniform refinements": 2 for body in ("lower", "upper")
} | {"Time/Step size control": "constant", "Time/Largest step": STEP}


def command_line(program, settings, output):
    return [str(program), "parameters/spring_slider.prm"] + programs.options(
        settings | {"Output/Output directory": output}
    )


def run(program, settings, folder):
    """CPU seconds in the program, and what its summary says."""
    output = pathlib.Path(folder) / "run"
    # Programs of other revisions may not know --overwrite.
    shutil.rmtree(output, ignore_errors=True)
    command = command_line(program, settings, output)
    process = subprocess.Popen(
        command,
        cwd=programs.PROJECT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=os.environ | {"OMP_NUM_THREADS": "1"},
    )
    _, _, usage = os.wait4(process.pid, 0)
    return usage.ru_utime, runs.results(output)


def count_instructions(program, settings, n_steps):
    """Instructions of a run on the refined mesh."""
    with tempfile.TemporaryDirectory() as folder:
        command = command_line(
            program, REFINED | settings | {"Time/End time": n_steps * STEP}, folder
        )
        outcome = subprocess.run(
            ["valgrind", "--tool=cachegrind", "--cache-sim=no",
             "--cachegrind-out-file=/dev/null", *command],
            cwd=programs.PROJECT, capture_output=True, text=True, check=True,
            env=os.environ | {"OMP_NUM_THREADS": "1"},
        )
    return int(re.search(r"I +refs: +([\d,]+)", outcome.stderr)[1].replace(",", ""))


def measure_instructions(program, name):
    """Of a step, and of everything before the first one."""
    short, long = (
        count_instructions(program, VARIANTS[name], n) for n in (SHORT, LONG_COUNTED)
    )
    step = (long - short) / (LONG_COUNTED - SHORT)
    print(f"{name}: {step / 1e6:.2f} million instructions a step", flush=True)
    return {"step_instructions": step, "start_instructions": short - SHORT * step}


def figure(results, key):
    return float(results.get(key, "nan").split()[0])


def measure_steps(program, n_rounds):
    """One dictionary for each variant."""
    seconds = {name: [] for name in VARIANTS}
    starts = {name: [] for name in VARIANTS}
    rows = {name: {"variant": name} for name in VARIANTS}
    for _ in range(n_rounds):
        for name, settings in VARIANTS.items():
            used = {}
            for n in (SHORT, LONG):
                with tempfile.TemporaryDirectory() as folder:
                    used[n], results = run(
                        program,
                        REFINED | settings | {"Time/End time": n * STEP},
                        folder,
                    )
            seconds[name].append((used[LONG] - used[SHORT]) / (LONG - SHORT))
            starts[name].append(used[SHORT] - SHORT * seconds[name][-1])
            rows[name] |= {
                "hierarchy_MiB": figure(results, "Memory/level hierarchy"),
                "resident_MiB": figure(results, "Memory/largest resident size"),
                "iterations": figure(
                    results, "Iterations/TNNMG, per accepted step"
                ),
                "cycles": figure(
                    results, "Iterations/multigrid cycles, per accepted step"
                ),
            }
            print(f"{name}: {seconds[name][-1]:.4f} s a step", flush=True)
    first = next(iter(VARIANTS))
    for name, row in rows.items():
        row["step_s"] = statistics.median(seconds[name])
        row["start_s"] = statistics.median(starts[name])
        row["ratio"] = statistics.median(
            own / other for own, other in zip(seconds[name], seconds[first])
        )
    return rows


def measure_event(program, settings):
    with tempfile.TemporaryDirectory() as folder:
        used, results = run(program, settings | {"Time/End time": 23}, folder)
    starts = results["events"].get("fault", [])
    return {
        "event_steps": figure(results, "Steps/accepted"),
        "event_iterations": figure(results, "Iterations/TNNMG, all steps"),
        "event_cycles": figure(results, "Iterations/multigrid cycles, all steps"),
        "event_s": used,
        "event_start_s": starts[0] if starts else "",
    }


def tables(rows):
    steps = page.table(
        [
            "scene", "million instructions a step", "at the start", "CPU ms a step",
            "ratio", "start, CPU s", "levels, MiB", "whole program, MiB",
            "TNNMG iterations", "cycles",
        ],
        [
            [
                row["variant"],
                f"{float(row['step_instructions']) / 1e6:.2f}",
                f"{float(row['start_instructions']) / 1e6:,.0f}",
                f"{1e3 * float(row['step_s']):.1f}",
                f"{float(row['ratio']):.2f}",
                f"{float(row['start_s']):.2f}",
                f"{float(row['hierarchy_MiB']):.1f}",
                f"{float(row['resident_MiB']):.0f}",
                f"{float(row['iterations']):.2f}",
                f"{float(row['cycles']):.2f}",
            ]
            for row in rows
        ],
    )
    event = page.table(
        [
            "scene", "first event begins, s", "steps", "TNNMG iterations",
            "cycles", "CPU seconds",
        ],
        [
            [
                row["variant"],
                row["event_start_s"] and f"{float(row['event_start_s']):.4f}" or "–",
                f"{float(row['event_steps']):,.0f}",
                f"{float(row['event_iterations']):,.0f}",
                f"{float(row['event_cycles']):,.0f}",
                f"{float(row['event_s']):.1f}",
            ]
            for row in rows
        ],
    )
    return (
        f"Steps of {STEP:g} s while the fault sticks, mesh refined twice more:\n\n"
        f"{steps}\nPublished mesh, to t = 23 s:\n\n{event}"
    )


def measure_seconds(arguments):
    rows = measure_steps(arguments.program, arguments.rounds)
    for name, settings in VARIANTS.items():
        rows[name] |= measure_event(arguments.program, settings)
        print(f"{name}: {rows[name]['event_s']:.1f} s", flush=True)
    return rows


def measure_counts(arguments):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = pool.map(
            lambda name: measure_instructions(arguments.program, name), VARIANTS
        )
        return dict(zip(VARIANTS, counts, strict=True))


def keep(rows):
    """Write what was measured; what was not stays."""
    old = {row["variant"]: row for row in csv_file.read(DATA)}
    written = []
    for name in VARIANTS:
        row = {"variant": name} | old.get(name, {})
        row |= {column: page.rounded(value) for column, value in rows[name].items()}
        written.append({column: row.get(column, "nan") for column in COLUMNS})
    csv_file.write(DATA, COLUMNS, written)


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument(
        "--program", type=pathlib.Path, default=programs.PROGRAM
    )
    parser.add_argument("--rounds", type=int, default=4)
    only = parser.add_mutually_exclusive_group()
    only.add_argument("--instructions", action="store_true")
    only.add_argument("--tables", action="store_true")
    arguments = parser.parse_args()
    if arguments.instructions:
        keep(measure_counts(arguments))
    elif not arguments.tables:
        keep(measure_seconds(arguments))
    page.replace_section(
        SECTION, tables(csv_file.read(DATA)), PAGE, "contrib/feature_cost"
    )


if __name__ == "__main__":
    main()
