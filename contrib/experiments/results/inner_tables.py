# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Tables and figures of the faults below the uppermost one."""

import numpy as np

from common import page

from . import drawings, inner, layers
from .block import Block

# s: a window with four events, to be drawn.
WINDOW = (30.0, 40.0)
# Vibrations with less of the response to slip are not listed.
SMALLEST_SHARE = 3e-3
# Up to this many times the frequencies of the other spectra.
HIGHER = 8.0
SINGLE_LAYERS = (
    (0.69, "between fault1 and fault4"),
    (0.3, "between fault1 and fault2, or fault3 and fault4"),
    (0.09, "between fault2 and fault3"),
)
# Waves are faster with less inertia.
SCALES = {"light": 10.0}


def first_event(run):
    events = run.events(run.case.top_fault())["start"]
    return float(events[0]) if len(events) else float("nan")


def after_events(run, last):
    """From where on oscillations are looked at: the first event, or the second half
    of a run that has none."""
    first = first_event(run)
    return first if first < last - 2.0 else last / 2


def varied_table(runs, last):
    """What changes on the top fault and on the lower ones, run by run."""
    default = runs["layered_default"].events("fault4")["start"]
    rows = []
    for run in runs.values():
        events = run.events("fault4")["start"]
        events = events[events < last]
        shifts = 1e3 * (events[:3] - default[: len(events)][:3]) if len(default) else []
        cells = [
            short_title(run),
            len(events),
            ", ".join(f"{shift:.1f}" for shift in shifts) or "–",
        ]
        begin = after_events(run, last)
        for fault in ("fault3", "fault2", "fault1"):
            found = inner.drop_and_ringing(run, fault, begin, last)
            cells.append(
                f"{found['median']:.1f}; {found['drop']:.2f}; {found['ringing']:.4f}"
            )
        rows.append(cells)
    return page.table(
        (
            "run", f"events of fault4 by {last:g} s", "shift of the first three, ms",
            *(f"{f}: log10 V; drop; ringing" for f in ("fault3", "fault2", "fault1")),
        ),
        rows,
    )


def block_table(compared, last):
    """The lower faults beside the friction law and the block: compared holds the runs
    with what inner.compare_with_block says of them."""
    rows = []
    for run, results in compared:
        for result in results:
            steady = inner.distance_to_steady(run, result["fault"])
            found = inner.agreement(result, after_events(run, last), last)
            rows.append((
                f"{short_title(run)}: {result['fault']}",
                f"{steady['largest']:.0e}",
                f"{steady['healing']:.0e} %",
                f"{inner.law_residual(run, result['fault']):.0e}",
                f"{found['traction_offset']:.0f} ± {found['traction_deviation']:.0f}",
                f"{found['rate_offset']:.2f} ± {found['rate_deviation']:.2f}",
                f"{found['rate_range']:.2f}",
                f"{found['correlation']:.3f}",
            ))
    return page.table(
        (
            "run", "largest V theta / L", "state less initial state plus time",
            "log10 V less the friction law at the nodes, at most",
            "mean traction less that of the block, Pa",
            "log10 V less that of the block", "range of log10 V",
            "correlation",
        ),
        rows,
    )


def work_table(run):
    rows = []
    for fault in run.case.faults()[::-1]:
        rows.append((fault, f"{inner.friction_work(run, fault):.2g}"))
    return page.table(("fault", "work of friction, J/m"), rows)


def frequency_table(runs, last, resonances):
    """Peaks of the spectra of the tractions beside the resonances."""
    names = {
        "locked": "column, all faults locked",
        "below": "column below the top fault, which slides freely",
        "above": "column above it",
    }
    rows = [("block, all faults locked", listed(resonances))]
    rows += [
        (names[name], listed(values))
        for name, values in layers.column_resonances().items()
    ]
    for name in ("layered_default", "fine", "light"):
        if name not in runs:
            continue
        run, scale = runs[name], SCALES.get(name, 1.0)
        for fault in run.case.faults()[::-1]:
            found = inner.peaks(
                *inner.spectrum(run, fault, after_events(run, last), last, scale),
                least=scale * inner.SPLIT,
            )
            rows.append((f"{short_title(run)}: {fault}", listed(found)))
    return page.table(("", "Hz"), rows)


def layer_table(run, last):
    """How much there is in the spectra at the resonances of single layers, against
    the highest peak."""
    rows = []
    spectra_of = {
        fault: inner.spectrum(run, fault, after_events(run, last), last, HIGHER)
        for fault in run.case.faults()[::-1]
    }
    for thickness, name in SINGLE_LAYERS:
        for frequency in layers.layer_resonances(thickness):
            cells = []
            for values, power in spectra_of.values():
                near = np.abs(values / frequency - 1) < 0.05
                highest = power[values > inner.SPLIT].max()
                cells.append(
                    f"{power[near].max() / highest:.0e}" if near.any() else "–"
                )
            rows.append((f"{name}, {thickness:.2f} m: {frequency:.0f} Hz", *cells))
    return page.table(("layer by itself", *spectra_of), rows)


def listed(frequencies):
    return ", ".join(f"{f:.1f}" for f in frequencies)


def short_title(run):
    return run.case.title.split("five bodies, ")[-1]


def excited(model):
    """Frequencies of the free vibrations that slip of the top fault excites, in Hz."""
    frequency, share = model.vibrations()
    return frequency[share > SMALLEST_SHARE]


def spectra(runs, last):
    """What drawings.spectra draws."""
    return [
        (
            short_title(runs[name]),
            SCALES.get(name, 1.0),
            {
                fault: inner.spectrum(
                    runs[name], fault, after_events(runs[name], last), last,
                    SCALES.get(name, 1.0),
                )
                for fault in runs[name].case.faults()[::-1]
            },
        )
        for name in ("fine", "light")
        if name in runs
    ]


def outcome(runs):
    """Text, figures and data of the section."""
    last = min(run.end() for run in runs.values())
    window = WINDOW if last >= WINDOW[1] else (0.5 * last, last)
    compared = [
        (
            runs[name],
            inner.compare_with_block(
                runs[name], after_events(runs[name], last), window[1]
            ),
        )
        for name in ("layered_default", "fine")
        if name in runs
    ]
    resonances = excited(Block())
    text = "\n".join((
        block_table(compared, window[1]),
        varied_table(runs, last),
        frequency_table(runs, last, resonances),
        layer_table(runs["tolerance" if "tolerance" in runs else "layered_default"], last),
        work_table(runs["layered_default"]),
    ))
    run, results = compared[-1]
    figures = {
        "inner": lambda: drawings.inner(short_title(run), results, window),
        "spectra": lambda: drawings.spectra(spectra(runs, last), resonances),
    }
    return text, figures, {"inner": window_rows(results, window)}


def window_rows(results, window):
    """What is drawn, every 20 ms."""
    names = ("rate", "block_rate", "traction", "block_traction")
    rows = []
    for result in results:
        inside = (result["time"] >= window[0]) & (result["time"] <= window[1])
        for k in np.flatnonzero(inside)[::10]:
            rows.append({
                "fault": result["fault"],
                "time_s": f"{result['time'][k]:.3f}",
                **{name: f"{result[name][k]:.5g}" for name in names},
            })
    return rows
