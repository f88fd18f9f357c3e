# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Iterations of TNNMG over refinement levels, on level and on curved faults, and
over numbers of bodies."""

import pathlib

from common import page, programs

from . import measuring, scenes
from .scenes import STATES


# With the first one inertia prevails, with the second elasticity.
TAUS = ("1e-3", "1e-1")


def measure_states(section, mesh, states, records, timeout=300):
    """One run of the program for all states and step sizes."""
    chosen = {state: STATES[state] for state in states}
    try:
        rows = measuring.rate_rows(
            mesh, chosen, TAUS, ["--repetitions", 1], timeout=timeout
        )
        records += [measuring.rate_record(section, mesh, "TNNMG", row) for row in rows]
    except programs.Failed as reason:
        records += [
            measuring.failed_record(section, mesh, "TNNMG", state, tau, reason)
            for tau in TAUS
            for state in states
        ]


def state_tables(records, first_title, first_value):
    """A table for each step size."""
    for tau in TAUS:
        yield f"tau = {tau} s:\n"
        own = [r for r in records if float(r["tau"]) == float(tau)]
        yield state_table(own, first_title, first_value)


def state_table(records, first_title, first_value):
    """A row for each problem, iterations and cycles for each state."""
    states = list(dict.fromkeys(record["state"] for record in records))
    rows = []
    for name in dict.fromkeys(record["problem"] for record in records):
        own = {r["state"]: r for r in records if r["problem"] == name}
        first = next(iter(own.values()))
        rows.append(
            (
                first_value(first),
                page.thousands(first["unknowns"]) if first["unknowns"] else "–",
                *(
                    f"{own[s]['iterations']} / {own[s]['cycles']}"
                    if s in own and own[s]["iterations"]
                    else (own[s]["note"].split(":")[0] if s in own else "")
                    for s in states
                ),
                page.number(
                    max(
                        (
                            float(r["solve_s"]) / float(r["unknowns"]) * 1e6
                            for r in own.values()
                            if r["solve_s"]
                        ),
                        default="",
                    )
                ),
            )
        )
    return page.table((first_title, "unknowns", *states, "most µs an unknown"), rows)


class Levels:
    SECTION = "levels"
    MESHES = scenes.LEVELS
    TITLE = "cells of one size"

    @classmethod
    def measure(cls, quick, log):
        records = []
        for mesh in cls.MESHES[: 3 if quick else None]:
            measure_states(cls.SECTION, mesh, STATES, records)
            log(f"{mesh.name} measured")
        return records, None

    @classmethod
    def text(cls, records, _):
        return "\n".join(
            (
                f"Iterations / V-cycles, {cls.TITLE}:\n",
                *state_tables(
                    records,
                    "refinements",
                    lambda record: record["problem"].rsplit("-", 1)[1],
                ),
            )
        )


class Curved(Levels):
    SECTION = "curved"
    MESHES = scenes.CURVED
    TITLE = "curved fault, cells of one size"


class Bodies:
    SECTION = "bodies"
    NUMBERS = (2, 3, 5, 9, 17, 33)

    @staticmethod
    def measure(quick, log):
        records = []
        with programs.temporary_folder() as folder:
            for n in (3, 9) if quick else Bodies.NUMBERS:
                mesh = scenes.layered_scene(n, 1e5, pathlib.Path(folder))
                measure_states(Bodies.SECTION, mesh, STATES, records)
                log(f"{mesh.name} measured")
        return records, None

    @staticmethod
    def text(records, _):
        return "\n".join(
            (
                "Iterations / V-cycles, all faults in the same state:\n",
                *state_tables(records, "bodies", lambda record: record["bodies"]),
            )
        )
