# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Stations of runs, drawn, and beside those of other programs."""

import pathlib

import numpy as np

from common import figures
from experiments.seas.benchmarks import YEAR

REFERENCES = pathlib.Path(__file__).parent / "references"
# Stations that are drawn, by the beginning of the scene's name.
DRAWN = {"bp1": ("fltst_dp000", "fltst_dp075", "fltst_dp125"),
         "bp2": ("fltst_dp000", "fltst_dp072", "fltst_dp120"),
         "bp3": ("fltst_dp000", "fltst_dp075", "fltst_dp125"),
         "bp5": ("fltst_strk-24dp10", "fltst_strk00dp10", "fltst_strk16dp10")}
COLOURS = (figures.BLUE, figures.VERMILION, figures.GREEN)


def read(path):
    """The columns of a station file by their titles."""
    with open(path) as file:
        lines = [line for line in file if not line.startswith("#")]
    return np.genfromtxt(lines, names=True, invalid_raise=False)


def direction(stress):
    """The sign of the slip, by that of the stress that drives it: bodies may be either
    way around."""
    return np.sign(np.mean(stress))


def reference(name, station):
    """Time, s, slip, m, and stresses, MPa, of another program, or nothing."""
    path = REFERENCES / f"{name}_{station}.csv"
    if not path.exists():
        return None
    with open(path) as file:
        lines = [line for line in file if not line.startswith("#")]
    table = np.genfromtxt(lines, names=True, delimiter=",")
    sign = direction(table["shear_stress_MPa"])
    return {"time": table["time_s"], "slip": sign * table["slip_m"],
            "shear_stress": sign * table["shear_stress_MPa"],
            "normal_stress": table["normal_stress_MPa"]}


def stress_along_slip(table):
    """In three dimensions that along strike."""
    return table["shear_stress" if "shear_stress" in table.dtype.names
                 else "shear_stress_2"]


def draw(axes, name, folder):
    """Shear stresses over time, those of another program dashed."""
    for station, colour in zip(DRAWN[name.split("_")[0]], COLOURS):
        table = read(folder / "stations" / f"{station}.dat")
        stress = stress_along_slip(table)
        axes.plot(table["t"] / YEAR, direction(stress) * stress, lw=0.7, color=colour,
                  label=station)
        other = reference(name, station)
        if other:
            axes.plot(other["time"] / YEAR, other["shear_stress"], "--", lw=0.8,
                      color=figures.BLACK, label=f"{station}, FDRA")
    axes.legend(loc="lower left", bbox_to_anchor=(0., 1.), ncols=5)
    axes.set(xlabel="time [yr]", ylabel="shear stress\n[MPa]")


def show(name, folder, starts, others):
    """Values halfway between events, of runs and of another program, whose events come
    at another time (starts, s; others, yr)."""
    for station in DRAWN[name.split("_")[0]]:
        other = reference(name, station)
        if not other:
            continue
        table = read(folder / "stations" / f"{station}.dat")
        print(f"\n{station} halfway to the event, here and by FDRA:\nevent   slip, m"
              "             shear stress, MPa   normal stress, MPa")
        here, there = np.r_[0., starts], np.r_[0., np.array(others) * YEAR]
        sign = direction(table["shear_stress"])
        for i in range(1, min(len(here), len(there))):
            line = f"{i:5d}"
            for field, factor in (("slip", sign), ("shear_stress", sign),
                                  ("normal_stress", 1.)):
                value = np.interp(here[i - 1:i + 1].mean(), table["t"], table[field])
                value_there = np.interp(there[i - 1:i + 1].mean(), other["time"],
                                        other[field])
                line += f"   {factor * value:8.3f} {value_there:8.3f}"
            print(line)
