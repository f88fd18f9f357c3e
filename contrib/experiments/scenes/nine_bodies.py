# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene nine_body_stack.prm: its events, and iterations over the number of bodies.

The scene is written here for any number of bodies; with nine it is the shipped file.
"""

import dataclasses

import numpy as np

from common import page, programs
from common.figures import (
    draw_map, new_figure, title,
)
from experiments.results.history import FaultHistory

from . import cases

SCENE = "nine_body_stack"
BODIES = 9
OTHERS = (2, 5)
# s
AFTER_LOADING = 41
HEAD = """\
# Nine bodies and eight faults: seven thin layers between two thick ones, without
# ends. The top side drags the stack along. Each fault strengthens with the slip
# rate and creeps, but for one patch of 1.2 m, farther to the right from fault to
# fault. The patches weaken the more the higher they lie, b - a = 0.002 at fault1 to
# 0.016 at fault8. All faults carry the same normal stress.
"""
FEWER = "# The uppermost {} of the nine bodies of nine_body_stack.prm.\n"
BODY = """
  subsection {name}
    set Lower lateral corner = -5
    set Upper lateral corner = 5
    set Thickness            = {thickness}
    set Coarse cells         = {cells}
    set Refinement passes    = {passes}
    subsection Material
      set Young modulus = 4.12e7
      set Poisson ratio = 0.3
      set Density       = 5e3
    end
  end
"""
FAULT = """
  subsection {name}
    set a                              = 0.010
    set b                              = 0.004 + {extra:.3f} * (0.5 - 0.5 * \
tanh((abs(x {sign} {place:.1f}) - 0.6) / 0.05))
    set Reference friction coefficient = 0.6
    set Reference slip rate            = 1e-6
    set Characteristic slip            = 1.5e-5
    set Normal stress                  = function
    set Normal stress function         = 5e4
  end
"""
TAIL = """
subsection Boundary conditions
  set Sides            = bottom bottom, top top
  set Periodic along x = true
  subsection bottom bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection top top
    set x condition = velocity
    set x value     = {rate}
    set y condition = fixed
    set Ramp length = 1
  end
end

subsection Gravity
  set Acceleration = 0
end

subsection Time
  set Inertia  = quasi-dynamic
  set End time = {end}
end

subsection Output
  # Four times the mean slip rate of a fault.
  set Event start slip rate   = 1e-4
  set Volume longest interval = 15
end
"""


def layer_names(n_bodies):
    inner = [f"layer{k}" for k in range(BODIES - n_bodies + 2, BODIES)]
    return ["bottom", *inner, "top"]


def fault_numbers(n_bodies):
    return range(BODIES - n_bodies + 1, BODIES)


def body(name):
    thick = name in ("bottom", "top")
    return BODY.format(
        name=name, thickness="1" if thick else "0.3",
        cells="20, 2" if thick else "32, 1", passes=3 if thick else 2,
    )


def fault(number):
    place = -4.2 + 1.2 * (number - 1)
    return FAULT.format(
        name=f"fault{number}", extra=0.008 + 0.002 * (number - 1),
        sign="+" if place < 0 else "-", place=abs(place),
    )


def scene_text(n_bodies):
    """A stack of the uppermost bodies, on the thick one at the bottom. The loading rate
    for each fault is that of nine bodies."""
    names = layer_names(n_bodies)
    faults = fault_numbers(n_bodies)
    rate = 2e-4 * len(faults) / (BODIES - 1)
    # s: the time in which the shear stress comes to the strength, and as long after it
    # as with nine bodies.
    thickness = 2 + 0.3 * (n_bodies - 2)
    end = round(0.6 * 5e4 * thickness / (1.585e7 * rate)) + AFTER_LOADING
    return (
        (HEAD if n_bodies == BODIES else FEWER.format(n_bodies))
        + "\nsubsection Bodies\n  set Names          = " + ", ".join(names)
        + "\n  set Base elevation = -1\n" + "".join(body(name) for name in names)
        + "end\n\nsubsection Faults\n  set Names = "
        + ", ".join(f"fault{k}" for k in faults) + "\n"
        + "".join(fault(k) for k in faults) + "end\n"
        + TAIL.format(rate=f"{rate:.4g}".replace("0.0002", "2e-4"), end=end)
    )


def write_fewer(store, n_bodies):
    """The file of a stack of fewer bodies, kept with the runs."""
    path = store.folder.resolve() / f"stack_of_{n_bodies}.prm"
    path.write_text(scene_text(n_bodies), encoding="utf-8")
    return path


def run_stack(store, n_bodies):
    if n_bodies == BODIES:
        return store.run(cases.case("nine bodies", SCENE))
    case = cases.case(
        f"{n_bodies} bodies", SCENE, {"Output/Write volume": "false"})
    return store.run(
        dataclasses.replace(case, scene=str(write_fewer(store, n_bodies))))


def iteration_cells(run, faults):
    """Steps, unknowns and iterations, in all and where a fault slips fast."""
    series = run.series()
    fastest = np.max(
        [series[f"fault{k}.max_slip_rate"] for k in faults], axis=0)
    iterations, cycles = series["tnnmg_iterations"], series["multigrid_cycles"]
    fast = fastest > 1e-3
    return (
        f"{run.summary_number('Unknowns/not fixed'):,.0f}", f"{len(iterations):,}",
        f"{run.summary_number('Steps/rejected'):.0f}",
        f"{iterations.mean():.2f}", f"{iterations.max():.0f}", f"{cycles.mean():.2f}",
        f"{cycles.max():.0f}",
        f"{iterations[fast].mean():.2f}" if fast.any() else "–",
        f"{run.cpu_seconds:.0f}",
        f"{1e6 * run.cpu_seconds / len(iterations) / run.summary_number('Unknowns/not fixed'):.2f}",
    )


def event_rows(run):
    rows = []
    for k in fault_numbers(BODIES):
        name = f"fault{k}"
        events, series = run.events(name), run.series()
        count = len(events["start"])
        rows.append((
            name, f"{0.002 * k:.3f}", count,
            f"{events['start'][0]:.2f}" if count else "–",
            f"{np.median(np.diff(events['start'])):.2f}" if count > 2 else "–",
            f"{events['peak_slip_rate'].max():.2g}" if count else "–",
            f"{np.median(events['peak_slip_rate']):.2g}" if count else "–",
            f"{series[f'{name}.max_slip_rate'][series['time'] > 60].max():.2g}",
            f"{1e3 * series[f'{name}.mean_slip'][-1]:.2f}",
        ))
    return page.table(
        ("fault", "b - a of the patch", "events", "first, s", "median interval, s",
         "largest slip rate, m/s", "median of events", "largest after 60 s",
         "mean slip at the end, mm"), rows)


def outcome(store):
    shipped = programs.PROJECT / cases.PARAMETERS / f"{SCENE}.prm"
    if shipped.read_text(encoding="utf-8") != scene_text(BODIES):
        raise programs.Failed(f"{shipped} is not what contrib/experiments/scenes/nine_bodies.py writes.")
    runs = {n: run_stack(store, n) for n in (*OTHERS, BODIES)}
    rows = [
        (f"stack of {n}", n - 1, *iteration_cells(run, fault_numbers(n)))
        for n, run in runs.items()
    ]
    text = page.table(
        ("scene", "faults", "unknowns", "steps", "rejected", "iterations a step",
         "most", "cycles a step", "most", "iterations above 1 mm/s", "CPU seconds",
         "µs a step and unknown"), rows)
    text += "\n" + event_rows(runs[BODIES])
    return cases.Outcome(text, {"nine_body_stack": lambda: draw(runs[BODIES])})


def draw(run):
    figure, axes = new_figure(9, height=13.0, ratios=(1,) * 8 + (0.9,), sharex=True)
    for panel, k in zip(axes, reversed(fault_numbers(BODIES))):
        history = FaultHistory(run.history(), f"fault{k}")
        draw_map(figure, panel, history, (36, 80), (1e-8, 5e-2))
        panel.set(xlabel="", ylabel="x [m]")
        title(panel, f"fault{k}, b - a = {0.002 * k:.3f} in its patch")
    series = run.series()
    axes[8].plot(series["time"], series["tnnmg_iterations"], ".", markersize=1.5,
                 rasterized=True)
    axes[8].set(xlabel="time [s]", ylim=(0, 8), xlim=(36, 80))
    title(axes[8], "TNNMG iterations in each step")
    return figure
