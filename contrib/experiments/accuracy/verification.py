# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The comparisons with solutions from elsewhere that are tests: their figures."""

import json
import subprocess

from common import page, programs

PROGRAM = programs.PROJECT / "build/tests/verification_tests"


def properties(folder):
    """What the tests record, by "suite.test"; fails if one of them does."""
    path = folder / "verification.json"
    subprocess.run(
        [PROGRAM, f"--gtest_output=json:{path}", "--gtest_brief=1"],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    return {
        f"{suite['name']}.{test['name']}": test
        for suite in json.loads(path.read_text())["testsuites"]
        for test in suite["testsuite"]
    }


def growth_rates(test):
    """A row for each record "law factor re im re im" of a test."""
    rows = []
    for _, record in sorted(
        (int(key.split()[1]), text)
        for key, text in test.items()
        if key.startswith("row ")
    ):
        law, factor, *numbers = record.split()
        exact, found = complex(*map(float, numbers[:2])), complex(
            *map(float, numbers[2:])
        )
        rows.append(
            [
                law,
                factor,
                f"{exact.real:.4g}",
                f"{found.real:.4g}",
                f"{100 * (found.real / exact.real - 1):.2f}",
                f"{exact.imag:.4g}",
                f"{found.imag:.4g}",
                f"{100 * (found.imag / exact.imag - 1):.2f}",
            ]
        )
    return page.table(
        [
            "law", "wave length over the critical one",
            "growth rate, 1/s", "found", "error, %",
            "frequency, 1/s", "found", "error, %",
        ],
        rows,
    )


def column(test):
    """The errors of the column, in a sentence."""
    shift = abs(float(test["shift of the event, s"]))
    slip_rate = float(test["largest relative error of the slip rate"])
    profile = float(test["largest relative error of the velocities of a profile"])
    return (
        f"In {test['steps']} steps the event begins {1e3 * shift:.2g} ms from that of "
        "the solution by characteristics. Counted from there, slip rates are within "
        f"{100 * slip_rate:.2g} % wherever they are above half of the loading rate, "
        "and the velocities of the waves on the whole height within "
        f"{100 * profile:.2g} %.\n"
    )


def text(folder):
    tests = properties(folder)
    return "\n".join(
        [
            "*Steady sliding, slow and with equal layers*\n",
            growth_rates(
                tests["SteadySliding.SlowGrowthOnBothSidesOfTheCriticalWaveLength"]
            ),
            "*Steady sliding, fast and with unequal viscous layers*\n",
            growth_rates(tests["SteadySliding.FastGrowthOfUnequalViscousLayers"]),
            "*Column*\n",
            column(tests["Column.LoadingEventAndRadiation"]),
        ]
    )
