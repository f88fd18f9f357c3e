# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables of doc/results.md that put the published results beside the computed ones."""

import numpy as np

from common import page

from . import statistics

# As printed by Gräser, Kornhuber and Podlesny (2021).
PRINTED = {
    "slider": {
        "vertices": "1,274",
        "diameters": "4.4 to 70.8 cm",
        "end": "60 s",
        "events": "26",
        "first": "about 20 s",
        "rates": "1e-11 to 1e-3 m/s",
        "shrinking": "about two orders of magnitude",
        "fixed_point": "2 to 4",
        "cycles": "5 to 29",
    },
    "layered": {
        "vertices": "4,057",
        "diameters": "3.2 to 70.8 cm",
        "end": "60 s",
        "events": "periodic, as the spring slider",
        "shrinking": "about two orders of magnitude",
        "fixed_point": "2 to 4",
        "cycles": "at most 25",
    },
}
TITLES = {
    "vertices": "vertices of the mesh",
    "diameters": "diameters of the cells",
    "end": "end of the run",
    "events": "events of the top fault",
    "main": "of these, with at least 0.4 of the median slip",
    "first": "first event",
    "intervals": "from one event to the next: median, least, largest",
    "main_intervals": "the same between these",
    "rates": "mean slip rate: 1e-11 m/s is passed; least after the first event, largest",
    "node_rate": "largest slip rate of a node",
    "peaks": "largest mean slip rate in an event: median, least, largest",
    "slip": "mean slip in an event: median, least, largest",
    "lengths": "how long an event lasts: median",
    "step_loading": "step in loading: median, largest",
    "step_events": "step in events: median, least",
    "ratio": "ratio of the median steps",
    "shrinking": "longest step before an event over the shortest in it: median, least, "
    "largest",
    "accepted": "steps accepted, rejected",
    "fixed_point": "fixed-point iterations in a step",
    "fixed_point_share": "share of the steps that took 1, 2, 3, 4, more",
    "cycles": "multigrid cycles in a step",
    "cycles_mean": "mean, and the number that 99 % of the steps keep to",
    "cycles_rate": "mean by decade of the largest slip rate, from 1e-8 m/s up",
    "cpu": "CPU seconds",
}


def three(values, form="{:.3g}", unit=""):
    """Median, least and largest."""
    if len(values) == 0:
        return "–"
    numbers = (np.median(values), np.min(values), np.max(values))
    return ", ".join(form.format(v) for v in numbers) + unit


def between(counts):
    least, largest = int(counts.min()), int(counts.max())
    return f"{least}" if least == largest else f"{least} to {largest}"


def quantities(run):
    """What TITLES names, as text."""
    series, fault = run.series(), run.case.top_fault()
    events = run.events(fault)
    main = statistics.select(events, statistics.is_main(events))
    result = {
        "vertices": page.thousands(run.summary_number("Mesh of all bodies/vertices")),
        "diameters": diameters(run),
        "end": f"{run.end():.3g} s",
        "events": str(len(events["start"])),
        "main": str(len(main["start"])),
        "node_rate": f"{series[f'{fault}.max_slip_rate'].max():.2g} m/s",
        "accepted": f"{len(series['time']):,}, {run.summary_number('Steps/rejected'):,.0f}",
        "cpu": f"{run.cpu_seconds:.0f}" if np.isfinite(run.cpu_seconds) else "–",
        **iterations(series, fault),
    }
    if len(events["start"]):
        low, high = statistics.rates_after(series, fault, events["start"][0])
        slow = series["time"][np.argmax(series[f"{fault}.mean_slip_rate"] > 1e-11)]
        result |= {
            "first": f"{events['start'][0]:.2f} s",
            "intervals": three(statistics.intervals(events), unit=" s"),
            "main_intervals": three(statistics.intervals(main), unit=" s"),
            "rates": f"at {slow:.1f} s; {low:.1e}, {high:.1e} m/s",
            "peaks": three(events["peak_mean_slip_rate"], "{:.2g}", " m/s"),
            "slip": three(1e3 * events["mean_slip"], "{:.2g}", " mm"),
            "lengths": f"{np.nanmedian(events['end'] - events['start']):.2g} s",
            **steps(series, events),
        }
    return result


def diameters(run):
    """Least and largest of all bodies, in cm."""
    sizes = [
        100 * run.summary_number(f"Mesh of all bodies/{which} cell diameter")
        for which in ("smallest", "largest")
    ]
    return f"{sizes[0]:.1f} to {sizes[1]:.1f} cm"


def steps(series, events):
    sizes = statistics.step_sizes(series, events)
    if len(sizes) < 2:
        return {}
    loading, inside = sizes["loading"], sizes["events"]
    return {
        "step_loading": f"{loading['median']:.2g} s, {loading['largest']:.2g} s",
        "step_events": f"{inside['median']:.2g} s, {inside['least']:.2g} s",
        "ratio": f"{loading['median'] / inside['median']:.0f}",
        "shrinking": three(statistics.shrinking(series, events), "{:.0f}"),
    }


def iterations(series, fault):
    fixed, cycles = series["rate_state_iterations"], series["multigrid_cycles"]
    share = statistics.histogram(fixed)
    parts = [share.get(k, 0.0) for k in (1, 2, 3, 4)]
    parts.append(sum(part for k, part in share.items() if k > 4))
    by_rate = statistics.dependence_on_rate(series, fault, "multigrid_cycles")
    return {
        "fixed_point": between(fixed),
        "fixed_point_share": ", ".join(percent(part) for part in parts),
        "cycles": between(cycles),
        "cycles_mean": f"{cycles.mean():.1f}, {np.quantile(cycles, 0.99):.0f}",
        "cycles_rate": ", ".join(
            f"{mean:.1f}" for decade, mean in sorted(by_rate.items()) if decade >= -8
        ),
    }


def percent(part):
    if part == 0:
        return "0"
    if 0.999 < part < 1:
        return f"{100 * part:.2f} %"
    return f"{100 * part:.3g} %" if part >= 1e-3 else f"{100 * part:.1g} %"


def comparison(printed, runs):
    """A row for each quantity: printed, and computed by each of the runs."""
    columns = [quantities(run) for run in runs]
    rows = [
        (TITLES[name], printed.get(name, ""), *(c.get(name, "–") for c in columns))
        for name in TITLES
        if any(name in c for c in columns)
    ]
    heads = [run.case.title.split(", ")[-1] for run in runs]
    return page.table(("", "published", *heads), rows)


def faults(run):
    """Each fault of the layered scene from above, after the top fault's first event."""
    names = run.case.faults()[::-1]
    begin = run.events(names[0])["start"]
    begin = float(begin[0]) if len(begin) else 0.0
    rows = []
    for name in names:
        least, low, median, high, largest = statistics.quantiles(
            run.series(), name, begin
        )
        series = run.series()
        rows.append((
            name,
            len(run.events(name)["start"]),
            *(f"{value:.1e}" for value in (least, low, median, high, largest)),
            f"{np.log10(largest / least):.1f}",
            f"{series[f'{name}.max_slip_rate'].max():.1e}",
            f"{series[f'{name}.mean_slip'][-1] * 1e3:.2g}",
        ))
    return page.table(
        ("fault", "events", "least, m/s", "5 %", "median", "95 %", "largest",
         "decades", "largest of a node, m/s", "slip at the end, mm"),
        rows,
    )
