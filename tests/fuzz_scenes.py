#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Look for scenes that the program does not survive.

Usage: fuzz_scenes.py PROGRAM SCENES SECONDS [SEED]

Changes copies of the scenes in the folder SCENES at random, lines, words, numbers and
bytes, and lets the program check them (`stickslip --check FILE...`), many in one
start, for so many seconds. Reported are crashes, more than ten seconds of processor
time for one scene, messages that are not one line, and those with text of a library. What is found is
kept in the folder fuzz_findings. Returns 1 if there is anything.
"""

import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

PER_START = 12
LONGEST = 10.0

NUMBERS = [
    "0", "-1", "1e-300", "1e300", "1e999", "-0", "nan", "inf", "1e-9", "3.5", "17",
    "4294967296", "-2147483649", "1,5", "1e", ".", "+", "--1", "0x1", "1 km", "5 GPa",
    "2 m/s", "100 yr", "3 bananas", "1 m^-3", "1 m^99", "1/0", "x", "x*y", "t", "z",
    "sin(", "if(x>0,1", "table nowhere.txt", "table", "auto", "true", "\u00b5m", "2 °",
    "1e-3 * x MPa", "sqrt(-1)", "log(0)", "x^x^x", "((((((((((1))))))))))", "",
]
WORDS = [
    "set", "end", "subsection", "include", "=", "#", "\\", "Names", "lower", "free",
    "fixed", "velocity", "traction", "unilateral", "Coulomb", "welded", "quasi-static",
    "prescribed slip rate", "3", "2", ",", ";", "'", "\"", "\0", "\t", "\ufeff", "é",
    " " * 3000, "a" * 3000, "../" * 50, "%s%n", "$HOME", "|",
]


def mutate(text, chance):
    lines = text.split("\n")
    for _ in range(chance.choice([1, 1, 1, 2, 3, 8])):
        i = chance.randrange(len(lines))
        line = lines[i]
        kind = chance.randrange(11)
        if kind <= 4 and "=" in line:
            name, value = line.split("=", 1)
            numbers = value.split(",")
            numbers[chance.randrange(len(numbers))] = " " + chance.choice(NUMBERS)
            lines[i] = name + "=" + ",".join(numbers)
        elif kind == 5:
            del lines[i]
        elif kind == 6:
            lines.insert(i, chance.choice(lines))
        elif kind == 7:
            j = chance.randrange(len(lines))
            lines[i], lines[j] = lines[j], line
        elif kind == 8:
            words = line.split(" ")
            words.insert(chance.randrange(len(words) + 1), chance.choice(WORDS))
            lines[i] = " ".join(words)
        elif kind == 9 and line:
            j = chance.randrange(len(line))
            lines[i] = line[:j] + chr(chance.randrange(1, 256)) + line[j + 1 :]
        elif kind == 10 and line:
            j, k = sorted(chance.randrange(len(line)) for _ in range(2))
            lines[i] = line[:j] + line[k:]
        if not lines:
            lines = [""]
    return "\n".join(lines)


def suspicious(line):
    return re.search(
        r"dealii|Exc[A-Z]|terminate|std::|/usr/|source/|include/|backtrace|Abort"
        r"|Segmentation|an error without a message|\bassert",
        line,
        re.I,
    )


def limit_time(seconds):
    """Let the program end after so many seconds of processor time."""
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))


def check(program, folder, names):
    """Status, what stands in the way of a good answer, and its text."""
    try:
        run = subprocess.run(
            [program, "--check"] + names,
            cwd=folder,
            capture_output=True,
            text=True,
            errors="replace",
            preexec_fn=lambda: limit_time(LONGEST * len(names) + 5),
            # The machine may have much else to do.
            timeout=20 * LONGEST * len(names),
        )
    except subprocess.TimeoutExpired:
        return "no answer in time", ""
    if run.returncode not in (0, 1):
        return f"status {run.returncode}", run.stdout[-500:] + run.stderr[-3000:]
    for line in re.findall("[^\n]+", run.stderr) + re.findall("^Warning: .*", run.stdout, re.M):
        if not line.startswith(("stickslip: ", "Warning: ")):
            return "a line that is no message", line
        if suspicious(line):
            return "text of a library", line
        if not line.endswith("."):
            return "no full stop", line
    return "", ""


def main():
    program, scenes = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
    end = time.monotonic() + float(sys.argv[3])
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else time.time_ns() % 10**9
    print(f"seed {seed}", flush=True)
    chance = random.Random(seed)
    texts = [path.read_text(encoding="utf-8") for path in sorted(scenes.glob("*.prm"))]
    n_scenes, findings = 0, {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in scenes.iterdir():
            if path.is_dir():
                shutil.copytree(path, folder / path.name)
        while time.monotonic() < end:
            names = []
            for k in range(PER_START):
                names.append(f"scene_{k}.prm")
                (folder / names[-1]).write_text(
                    mutate(chance.choice(texts), chance), encoding="utf-8"
                )
            n_scenes += len(names)
            if not check(program, folder, names)[0]:
                continue
            for scene in names:
                problem, answer = check(program, folder, [scene])
                key = problem + ": " + re.sub(r"[0-9.e+-]+|'[^']*'", "#", answer)[:90]
                if not problem or key in findings:
                    continue
                findings[key] = scene
                kept = pathlib.Path("fuzz_findings")
                kept.mkdir(exist_ok=True)
                shutil.copy(folder / scene, kept / f"{seed}_{len(findings)}.prm")
                print(f"{kept}/{seed}_{len(findings)}.prm: {problem}\n{answer}\n", flush=True)
            shutil.rmtree(folder / "output", ignore_errors=True)
    print(f"{n_scenes} scenes, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
