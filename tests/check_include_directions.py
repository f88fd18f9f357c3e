#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the modules of stickslip depend on each other only downwards.

Usage: check_include_directions.py PROJECT_DIRECTORY

Reads the #include lines of include/stickslip/MODULE and source/MODULE. Prints
one line for each that is not allowed and returns 1 if there are any.
"""

import pathlib
import re
import sys

# What each module may include besides itself: modules, or single headers.
ALLOWED = {
    "base": (),
    "algebra": ("base",),
    "multigrid": ("algebra", "base"),
    "tnnmg": ("multigrid", "algebra", "base"),
    "condensed": ("tnnmg", "multigrid", "algebra", "base"),
    "parameters": ("base",),
    "geometry": ("parameters", "base"),
    "mesh": ("geometry", "parameters", "algebra", "base"),
    "mortar": ("parameters", "mesh", "geometry", "algebra", "base"),
    "mechanics": ("parameters", "mesh", "geometry", "algebra", "base"),
    "friction": ("parameters", "base", "tnnmg/nonsmooth_functional.h"),
    "faults": (
        "friction", "mechanics", "mortar", "mesh", "geometry", "algebra", "base",
    ),
    "problem": (
        "faults", "mechanics", "mortar", "mesh", "geometry", "multigrid",
        "algebra", "base",
    ),
    "time": (
        "problem", "faults", "friction", "mechanics", "parameters", "condensed",
        "tnnmg", "algebra", "base",
    ),
    "output": ("parameters", "mesh", "geometry", "algebra", "base"),
    "scene": (
        "output", "time", "friction", "mechanics", "mortar", "mesh", "geometry",
        "parameters", "tnnmg", "base",
    ),
    "simulation": (
        "scene", "output", "time", "problem", "faults", "friction", "mechanics",
        "mortar", "mesh", "geometry", "parameters", "condensed", "tnnmg", "multigrid",
        "algebra", "base",
    ),
}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)


def check_file(path, module, project):
    """Yield a sentence for each include that the module may not have."""
    relative = path.relative_to(project)
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        parts = name.split("/")
        if parts[0] != "stickslip":
            # A relative path would evade the check.
            if "." in parts or ".." in parts:
                yield f"{relative}: write <stickslip/...> instead of {name}"
            continue
        if len(parts) < 3:
            # Version differences of deal.II and the like serve every module.
            if (project / "include" / name).is_file():
                continue
            yield f"{relative}: there is no {name}"
            continue
        target = parts[1]
        if target == module or target in ALLOWED[module]:
            continue
        if "/".join(parts[1:]) in ALLOWED[module]:
            continue
        yield f"{relative}: {module} may not include {name}"


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    violations = []
    checked = 0
    for folder in (project / "include" / "stickslip", project / "source"):
        if not folder.is_dir():
            continue
        for path in sorted(folder.rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            parts = path.relative_to(folder).parts
            if len(parts) == 1:
                # The main file and what serves all modules.
                continue
            checked += 1
            if parts[0] not in ALLOWED:
                violations.append(
                    f"{path.relative_to(project)}: {parts[0]} is no module;"
                    " say in this check what it may include"
                )
                continue
            violations += check_file(path, parts[0], project)
    print("\n".join(violations) or f"The includes of {checked} files are allowed.")
    return 1 if violations or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
