#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the parameter reference is what the program declares.

Usage: check_parameter_reference.py PROGRAM REFERENCE

Compares the output of `PROGRAM --parameter-reference` with the file, prints
the differences, and returns 1 if there are any.
"""

import difflib
import pathlib
import subprocess
import sys


def main():
    program, reference = sys.argv[1:3]
    run = subprocess.run(
        [program, "--parameter-reference"], capture_output=True, text=True
    )
    if run.returncode != 0 or not run.stdout.strip():
        print(f"{program} --parameter-reference: status {run.returncode}")
        print(run.stdout + run.stderr)
        return 1
    path = pathlib.Path(reference)
    written = path.read_text(encoding="utf-8") if path.is_file() else ""
    if written == run.stdout:
        return 0
    sys.stdout.writelines(
        difflib.unified_diff(
            written.splitlines(keepends=True),
            run.stdout.splitlines(keepends=True),
            reference,
            "what the program declares",
        )
    )
    print(f"\nTo update it: build/stickslip --parameter-reference > {reference}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
