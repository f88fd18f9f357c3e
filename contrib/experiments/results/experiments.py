# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The published experiments, and what is changed in them to learn more."""

import dataclasses

from common.store import Case

SLIDER = "parameters/spring_slider.prm"
LAYERED = "parameters/layered_five_bodies.prm"
# Counted from below, as published.
FAULTS = {SLIDER: ("fault",), LAYERED: ("fault1", "fault2", "fault3", "fault4")}
BODIES = {SLIDER: ("lower", "upper"),
          LAYERED: ("bottom", "lower", "core", "upper", "top")}
# Records dense enough for the waves on faults that hardly slip, which the largest
# slip rate of all faults says nothing about.
OUTPUT = {"Output/Write volume": "false", "Output/Fault longest interval": "0.02"}
# Two multigrid cycles in each correction of all runs.
SOLVER = {"TNNMG/Single-cycle corrections": "0", "TNNMG/Tolerance": "1e-7"}
PUBLISHED_CONTROL = {
    "Time/Step size control": "step doubling",
    "Time/State update": "implicit Euler",
    "Time/Rate-state method": "nested",
}


@dataclasses.dataclass(frozen=True)
class Experiment(Case):
    """A run of a published experiment, with its end in s."""

    end_time: float = 60.0

    def all_settings(self):
        return {
            **OUTPUT, **SOLVER, "Time/End time": f"{self.end_time:g}",
            **dict(self.settings),
        }

    def faults(self):
        return FAULTS[self.scene]

    def top_fault(self):
        return self.faults()[-1]


def of_all_bodies(scene, entry, value):
    return {f"Bodies/{body}/{entry}": value for body in BODIES[scene]}


def of_inner_faults(entry, value):
    """Of all but the uppermost one."""
    return {f"Faults/{fault}/{entry}": value for fault in FAULTS[LAYERED][:-1]}


def layered(title, settings, end_time):
    return Experiment(
        title, LAYERED, tuple(sorted(settings.items())), end_time=end_time
    )


# s: after the first four events of the top fault.
VARIED_END = 40.0

PUBLISHED = {
    "slider_default": Experiment("spring slider, default settings", SLIDER),
    "layered_default": Experiment("five bodies, default settings", LAYERED),
    "slider_published": Experiment(
        "spring slider, published settings", SLIDER,
        tuple(sorted(PUBLISHED_CONTROL.items())),
    ),
    "layered_published": Experiment(
        "five bodies, published settings", LAYERED,
        tuple(sorted(PUBLISHED_CONTROL.items())),
    ),
}
VARIED = {
    "tolerance": layered("tolerance 1.3e-7", {"Time/Tolerance": "1.3e-7"}, VARIED_END),
    "fine": layered(
        "all cells halved", of_all_bodies(LAYERED, "Uniform refinements", "1"),
        VARIED_END,
    ),
    "light": layered(
        "density / 100, gravity x 100",
        of_all_bodies(LAYERED, "Material/Density", "50")
        | {"Gravity/Acceleration": "981"},
        VARIED_END,
    ),
    "quasi_dynamic": layered(
        "quasi-dynamic", {"Time/Inertia": "quasi-dynamic"}, VARIED_END
    ),
    "quasi_static": layered(
        "quasi-static", {"Time/Inertia": "quasi-static"}, VARIED_END
    ),
    "no_viscosity": layered(
        "viscosity 0",
        of_all_bodies(LAYERED, "Material/Shear viscosity", "0")
        | of_all_bodies(LAYERED, "Material/Bulk viscosity", "0"),
        VARIED_END,
    ),
    "viscous": layered(
        "viscosity 1e5 Pa s",
        of_all_bodies(LAYERED, "Material/Shear viscosity", "1e5")
        | of_all_bodies(LAYERED, "Material/Bulk viscosity", "1e5"),
        VARIED_END,
    ),
    "welded": layered(
        "mu0 = 2 on the three lower faults",
        of_inner_faults("Reference friction coefficient", "2"), VARIED_END,
    ),
}
