#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Measure the beginnings of runs with both solvers of the rate problem.

Usage: contrib/rate_solvers [--program FILE] [--seconds S] [--tables]

Writes doc/data/rate_solvers.csv and the table between the marks in doc/performance.md.
Each scene runs for S seconds (default 3) of processor time behind its start with TNNMG,
then as many steps with condensed Newton, for six times as long at most; what counts are
the times of a step. Then the program is asked for its own choice. With --tables nothing
is measured; the table is written anew.
"""

import os
import pathlib
import re
import signal
import subprocess
import time

from common import csv_file, page, programs

PAGE = programs.PROJECT / "doc/performance.md"
DATA = programs.PROJECT / "doc/data/rate_solvers.csv"
COLUMNS = ("scene", "unknowns", "on_faults", "one_operator", "tnnmg_ms",
           "tnnmg_steps", "condensed_ms", "condensed_steps", "expected", "choice")
INVISCID = {f"Bodies/{body}/Material/{kind} viscosity": 0
            for body in ("lower", "upper") for kind in ("Shear", "Bulk")}


def refined(times):
    return {f"Bodies/{body}/Uniform refinements": times for body in ("lower", "upper")}


# Name in the table: parameter file and settings.
SCENES = {
    "`spring_slider`": ("spring_slider", {}),
    "`TNNMG/Tolerance = 1e-9`": ("spring_slider", {"TNNMG/Tolerance": 1e-9}),
    "quasi-dynamic, no viscosity":
        ("spring_slider", INVISCID | {"Time/Inertia": "quasi-dynamic"}),
    "`Uniform refinements = 1`": ("spring_slider", refined(1)),
    "`Uniform refinements = 2`": ("spring_slider", refined(2)),
    "`Mesh/Accuracy = 7.5e-3`": ("spring_slider", {"Mesh/Accuracy": 7.5e-3} | {
        f"Bodies/{body}/Refinement passes": 0 for body in ("lower", "upper")}),
} | {
    f"`{name}`": (name, {})
    for name in (
        "layered_five_bodies", "crossing_faults", "nine_body_stack",
        "weakening_patch", "curved_strike_slip", "first_on_earth",
        "slow_slip", "branching_fault", "crack", "rough_fault", "listric_thrust",
        "subduction_wedge", "large_slip", "lifted_patch", "lifted_corner",
        "opening_wave", "thrust_sequence")
} | {
    "`seas/bp1`, embedded control":
        ("seas/bp1", {"Time/Step size control": "embedded"}),
}
QUIET = {"Output/Write volume": "false", "Output/Write fault surfaces": "false",
         "Output/Energy balance": "false"}
CHOICE = re.compile(r"Rate solver: (TNNMG|condensed Newton), since (\d+) of (\d+)(.*)")


def cpu_time(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1]
    user, system = fields.split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


def steps_of(table):
    return table.read_bytes().count(b"\n") - 1 if table.is_file() else -1


def start(program, scene, settings, solver, folder):
    output = folder / solver.replace(" ", "_")
    settings = QUIET | settings | {"Time/Rate solver": solver,
                                   "Output/Output directory": output}
    # One core each, whatever the machine has.
    limits = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    return output / "time_series.csv", subprocess.Popen(
        [program, f"parameters/{scene}.prm", *programs.options(settings)],
        cwd=programs.PROJECT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, env=os.environ | limits)


def stop(process):
    """What has been printed."""
    if process.poll() is None:
        process.send_signal(signal.SIGKILL)
    return process.communicate()[0]


def time_of_step(program, scene, settings, solver, folder, seconds, most_steps):
    """Milliseconds, and the number of steps."""
    table, process = start(program, scene, settings, solver, folder)
    begin = now = n_steps = 0
    while process.poll() is None:
        time.sleep(0.01)
        now, n_steps = cpu_time(process), steps_of(table)
        if n_steps < 1:
            begin = now
        elif now - begin > seconds or n_steps >= most_steps:
            break
    stop(process)
    if n_steps < 2:
        raise SystemExit(f"{scene} with {solver} takes no steps.")
    return 1e3 * (now - begin) / n_steps, n_steps


def chosen(program, scene, settings, folder):
    """What the program says of its choice."""
    table, process = start(program, scene, settings, "automatic", folder)
    while process.poll() is None and steps_of(table) < 1:
        time.sleep(0.01)
    solver, on_faults, unknowns, rest = CHOICE.search(stop(process)).groups()
    expected = re.search(r"to take (\S+) of", rest)
    return {"choice": solver, "on_faults": on_faults, "unknowns": unknowns,
            "one_operator": "yes" if "one operator" in rest else "",
            "expected": expected.group(1) if expected else ""}


def measure(arguments):
    rows = []
    for name, (scene, settings) in SCENES.items():
        with programs.temporary_folder() as path:
            case = arguments.program, scene, settings
            folder = pathlib.Path(path)
            tnnmg, n_tnnmg = time_of_step(*case, "TNNMG", folder, arguments.seconds,
                                          float("inf"))
            condensed, n_condensed = time_of_step(
                *case, "condensed Newton", folder, 6 * arguments.seconds, n_tnnmg)
            rows.append({"scene": name, "tnnmg_ms": f"{tnnmg:.4g}",
                         "tnnmg_steps": n_tnnmg, "condensed_ms": f"{condensed:.4g}",
                         "condensed_steps": n_condensed}
                        | chosen(*case, folder))
        print(rows[-1], flush=True)
    return rows


def table(rows):
    lines = []
    for row in rows:
        ratio = float(row["condensed_ms"]) / float(row["tnnmg_ms"])
        lines.append([row["scene"], page.thousands(row["unknowns"]),
                      page.thousands(row["on_faults"]),
                      row["one_operator"] if row["expected"] else "–",
                      page.number(row["tnnmg_ms"]), page.number(row["condensed_ms"]),
                      f"{ratio:.2f}", row["expected"] or "–", row["choice"]])
    return page.table(["scene", "unknowns", "on faults", "one operator",
                       "TNNMG, ms a step", "condensed", "ratio", "expected",
                       "automatic"], lines)


def main():
    parser = programs.argument_parser(__doc__)
    parser.add_argument("--program", type=pathlib.Path, default=programs.PROGRAM)
    parser.add_argument("--seconds", type=float, default=3.)
    parser.add_argument("--tables", action="store_true")
    arguments = parser.parse_args()
    if not arguments.tables:
        csv_file.write(DATA, COLUMNS, measure(arguments))
    page.replace_section("rate solvers", table(csv_file.read(DATA)), PAGE,
                         "contrib/rate_solvers")


if __name__ == "__main__":
    main()
