# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Draw the pictures of doc/tutorial.md: contrib/tutorial [--program FILE]

Runs the scene slip.prm of the page, and writes doc/images/tutorial_geometry.png, its
bodies and its fault, and doc/images/tutorial_slip.png, its figure. Takes some seconds.
"""

import argparse
import pathlib
import re
import subprocess
import tempfile

from . import geometry, plot
from .run_files import Run
from .style import png

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGE = PROJECT / "doc/tutorial.md"
IMAGES = PROJECT / "doc/images"


def scenes():
    """The parameter files of the page by their names: indented blocks below a line that
    ends with the name."""
    text = PAGE.read_text(encoding="utf-8")
    return {name: re.sub(r"^    ", "", block, flags=re.M)
            for name, block in re.findall(
                r"`(\w+\.prm)`:\n\n((?:    .*\n)+)", text)}


def patches():
    """The changes of the sources that the page makes, in the form of git."""
    return re.findall(r"^```diff\n(.*?)^```", PAGE.read_text(encoding="utf-8"),
                      re.M | re.S)


def run(program, folder, name, *options):
    """Run a scene of the page in a folder; its output folder."""
    (folder / name).write_text(scenes()[name], encoding="utf-8")
    result = subprocess.run([program, name, *options], cwd=folder, capture_output=True,
                            text=True)
    if result.returncode != 0:
        raise SystemExit(f"{name}: {result.stderr}")
    return folder / "output" / pathlib.Path(name).stem


def main():
    parser = argparse.ArgumentParser(
        prog="contrib/tutorial", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=PROJECT / "build/stickslip",
                        type=lambda name: pathlib.Path(name).resolve())
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as folder:
        output = run(program, pathlib.Path(folder), "slip.prm")
        (IMAGES / "tutorial_geometry.png").write_bytes(png(geometry.draw(Run(output))))
        figure, _ = plot.draw(output, output / "run.png")
        (IMAGES / "tutorial_slip.png").write_bytes(figure.read_bytes())


if __name__ == "__main__":
    main()
