#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Check that the output folder of a run is complete and agrees with itself.

Usage: check_output_folder.py FOLDER FAULT...

Prints one line for each contradiction and returns 1 if there are any.
"""

import csv
import math
import pathlib
import re
import sys
import xml.etree.ElementTree

import h5py
import numpy

COLUMNS = ["step", "time", "step_size", "rate_state_iterations"]
COLUMNS += ["tnnmg_iterations", "multigrid_cycles", "fault_error", "body_error"]
FAULT_COLUMNS = ["max_slip_rate", "mean_slip_rate", "min_slip_rate"]
FAULT_COLUMNS += ["mean_slip", "mean_state", "mean_shear_traction"]
EVENT_COLUMNS = ["fault", "start", "peak_time", "end", "peak_mean_slip_rate"]
EVENT_COLUMNS += ["peak_slip_rate", "mean_slip", "nucleation_x"]
EVENT_COLUMNS += ["moment", "peak_moment_rate", "stress_drop", "ruptured_area"]
OPENING_COLUMNS = ["fault", "opens", "peak_time", "closes", "largest_gap"]
OPENING_COLUMNS += ["largest_open_area", "begins_x", "widest_x"]
FIELDS = ["slip", "slip_rate", "shear_traction", "normal_stress", "state"]
PRECISION = 1e-12


def is_near(a, b):
    return math.isclose(a, b, rel_tol=PRECISION, abs_tol=1e-300)


def summary_of(folder):
    """The entries of summary.txt as {section: {key: value}}."""
    sections, section = {}, {}
    for line in (folder / "summary.txt").read_text().splitlines():
        if line and not line.startswith(" "):
            section = sections.setdefault(line, {})
        elif line:
            key, value = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            section[key] = value
    return sections


def check_time_series(folder, faults, summary):
    """Yield the contradictions in the table; its last row is returned."""
    with open(folder / "time_series.csv", newline="") as file:
        header, *rows = list(csv.reader(file))
    expected = list(COLUMNS)
    for fault in faults:
        may_open = f"{fault}.open_area" in header
        columns = FAULT_COLUMNS + (["largest_gap", "open_area"] if may_open else [])
        expected += [f"{fault}.{column}" for column in columns]
    if header != expected:
        yield f"time_series.csv has the columns {header}"
        return
    rows = [dict(zip(header, map(float, row), strict=True)) for row in rows]
    if len(rows) != int(summary["Steps"]["accepted"]):
        yield f"{len(rows)} rows, {summary['Steps']['accepted']} accepted steps"
    time = 0.0
    for number, row in enumerate(rows, start=1):
        if row["step"] != number:
            yield f"row {number} is that of step {row['step']}"
        if not row["time"] > time:
            yield f"time does not grow in step {number}"
        # Times are sums, rounded to their own last digit.
        if abs(row["time"] - time - row["step_size"]) > 4e-16 * row["time"]:
            yield f"step {number} is not as long as its step size"
        time = row["time"]
        if not all(math.isfinite(value) for value in row.values()):
            yield f"step {number} has a value that is not finite"
    for fault in faults:
        for row in rows:
            rates = [row[f"{fault}.{x}_slip_rate"] for x in ("min", "mean", "max")]
            if not 0 <= rates[0] <= rates[1] * (1 + 1e-9) <= rates[2] * (1 + 2e-9):
                yield f"{fault}: slip rates {rates} are out of order"
    if not is_near(float(f"{time:g}"), float(summary["Run"]["simulated time"].split()[0])):
        yield f"the table ends at {time}, not at {summary['Run']['simulated time']}"


def last_row(folder):
    with open(folder / "time_series.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return {key: float(value) for key, value in rows[-1].items()} if rows else None


def check_faults(folder, faults):
    """Yield what is wrong in faults.h5, and where its end is not the table's."""
    row = last_row(folder)
    with h5py.File(folder / "faults.h5", "r") as file:
        if sorted(file.keys()) != sorted(faults):
            yield f"faults.h5 has the faults {list(file.keys())}"
            return
        for name in faults:
            group = file[name]
            times = group["time"][:]
            if times[0] != 0 or not all(numpy.diff(times) > 0):
                yield f"{name}: times do not grow from 0"
            n_nodes = len(group["coordinates"])
            for field in FIELDS:
                if group[field].shape != (len(times), n_nodes):
                    yield f"{name}/{field} has the shape {group[field].shape}"
                if "units" not in group[field].attrs:
                    yield f"{name}/{field} has no units"
                if not numpy.isfinite(group[field][:]).all():
                    yield f"{name}/{field} is not finite"
            if row is None:
                continue
            weight = group["weight"][:]
            mean = {
                "mean_slip": group["slip"][-1],
                "mean_slip_rate": abs(group["slip_rate"][-1]),
                "mean_state": group["state"][-1],
                "mean_shear_traction": group["shear_traction"][-1],
            }
            if f"{name}.open_area" in row:
                gap = group["gap"][-1] * (weight > 0)
                if gap.min() < 0 or gap.max() != row[f"{name}.largest_gap"]:
                    yield f"{name}: gaps up to {gap.max()} in the last record"
                if not is_near(weight[gap > 0].sum(), row[f"{name}.open_area"]):
                    yield f"{name}: not the open area of the last record"
                if (group["contact_state"][-1][gap > 0] != 0).any():
                    yield f"{name}: open nodes have another contact state"
            if times[-1] != row["time"]:
                yield f"{name}: the last record is of t = {times[-1]}"
            for column, values in mean.items():
                value = weight @ values / weight.sum()
                size = weight @ abs(values) / weight.sum()
                if abs(value - row[f"{name}.{column}"]) > PRECISION * size:
                    yield f"{name}.{column}: last record {value}, table {row}"
            if abs(group["slip_rate"][-1]).max() != row[f"{name}.max_slip_rate"]:
                yield f"{name}: the last records have different largest slip rates"


def check_fields(folder):
    """Yield what is wrong with solution.pvd and faults.pvd and their files."""
    row = last_row(folder)
    listed = set()
    for record in ("solution.pvd", "faults.pvd"):
        entries = list(xml.etree.ElementTree.parse(folder / record).iter("DataSet"))
        if not entries:
            yield f"{record} lists nothing"
            return
        times = [float(entry.attrib["timestep"]) for entry in entries]
        if times != sorted(times):
            yield f"the times in {record} do not grow"
        if row is not None and not math.isclose(times[-1], row["time"], rel_tol=1e-9):
            yield f"{record} ends at {times[-1]}, the table at {row['time']}"
        listed |= {entry.attrib["file"] for entry in entries}
    present = {path.name for path in folder.glob("*.vtu")}
    if listed != present:
        yield f"{sorted(listed)} are listed, there are {sorted(present)}"
    for name in sorted(listed & present):
        root = xml.etree.ElementTree.parse(folder / name).getroot()
        if root.tag != "VTKFile" or root.find(".//Points") is None:
            yield f"{name} is no VTU file with points"


def check_events(folder, faults, summary):
    with open(folder / "events.csv", newline="") as file:
        header, *rows = list(csv.reader(file))
    if header != EVENT_COLUMNS:
        yield f"events.csv has the columns {header}"
    for fault in faults:
        n_events = sum(row[0] == fault for row in rows)
        if str(n_events) != summary["Events"][fault]:
            yield f"{fault}: {n_events} events, {summary['Events'][fault]} in summary.txt"
    for row in rows:
        _, start, peak, end = row[0], *map(float, row[1:4])
        if not start <= peak or end < peak:
            yield f"the event {row} is out of order"


def check_openings(folder, faults, summary):
    row = last_row(folder)
    may_open = [f for f in faults if row is not None and f"{f}.open_area" in row]
    if (folder / "openings.csv").is_file() != bool(may_open):
        yield f"openings.csv does not fit to {may_open}, which may open"
        return
    if not may_open:
        return
    with open(folder / "openings.csv", newline="") as file:
        header, *rows = list(csv.reader(file))
    if header != OPENING_COLUMNS:
        yield f"openings.csv has the columns {header}"
    for fault in may_open:
        count = sum(row[0] == fault for row in rows)
        if str(count) != summary["Openings"][fault]:
            yield f"{fault}: {count} openings, {summary['Openings'][fault]} in summary.txt"
    for row in rows:
        opens, peak, closes, largest = map(float, row[1:5])
        if not opens <= peak or closes < peak or not largest > 0:
            yield f"the opening {row} is out of order"


def check_energies(folder):
    """Yield what is wrong in energy.csv: its times are those of faults.h5."""
    if not (folder / "energy.csv").is_file():
        return
    with open(folder / "energy.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    if (folder / "faults.h5").is_file():
        with h5py.File(folder / "faults.h5", "r") as file:
            times = [group["time"][:].ravel().tolist() for group in file.values()]
        if [float(row["time"]) for row in rows] != times[0]:
            yield "energy.csv has other times than faults.h5"
    for row in rows:
        if not all(math.isfinite(float(value)) for value in row.values()):
            yield f"energy.csv has a value that is not finite: {row}"


def check_columns(folder):
    """Yield the columns of tables that columns.csv does not name in their order."""
    with open(folder / "columns.csv", newline="") as file:
        described = list(csv.DictReader(file))
    for path in sorted(folder.glob("*.csv")):
        if path.name == "columns.csv":
            continue
        with open(path, newline="") as file:
            titles = next(csv.reader(file))
        if [row["column"] for row in described if row["file"] == path.name] != titles:
            yield f"columns.csv does not describe {path.name}"
    if not all(row["meaning"] for row in described):
        yield "columns.csv has columns without meaning"


def check(folder, faults):
    """Yield a sentence for each contradiction."""
    for name in ("parameters.prm", "summary.txt", "time_series.csv", "events.csv",
                 "columns.csv"):
        if not (folder / name).is_file():
            yield f"{name} is missing"
            return
    summary = summary_of(folder)
    yield from check_time_series(folder, faults, summary)
    yield from check_faults(folder, faults)
    yield from check_fields(folder)
    yield from check_events(folder, faults, summary)
    yield from check_openings(folder, faults, summary)
    yield from check_energies(folder)
    yield from check_columns(folder)
    leftovers = [path.name for path in folder.iterdir() if path.suffix == ".tmp"]
    if leftovers:
        yield f"left over: {leftovers}"


def main():
    problems = list(check(pathlib.Path(sys.argv[1]), sys.argv[2:]))
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
