# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Events of `large_slip` on its mesh and on that of the program's choice with the same
error of the energy, beside a finer one."""

import numpy as np

from common import page, programs
from common.store import Case

from .cases import bodies
from .mesh_search import ENTRY

PAGE = programs.PROJECT / "doc/meshes.md"
SCENE = "parameters/large_slip.prm"
# s: after more than twenty events, and how many of them are compared.
END, EVENTS = 30.0, 20
MESHES = (
    ("the scene's", {}),
    *((f"accuracy {value}", {ENTRY: value} | bodies(Refinement_passes=0))
      for value in ("1.35e-2", "1.3e-2")),
    ("all cells halved", bodies(Uniform_refinements=1)),
)


def case(title, settings):
    output = {"Output/Write volume": "false", "Time/End time": f"{END:g}"}
    return Case(f"large_slip, {title}", SCENE, tuple(sorted((settings | output).items())))


def measure(store, quick):
    runs = [store.run(case(title, settings)) for title, settings in MESHES]
    starts = [run.events("fault")["start"][:EVENTS] for run in runs]
    interval = np.diff(starts[-1]).mean()
    rows = []
    for (title, _), run, times in zip(MESHES, runs, starts):
        error = np.sqrt(np.mean((times - starts[-1]) ** 2))
        is_reference = run is runs[-1]
        rows.append([
            title, f"{run.summary_number('Mesh of all bodies/vertices'):,.0f}",
            f"{run.cpu_seconds:.0f}",
            *("–" if is_reference else page.number(f * error)
              for f in (1e3, 100 / interval)),
        ])
    text = page.table(
        ["mesh of `large_slip`", "vertices", "CPU, s", f"{len(starts[-1])} events, rms, ms",
         "rms, % of an interval"], rows)
    if quick:
        print("\n" + text, flush=True)
    else:
        page.replace_section("large slip", text, PAGE, "contrib/accuracy")
