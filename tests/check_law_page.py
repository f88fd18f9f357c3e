#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the law and the tests of doc/adding_a_law.md are those that are run.

Usage: check_law_page.py PAGE TEST

Each block of C++ of the page that defines a class or a test must stand in the
test, line by line, whatever the indentation. Returns 1 if one does not.
"""

import pathlib
import re
import sys


def stripped(text):
    """The lines of a text without indentation, empty ones left out."""
    return [line.strip() for line in text.splitlines() if line.strip()]


def main():
    page, test = (pathlib.Path(name).read_text(encoding="utf-8")
                  for name in sys.argv[1:3])
    blocks = [
        block for block in re.findall(r"```c\+\+\n(.*?)```", page, re.DOTALL)
        if re.search(r"^ *(class|TEST)\b", block, re.MULTILINE)
    ]
    if len(blocks) < 2:
        print("The page has fewer than two blocks with a class or a test.")
        return 1
    whole = "\n".join(stripped(test))
    status = 0
    for block in blocks:
        if "\n".join(stripped(block)) not in whole:
            print("This block of the page is not in the test:\n" + block)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
