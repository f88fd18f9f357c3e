# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The sections that are no runs of the spring slider."""

import pathlib
import subprocess
import tempfile

from common import page, programs
from common.store import Store

from . import large_slip_meshes, moving_meshes, shipped_meshes, verification
from .sections import PAGE


def verify(quick, _):
    """The figures of the tests, into the page; shown only if quick."""
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        text = verification.text(pathlib.Path(folder))
    if quick:
        print("\n" + text, flush=True)
    else:
        page.replace_section("verification", text, PAGE, "contrib/accuracy")


def hard(quick, _):
    """The table of hard cases; quick: what they are."""
    subprocess.run(
        [programs.PROJECT / "contrib/hard_cases"]
        + (["--list"] if quick else []),
        check=True,
    )


def moving(quick, folder):
    """How many vertices meshes would need that follow the fronts."""
    moving_meshes.measure(Store(folder), quick)


def shipped(quick, folder):
    """Meshes of the other shipped scenes beside those of the same error, and what
    events are worth on that of one of them."""
    shipped_meshes.measure(quick)
    large_slip_meshes.measure(Store(folder), quick)


SECTIONS = {"verification": verify, "hard": hard, "moving": moving, "shipped": shipped}
