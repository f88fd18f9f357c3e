# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Summary and events of a run."""

import csv
import re


def results(output):
    """What summary.txt and events.csv say, section by section."""
    result = {"events": {}}
    summary = output / "summary.txt"
    if not summary.is_file():
        return result
    section = ""
    for line in summary.read_text().splitlines():
        if line and not line.startswith(" "):
            section = line
        elif line:
            name, value = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            result[f"{section}/{name}"] = value
    with open(output / "events.csv", newline="") as file:
        for event in csv.DictReader(file):
            result["events"].setdefault(event["fault"], []).append(
                float(event["start"])
            )
    return result
