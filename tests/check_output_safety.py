#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that no run destroys what is there, and that faults of the system end one
with a sentence.

Usage: check_output_safety.py PROGRAM TESTS_FOLDER

Prints one line for each check that fails and returns 1 if there are any.
"""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, TESTS = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
SCENE = re.search(
    r'R"\((.*?)\)"', (TESTS / "creeping_scene.h").read_text(), re.DOTALL
).group(1)
SHORT = ["--set", "Time/End time=0.2"]
LONG = ["--set", "Time/End time=1e7", "--set", "Contact/Follow slip=false"]
REFUSED = "the results of another run are there; '--overwrite' replaces them"

problems = []


def expect(condition, what):
    if not condition:
        problems.append(what)


class Folder(tempfile.TemporaryDirectory):
    """An empty folder with the scene in it."""

    def __enter__(self):
        self.path = pathlib.Path(super().__enter__())
        (self.path / "scene.prm").write_text(SCENE)
        self.output = self.path / "output/scene"
        return self

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [PROGRAM, *arguments],
            cwd=self.path,
            stdout=options.pop("stdout", subprocess.PIPE),
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )

    def run(self, *arguments, **options):
        """Exit status, output and errors."""
        process = self.start(*arguments, **options)
        output, errors = process.communicate(timeout=120)
        return process.returncode, output, errors

    def table(self):
        return (self.output / "time_series.csv").read_text()

    def wait_for_rows(self, n=20):
        """Wait until a run is under way."""
        for _ in range(600):
            try:
                if self.table().count("\n") > n:
                    return
            except OSError:
                pass
            time.sleep(0.05)
        problems.append("a run does not get under way")


def expect_refused(answer, text, what):
    status, _, errors = answer
    expect(status == 1 and text in errors and errors.count("\n") == 1,
           f"{what}: {status} {errors}")


def check_files_that_are_read():
    with Folder() as folder:
        scene = folder.path / "parameters.prm"
        scene.write_text(SCENE)
        for more in ([], ["--overwrite"]):
            answer = folder.run(
                "parameters.prm", "--set", "Output/Output directory=.", *more, *SHORT
            )
            expect_refused(answer, "would write over the file 'parameters.prm'",
                           "a scene in the output folder")
        expect(scene.read_text() == SCENE, "parameters.prm has been replaced")
        folder.run("scene.prm", *SHORT)
        before = {p.name: p.read_bytes() for p in folder.output.iterdir() if p.is_file()}
        answer = folder.run("output/scene/parameters.prm", "--overwrite")
        expect_refused(answer, "parameters.prm', which it reads", "a run's own parameters")
        after = {p.name: p.read_bytes() for p in folder.output.iterdir() if p.is_file()}
        expect(before == after, "a run that was refused has changed results")
        # An include, and a file that an entry names.
        (folder.output / "run.png").write_text("x")
        (folder.path / "other.prm").write_text("include output/scene/parameters.prm\n")
        answer = folder.run("other.prm", "--overwrite")
        expect_refused(answer, "which it reads", "a file that is included")


def check_earlier_results():
    with Folder() as folder:
        folder.run("scene.prm", *SHORT)
        table = folder.table()
        (folder.output / "run.png").write_text("a figure")
        (folder.output / "notes.txt").write_text("mine")
        expect_refused(folder.run("scene.prm"), REFUSED, "a second run")
        expect(folder.table() == table, "a second run has changed the table")
        expect_refused(folder.run("scene.prm", "--restart", "--overwrite"),
                       "one of both is allowed", "both options")
        status, _, errors = folder.run("scene.prm", "--overwrite", *SHORT)
        expect(status == 0 and folder.table() == table, f"--overwrite: {errors}")
        expect(not (folder.output / "run.png").exists(), "an old figure is there")
        expect((folder.output / "notes.txt").exists(), "the user's file has gone")


def check_two_runs():
    with Folder() as folder:
        process = folder.start("scene.prm", *LONG)
        folder.wait_for_rows()
        for option in ("--overwrite", "--restart"):
            text = "another run is writing there" if option == "--overwrite" else ""
            expect_refused(folder.run("scene.prm", option, *SHORT), text,
                           f"{option} while a run is writing")
        process.send_signal(signal.SIGTERM)
        process.communicate()
        expect(process.returncode == 130, "the first of two runs failed")


def check_parameters_of_restart():
    with Folder() as folder:
        expect_refused(folder.run("scene.prm", "--restart"),
                       "there is no whole checkpoint", "nothing to go on with")
        folder.run("scene.prm", *SHORT)
        table = folder.table()
        answer = folder.run("scene.prm", "--restart", "--set", "Faults/fault/a=0.03")
        expect_refused(
            answer,
            "'Faults/fault/a' = '0.03': in the run that is to go on it is '0.02'",
            "another parameter")
        expect(folder.table() == table, "a restart that was refused changed the table")
        status, _, errors = folder.run(
            "scene.prm", "--restart", "--set", "Time/End time=0.4",
            "--set", "Output/Write volume=false")
        expect(status == 0 and folder.table().startswith(table)
               and folder.table() != table, f"a later end: {status} {errors}")


def check_signals():
    # Long enough to be under way when the signal comes.
    scene = ["scene.prm", "--set", "Time/End time=100"]
    with Folder() as folder:
        status, _, _ = folder.run(*scene)
        whole = folder.table()
        for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
            folder.output.rename(folder.path / number.name)
            process = folder.start(*scene)
            folder.wait_for_rows(10)
            process.send_signal(number)
            output, errors = process.communicate()
            if process.returncode == 0:
                continue  # It was faster.
            expect(process.returncode == 130 and errors == ""
                   and (folder.output / "summary.txt").exists(),
                   f"{number.name}: {process.returncode} {errors}")
            status, _, errors = folder.run(*scene, "--restart")
            expect(status == 0 and folder.table() == whole,
                   f"a restart after {number.name}: {status} {errors}")


def check_closed_pipe():
    with Folder() as folder:
        reader, writer = os.pipe()
        process = folder.start("scene.prm", *LONG, stdout=writer)
        os.close(writer)
        folder.wait_for_rows()
        os.close(reader)
        # The next line of progress comes within ten seconds.
        process.communicate(timeout=60)
        expect((folder.output / "summary.txt").exists(), "a closed pipe: no summary.txt")
        expect(list(folder.output.glob("checkpoints/*.state")), "a closed pipe: no state")


def check_rejected_attempts():
    with Folder() as folder:
        process = folder.start(
            "scene.prm", "--set", "Time/Largest number of rate-state iterations=1",
            "--set", "Time/Rate-state tolerance=1e-14",
            "--set", "Gravity/Acceleration=9.81", "--set", "Time/Smallest step=1e-290",
            # Attempts that take their time.
            "--set", "Bodies/lower/Uniform refinements=4",
            "--set", "Bodies/upper/Uniform refinements=4")
        while process.poll() is None and not (folder.output / "faults.pvd").exists():
            time.sleep(0.01)
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        process.communicate()
        expect(process.returncode == 130, f"rejected attempts: {process.returncode}")
        expect(folder.table().count("\n") == 1, "rejected attempts: there is a step")


def check_lost_folder():
    with Folder() as folder:
        process = folder.start("scene.prm", *LONG)
        folder.wait_for_rows()
        folder.output.rename(folder.path / "elsewhere")
        _, errors = process.communicate(timeout=60)
        # Which file is the first to find out is a matter of chance.
        expect_refused((process.returncode, "", errors), "cannot be written",
                       "a folder that vanishes")


def give_to(user, path):
    """Let a folder and all in it belong to a user."""
    for item in [path, *path.rglob("*")]:
        os.chown(item, user, user)


def check_read_only_folder():
    with Folder() as folder:
        # Permissions mean nothing to root, who runs the program as nobody.
        nobody, options = 65534, {}
        if os.geteuid() == 0:
            options = {"user": nobody, "group": nobody, "extra_groups": []}
            give_to(nobody, folder.path)
        environment = {**os.environ, "HOME": str(folder.path)}
        folder.output.mkdir(parents=True)
        if options:
            give_to(nobody, folder.path)
        folder.output.chmod(0o555)
        answer = folder.run("scene.prm", *SHORT, env=environment, **options)
        expect_refused(answer, "output/scene", "a folder that is read-only")
        expect(not list(folder.output.iterdir()), "a read-only folder has files")

        # One that becomes so while a run is writing.
        folder.output.chmod(0o755)
        process = folder.start("scene.prm", *LONG, env=environment, **options)
        folder.wait_for_rows()
        folder.output.chmod(0o555)
        _, errors = process.communicate(timeout=60)
        expect_refused((process.returncode, "", errors), "cannot be written",
                       "a folder that becomes read-only")
        expect("output/scene" in errors, f"no name of a file: {errors}")
        expect(folder.table()[-1:] == "\n", "half a row in a read-only folder")
        sets = [p for p in folder.output.glob("*.vtu") if p.stat().st_size == 0]
        expect(not sets, f"empty files in a read-only folder: {sets}")
        folder.output.chmod(0o755)


def check_full_disk():
    # Only root can make a small one.
    if os.geteuid() != 0:
        return
    for size in (60, 200, 400, 1000):
        with Folder() as folder:
            folder.output.mkdir(parents=True)
            mount = subprocess.run(
                ["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", folder.output],
                capture_output=True)
            if mount.returncode != 0:
                return
            try:
                status, _, errors = folder.run("scene.prm", *LONG)
                expect(status == 1 and errors.count("\n") == 1
                       and "cannot be written" in errors,
                       f"{size} kB: {status} {errors}")
                table = folder.output / "time_series.csv"
                expect(not table.exists() or table.read_text()[-1:] in ("", "\n"),
                       f"{size} kB: half a row")
            finally:
                subprocess.run(["umount", folder.output])


def main():
    for name, check in list(globals().items()):
        if name.startswith("check_"):
            check()
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
