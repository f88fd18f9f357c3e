# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The sections of doc/results.md: runs, tables, figures and data of each."""

import dataclasses

from common import csv_file, figures, page, programs

from . import drawings, experiments, inner_tables, rupture_tables, tables

PAGE = programs.PROJECT / "doc/results.md"
DATA = programs.PROJECT / "doc/data"
# s: where the runs of --quick end.
QUICK_END = 0.15


@dataclasses.dataclass
class Outcome:
    """What a section has to tell: a table in Markdown, figures by name, and rows for
    data files by name."""

    text: str
    figures: dict
    data: dict


def run_all(store, wanted, quick):
    """Runs by name, each to QUICK_END only if quick."""
    return {
        name: store.run(
            dataclasses.replace(experiment, end_time=QUICK_END) if quick else experiment
        )
        for name, experiment in wanted.items()
    }


def chosen(names):
    everything = experiments.PUBLISHED | experiments.VARIED
    return {name: everything[name] for name in names}


def event_rows(runs):
    """All events of all faults of some runs."""
    rows = []
    for run in runs:
        for fault in run.case.faults():
            events = run.events(fault)
            for k in range(len(events["start"])):
                rows.append({
                    "run": run.case.title,
                    **{name: page.rounded(values[k]) for name, values in events.items()},
                })
    return rows


def slider(store, quick):
    runs = run_all(store, chosen(("slider_published", "slider_default")), quick)
    text = tables.comparison(tables.PRINTED["slider"], list(runs.values()))
    return Outcome(text, {}, {"events_slider": event_rows(runs.values())})


def layered(store, quick):
    names = (
        "layered_published", "layered_default", "slider_published", "slider_default"
    )
    runs = run_all(store, chosen(names), quick)
    own = [runs["layered_published"], runs["layered_default"]]
    text = tables.comparison(tables.PRINTED["layered"], own)
    text += "\nMean slip rate of each fault after the first event of the top one:\n"
    for run in own:
        text += f"\n*{run.case.title.split(', ')[-1]}*\n\n{tables.faults(run)}"
    pair = runs["slider_published"], runs["layered_published"]
    # With the default settings both come to 60 s.
    faults = runs["slider_default"], runs["layered_default"]
    figures = {
        "slip_rates": lambda: drawings.slip_rates(*faults),
        "maps": lambda: drawings.maps(*faults),
        "steps": lambda: drawings.steps(*pair),
        "histograms": lambda: drawings.histograms(*pair),
    }
    return Outcome(text, figures, {"events_layered": event_rows(own)})


def events(store, quick):
    names = (
        "slider_published", "slider_default", "layered_published", "layered_default"
    )
    runs = run_all(store, chosen(names), quick)
    text, rows = rupture_tables.text(list(runs.values()))
    figures = {}
    if not quick:
        figures["events"] = lambda: drawings.events(rupture_tables.examples(runs))
    return Outcome(text, figures, {"ruptures": rows})


def inner(store, quick):
    names = ("layered_default", *(("light",) if quick else experiments.VARIED))
    runs = run_all(store, chosen(names), quick)
    return Outcome(*inner_tables.outcome(runs))


SECTIONS = {"slider": slider, "layered": layered, "events": events, "inner": inner}


def publish(name, outcome):
    """Write tables, figures and data of a section; their paths."""
    page.replace_section(name, outcome.text, PAGE, "contrib/results")
    paths = [PAGE]
    for data_name, rows in outcome.data.items():
        path = DATA / f"results_{data_name}.csv"
        if rows:
            csv_file.write(path, list(rows[0]), rows)
            paths.append(path)
    for figure_name, draw in outcome.figures.items():
        paths.append(figures.save(draw(), f"results_{figure_name}"))
    return paths
