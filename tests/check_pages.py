#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that links between the pages lead somewhere, and that README's scene runs.

Usage: check_pages.py PROJECT_DIRECTORY PROGRAM

Links to files must exist, those to headings too. Every page of doc/ stands in
doc/index.md. The first indented block of README.md that begins with a subsection is
run for half a second. Prints one line for each failure and returns 1 if there are any.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

LINK = re.compile(r"\]\(([^)#:\s]*)(?:#([^)\s]*))?\)")


def anchors(page):
    """Headings of a page in the form that links to them have."""
    for heading in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M):
        plain = re.sub(r"[^\w\- ]", "", heading.lower())
        yield plain.replace(" ", "-")


def check_links(page, project):
    for name, anchor in LINK.findall(page.read_text(encoding="utf-8")):
        target = page.parent / name if name else page
        if not target.exists():
            yield f"{page.relative_to(project)}: there is no {name}"
        elif anchor and anchor not in anchors(target):
            yield f"{page.relative_to(project)}: {target.name} has no heading #{anchor}"


def check_index(project):
    text = (project / "doc/index.md").read_text(encoding="utf-8")
    for page in sorted((project / "doc").glob("*.md")):
        if page.name != "index.md" and f"({page.name})" not in text:
            yield f"doc/index.md does not name {page.name}"


def check_scene(project, program):
    text = (project / "README.md").read_text(encoding="utf-8")
    block = re.search(r"(?:^    .*\n)+", text[text.index("    subsection"):], re.M)
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.prm"
        scene.write_text(block[0], encoding="utf-8")
        run = subprocess.run(
            [program, scene, "--set", "Time/End time=0.5",
             "--set", f"Output/Output directory={folder}/output"],
            capture_output=True, text=True)
    if run.returncode != 0 or "reached the end time" not in run.stdout:
        yield f"README's scene: {run.stderr.strip() or run.stdout.strip()}"


def main():
    project, program = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    pages = [*project.glob("*.md"), *project.glob("doc/*.md"),
             *project.glob("contrib/**/*.md")]
    failures = [line for page in sorted(pages) for line in check_links(page, project)]
    failures += check_index(project)
    failures += check_scene(project, program)
    print("\n".join(failures) or f"{len(pages)} pages and README's scene are right.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
