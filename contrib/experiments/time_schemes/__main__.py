#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Compare time schemes for contact by a bar that hits a rigid wall.

Usage: contrib/time_schemes [--quick | --check]

Writes the two tables of doc/opening.md and doc/data/time_schemes.csv: what energy is
lost, how much the pressure swings, and the error of the displacement, beside the
exact solution. With --quick prints them, of fewer elements and phases. With --check
the status is 1 unless the exact solution solves the equations and the program's scheme
keeps what is said of it there. Takes half a minute; needs nothing but numpy.
"""

import sys

import numpy as np

from common import csv_file, page
from common.programs import PROJECT

from .bar import Bar, Elements
from .schemes import SCHEMES, Projected

PAGE = PROJECT / "doc/opening.md"
DATA = PROJECT / "doc/data/time_schemes.csv"
COMMAND = "contrib/time_schemes"
COURANT = (0.5, 2, 8)
COLUMNS = ("scheme elements courant phases energy_lost largest_energy_lost"
           " largest_energy pressure_rms displacement_error").split()


def run(scheme, n, courant, phase):
    """Energy lost in the end and the largest energy, over the first one; root mean
    square of the error of the pressure in the middle half of the contact, over the
    exact pressure; largest error of the displacement at any time, root mean square
    over the bar, over that by which waves shorten it. The bar touches at this part
    of a step."""
    tau = courant / n
    bar = Bar(gap=(max(4, np.ceil(0.25 / tau)) + phase) * tau)
    elements = Elements(bar, n)
    stepping = scheme(elements, tau)
    energy = getattr(stepping, "energy", elements.energy)
    u, v = (values.copy() for values in elements.start)
    energies, pressures, errors = [energy(u, v)], [], []
    times = tau * np.arange(1, np.ceil((2 * bar.impact + bar.duration) / tau) + 1)
    for t in times:
        u, v, pressure = stepping.step(u, v)
        energies.append(energy(u, v))
        pressures.append(pressure)
        errors.append(np.sqrt(np.mean((u - bar.displacement(elements.x, t)) ** 2)))
    middle = np.abs(times - bar.impact - bar.duration / 2) < bar.duration / 4
    exact = bar.pressure(times)[middle]
    defect = np.array(pressures)[middle] - exact
    return (1 - energies[-1] / energies[0], max(energies) / energies[0],
            np.sqrt(np.mean(defect**2)) / exact[0],
            max(errors) * bar.wave_speed / (bar.speed * bar.length))


def measure(scheme, n, courant, n_phases):
    """The row of a scheme: means over as many phases of the first contact."""
    values = np.array([run(scheme, n, courant, (k + 0.5) / n_phases)
                       for k in range(n_phases)])
    lost, largest, pressure, error = values.mean(axis=0)
    return dict(zip(COLUMNS, (
        scheme.name.strip("*"), n, courant, n_phases, f"{lost:.3g}",
        f"{values[:, 0].max():.3g}", f"{values[:, 1].max():.3g}", f"{pressure:.3g}",
        f"{error:.3g}")))


def triple(rows, column):
    return " / ".join(page.number(row[column], 1 if "rms" in column else 2)
                      for row in rows)


def energy_cell(rows):
    return " / ".join(
        f"**grows to {float(row['largest_energy']):.2g}**"
        if float(row["largest_energy"]) > 1.1 else page.number(row["energy_lost"])
        for row in rows)


def schemes_table(rows):
    lines = []
    for scheme in SCHEMES:
        own = [row for row in rows if row["scheme"] == scheme.name.strip("*")]
        lines.append((scheme.name, energy_cell(own), triple(own, "pressure_rms"),
                      triple(own, "displacement_error")))
    return page.table(
        ("scheme", "energy lost", "pressure", "displacement"), lines)


def refinement_table(rows):
    titles = ("elements", "energy lost, over h / L", "most of any phase, over h / L",
              "pressure", "displacement")
    return page.table(titles, [
        (row["elements"], page.number(float(row["energy_lost"]) * row["elements"]),
         page.number(float(row["largest_energy_lost"]) * row["elements"]),
         page.number(row["pressure_rms"], 1), page.number(row["displacement_error"]))
        for row in rows])


def check():
    """What does not hold of what is said in the page."""
    bar = Bar(length=2.0, modulus=3.0, density=0.7, speed=1.3, gap=0.4)
    end = bar.impact + bar.duration
    x, d = np.linspace(0.01, bar.length - 0.01, 41), 1e-4
    for t in np.linspace(0.01, 2 * end, 77):
        slope = (bar.displacement(x, t + d) - bar.displacement(x, t - d)) / (2 * d)
        smooth = bar.velocity(x, t + d) == bar.velocity(x, t - d)
        if np.abs(slope - bar.velocity(x, t))[smooth].max() > 1e-9:
            yield "the velocity is not the rate of the displacement"
        strain = (bar.displacement(x + d, t) - bar.displacement(x - d, t)) / (2 * d)
        energy = np.mean(bar.density * bar.velocity(x, t) ** 2
                         + bar.modulus * strain**2) * bar.length / 2
        if abs(energy / bar.energy - 1) > 0.05:
            yield f"the energy of the exact solution changes: {energy / bar.energy}"
        momentum = bar.density * bar.length * np.mean(bar.velocity(x, t))
        elapsed = np.clip(t - bar.impact, 0, bar.duration)
        impulse = elapsed * bar.density * bar.wave_speed * bar.speed
        start = -bar.density * bar.length * bar.speed
        if abs(momentum - start - impulse) > 0.05 * abs(start):
            yield "the pressure is not the rate of the momentum"
        inside = bar.displacement(np.zeros(1), t)[0] + bar.gap
        if inside < -1e-12 or (bar.pressure(t) > 0 and inside > 1e-12):
            yield "the bar and its wall contradict each other"
    n = 64
    row = measure(Projected, n, 0.5, 4)
    if not 0.2 < float(row["energy_lost"]) * n < 0.5:
        yield f"energy lost: {row['energy_lost']}"
    if float(row["largest_energy"]) > 1 + 1e-12:
        yield "energy is gained"
    if float(row["pressure_rms"]) > 1e-3:
        yield f"pressure: {row['pressure_rms']}"
    # The step begins at closure: the projection takes the energy of one node, whose
    # share of the consistent mass is h / (2 sqrt(3)).
    for courant in COURANT:
        lost = run(Projected, n, courant, 0.0)[0] * n
        if abs(lost - 1 / np.sqrt(12)) > 0.02:
            yield f"energy lost at closure: {lost} h / L"


def main():
    arguments = sys.argv[1:]
    if arguments == ["--check"]:
        problems = list(check())
        print("\n".join(problems) or "All checks hold.")
        return 1 if problems else 0
    if arguments not in ([], ["--quick"]):
        print(__doc__.strip())
        return 0 if arguments in (["-h"], ["--help"]) else 2
    n, phases = (32, 2) if arguments else (128, 8)
    rows = [measure(scheme, n, courant, phases)
            for scheme in SCHEMES for courant in COURANT]
    finer = [measure(Projected, m, 0.5, phases)
             for m in (16, 32, 64, 128) + (() if arguments else (256,))]
    tables = {"schemes": schemes_table(rows), "refinement": refinement_table(finer)}
    for section, text in tables.items():
        print(text)
        if not arguments:
            page.replace_section(section, text, PAGE, COMMAND)
    if not arguments:
        unique = {(row["scheme"], row["elements"], row["courant"]): row
                  for row in rows + finer}
        csv_file.write(DATA, COLUMNS, list(unique.values()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
