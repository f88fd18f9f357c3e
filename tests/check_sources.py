#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check the rules that every source file keeps beyond its format.

Usage: check_sources.py PROJECT_DIRECTORY

Each file names licence and copyright in its first two lines; headers have the
include guard that follows from their path and none of the deal.II headers
that take seconds to compile; no file is longer than MAX_LINES; every source
in source/ has the header of its name. Prints one line for each violation and
returns 1 if there are any.
"""

import pathlib
import re
import sys

MAX_LINES = 700
LICENCE = "SPDX-License-Identifier: LGPL-2.1-or-later"
COPYRIGHT = re.compile(r"Copyright \(C\) \d{4}(-\d{4})? by the stickslip authors")
HEAVY_HEADERS = re.compile(
    r"^\s*#\s*include\s*[<\"](deal\.II/(numerics/vector_tools|numerics/data_out"
    r"|numerics/matrix_tools|lac/(generic_linear_algebra|trilinos|petsc))"
    r"|(Epetra|ml_|Amesos|Teuchos))",
    re.MULTILINE,
)

COMMENT = re.compile(r"/\*\*?\s*(?:\*\s*)?(\w+(?: \w+)?)|(?<!/)//\s*(\w+(?: \w+)?)")
NO_NOUN = re.compile(
    r"(Those|Which|Whether|What|Where|When|How|That|The same|As if|So that|It|They)\b"
)


def check_comments(relative, text):
    """Yield a sentence for each comment that does not begin with its noun."""
    # One line of // continues another one.
    text = re.sub(r"(//[^\n]*)\n[ \t]*//", r"\1 ", text)
    for match in COMMENT.finditer(text):
        begin = match[1] or match[2]
        if NO_NOUN.match(begin):
            line = text.count("\n", 0, match.start()) + 1
            yield f"{relative}, about line {line}: a comment begins with '{begin}'"


def check_file(path, project):
    """Yield a sentence for each rule that the file breaks."""
    relative = path.relative_to(project)
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    mark = "//" if path.suffix in (".h", ".cc") else "#"
    if lines and lines[0].startswith("#!"):
        lines = lines[1:]

    if lines[:1] != [f"{mark} {LICENCE}"]:
        yield f"{relative}: the first line is not '{mark} {LICENCE}'"
    if path.name != "CMakeLists.txt" and not (
        len(lines) > 1 and COPYRIGHT.fullmatch(lines[1].lstrip(mark + " "))
    ):
        yield f"{relative}: the second line does not name the stickslip authors"
    if len(lines) > MAX_LINES:
        yield f"{relative}: {len(lines)} lines, more than {MAX_LINES}"

    if path.suffix in (".h", ".cc"):
        yield from check_comments(relative, text)

    if path.suffix == ".h" and relative.parts[0] == "include":
        guard = "_".join(relative.with_suffix("").parts[1:]) + "_h"
        code = re.sub(r"//[^\n]*", "", text).strip()
        if not code.startswith(f"#ifndef {guard}\n#define {guard}\n"):
            yield f"{relative}: the include guard is not {guard}"
        for match in HEAVY_HEADERS.finditer(text):
            yield f"{relative}: includes {match[1]}..., for source files only"

    if path.suffix == ".cc" and relative.parts[0] == "source":
        header = pathlib.Path("stickslip", *relative.parts[1:]).with_suffix(".h")
        if relative.name != "main.cc":
            if not (project / "include" / header).is_file():
                yield f"{relative}: there is no include/{header}"
            elif f"#include <{header}>" not in text:
                yield f"{relative}: does not include its header {header}"


def source_files(project):
    patterns = {
        "include": ("*.h",),
        "source": ("*.cc", "*.h"),
        "tests": ("*.cc", "*.h", "*.py", "CMakeLists.txt"),
        "contrib": ("*.h", "*.cc", "*.py"),
    }
    files = {project / "CMakeLists.txt"}
    for folder, names in patterns.items():
        for name in names:
            files.update((project / folder).rglob(name))
    # The scripts that are started by name.
    for folder in ("contrib", ".ci"):
        files.update(
            path
            for path in (project / folder).glob("*")
            if path.is_file() and path.suffix == ""
        )
    return sorted(files)


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    files = source_files(project)
    violations = [line for path in files for line in check_file(path, project)]
    print("\n".join(violations) or f"{len(files)} files keep the rules.")
    return 1 if violations or not files else 0


if __name__ == "__main__":
    sys.exit(main())
