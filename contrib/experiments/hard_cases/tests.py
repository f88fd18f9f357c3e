# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Hard cases that no scene can state, and tests do."""

import json
import subprocess

from common.programs import PROJECT

PROGRAM = PROJECT / "build/tests/tnnmg_tests"
STARTS = "starting velocities: from zero, and 1e10 times too fast"


def wrong_starts(folder):
    """Single rate problems from right and wrong starting values, beside the
    condensed Newton method."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "tests.json"
    name = "Corrections.CondensedSolverFindsTheSameSolution"
    process = subprocess.run(
        [PROGRAM, f"--gtest_filter={name}", f"--gtest_output=json:{path}"],
        stdout=subprocess.DEVNULL,
    )
    test = json.loads(path.read_text())["testsuites"][0]["testsuite"][0]
    return {
        "case": STARTS,
        "holds": "no" if process.returncode else "yes",
        "steps": "",
        "iterations": test["most iterations"],
        "error": f"{float(test['largest distance']):.0e}",
        "note": "most iterations and largest error of rate problems with a tolerance "
        "of 1e-11: stuck, slipping, both, and with states 8 decades apart at "
        "neighbouring nodes; tau from 1e-5 to 0.1 s; reference: condensed Newton; "
        "tests/tnnmg_corrections_test.cc",
    }


ROWS = {STARTS: wrong_starts}
