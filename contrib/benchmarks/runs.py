# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Whole runs of the program."""

import pathlib
import re
import signal
import subprocess
import time

from common import page, programs, runs

from . import measuring, scenes

SECTION = "runs"
PUBLISHED = {
    "Time/Step size control": "step doubling",
    "Time/State update": "implicit Euler",
}
# Title, scene, overrides.
ALONE = [("spring slider, default control", "spring_slider", {})]
TOGETHER = [
    ("spring slider, published control", "spring_slider", PUBLISHED),
    ("five layers, default control", "layered_five_bodies", {}),
]
LONGEST = 720


def start(run, folder, end_time):
    """Start the program; returns what is needed to wait for it."""
    title, scene, overrides = run
    output = pathlib.Path(folder) / re.sub(r"\W+", "_", title)
    command = [str(programs.PROGRAM), f"parameters/{scene}.prm", "--overwrite"]
    settings = overrides | {"Output/Output directory": output}
    if end_time:
        settings |= {"Time/End time": end_time}
    process = subprocess.Popen(
        command + programs.options(settings),
        cwd=programs.PROJECT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    return title, output, process, time.monotonic()


def finish(started):
    """Wait for a run; one that takes too long is interrupted, and says so."""
    title, output, process, begin = started
    try:
        process.wait(max(1.0, LONGEST - (time.monotonic() - begin)))
    except subprocess.TimeoutExpired:
        # The program ends after its time step, with complete files.
        process.send_signal(signal.SIGINT)
        try:
            process.wait(30)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
    run = {"title": title} | runs.results(output)
    # Others may have been waited for.
    run["wall_s"] = sum(
        float(value.split()[0])
        for name, value in run.items()
        if name.startswith("Wall time/")
    )
    return run


def measure(quick, log):
    end_time = "5" if quick else None
    done = []
    with programs.temporary_folder() as folder:
        for run in ALONE:
            done.append(finish(start(run, folder, end_time)))
            log(f"{run[0]}: {done[-1]['wall_s']:.0f} s")
        if not quick:
            # They do not compete for a core, and would take too long in turn.
            for started in [start(run, folder, end_time) for run in TOGETHER]:
                done.append(finish(started))
                log(f"{done[-1]['title']}: {done[-1]['wall_s']:.0f} s")
    return [record(run) for run in done], done


def record(run):
    """A row of the table of all results; the time is that of the whole run."""

    def entry(name):
        return run.get(name, "").split(" ")[0]

    vertices = entry("Mesh of all bodies/vertices")
    bodies = sum(name.endswith("/vertices") for name in run) - 1
    return measuring.make_record(
        SECTION,
        scenes.Mesh(run["title"], "", {}, bodies=bodies),
        "",
        "",
        "TNNMG",
        unknowns=2 * int(vertices) if vertices else "",
        iterations=entry("Iterations/TNNMG, all steps"),
        cycles=entry("Iterations/multigrid cycles, all steps"),
        solve_s=run["wall_s"],
        note=f"to t = {entry('Run/simulated time')} s",
    )


def first_events(run):
    if not run["events"]:
        return "none"
    return "; ".join(
        (f"{fault}: " if len(run["events"]) > 1 else "")
        + ", ".join(f"{start:.3f}" for start in starts[:3])
        for fault, starts in run["events"].items()
    )


def text(_, done):
    def entry(run, name, form="{:,.0f}"):
        value = run.get(name)
        return form.format(float(value.split()[0])) if value else "–"

    return page.table(
        (
            "run",
            "vertices",
            "simulated, s",
            "wall, s",
            "steps accepted",
            "rejected",
            "TNNMG iterations",
            "in an accepted step",
            "cycles",
            "in an accepted step",
            "ms a solved step",
            "events",
            "first events, s",
        ),
        [
            (
                run["title"],
                entry(run, "Mesh of all bodies/vertices"),
                entry(run, "Run/simulated time", "{:.4g}"),
                f"{run['wall_s']:.0f}",
                entry(run, "Steps/accepted"),
                entry(run, "Steps/rejected"),
                entry(run, "Iterations/TNNMG, all steps"),
                entry(run, "Iterations/TNNMG, per accepted step", "{:.2f}"),
                entry(run, "Iterations/multigrid cycles, all steps"),
                entry(
                    run, "Iterations/multigrid cycles, per accepted step", "{:.1f}"
                ),
                f"{run['wall_s'] * 1e3 / float(run['Steps/solved']):.2f}"
                if run.get("Steps/solved")
                else "–",
                ", ".join(
                    f"{len(starts)}"
                    + (f" ({fault})" if len(run["events"]) > 1 else "")
                    for fault, starts in run["events"].items()
                )
                or "0",
                first_events(run),
            )
            for run in done
        ],
    )
