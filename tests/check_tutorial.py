#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that what doc/tutorial.md says can be done.

Usage: check_tutorial.py PROJECT_DIRECTORY PROGRAM

The scenes of the page run for a moment, and its changes of the sources can be applied
where git is. Prints one line for each fault and returns 1 if there are any.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "contrib"))

from pictures import tutorial


def check(project, program):
    scenes, patches = tutorial.scenes(), tutorial.patches()
    if len(scenes) < 3 or len(patches) != 2:
        yield f"the page has the scenes {list(scenes)} and {len(patches)} changes"
    with tempfile.TemporaryDirectory(prefix="a folder ") as folder:
        folder = pathlib.Path(folder)
        for name in scenes:
            output = tutorial.run(program, folder, name, "--set", "Time/End time=0.1")
            if not (output / "summary.txt").is_file():
                yield f"{name}: there is no summary"
        if shutil.which("git") is None:
            return
        for number, patch in enumerate(patches, start=1):
            file = folder / "change.patch"
            file.write_text(patch, encoding="utf-8")
            result = subprocess.run(["git", "apply", "--check", file], cwd=project,
                                    capture_output=True, text=True)
            if result.returncode != 0:
                yield f"change {number}: {result.stderr.strip()}"


def main():
    project, program = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    problems = list(check(project, program))
    print("\n".join(problems) or "The tutorial can be followed.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
