# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene weakening_patch.prm: afterslip around the patch, and smaller patches."""

import numpy as np

from common import page
from common.figures import (
    BLUE, GREEN, GREY, ORANGE, VERMILION, draw_map, new_figure, title,
)
from experiments.results.history import FaultHistory

from . import cases

SCENE = "weakening_patch"
A, B_PATCH, B_OUTSIDE, LENGTH, NORMAL_STRESS = 0.010, 0.020, 0.004, 1e-5, 5e4
POISSON_RATIO = 0.3
SHEAR_MODULUS = 4.12e7 / (2 * 1.3)
EFFECTIVE_MODULUS = SHEAR_MODULUS / (1 - POISSON_RATIO)
LOADING_RATE = 2e-5
# m: positions in the strengthening part at which afterslip is measured.
PLACES = (1.25, 1.5, 1.75, 2.0)
HALF_WIDTHS = (0.15, 0.2, 0.3, 0.4, 0.5, 1.0, 1.5)
# s: from here on cycles repeat.
SETTLED = 430.0


def nucleation_length():
    """Of the aging law in two dimensions, the whole length (Rubin and Ampuero 2005)."""
    return (
        2 / np.pi * EFFECTIVE_MODULUS * B_PATCH * LENGTH
        / (NORMAL_STRESS * (B_PATCH - A) ** 2)
    )


def process_zone():
    """G* L / (b sigma_n): over it the friction falls behind the tip of a rupture."""
    return EFFECTIVE_MODULUS * LENGTH / (B_PATCH * NORMAL_STRESS)


def patch(half_width):
    return (
        f"0.004 + 0.016 * (0.5 - 0.5 * tanh((abs(x) - {half_width:g}) / 0.05))"
    )


def weakening_width(half_width):
    """Length of what has b > a."""
    x = np.linspace(0, 3, 30001)
    b = B_OUTSIDE + (B_PATCH - B_OUTSIDE) * (
        0.5 - 0.5 * np.tanh((x - half_width) / 0.05))
    return 2 * x[b > A].max(initial=0)


def last_interval(run):
    """Start of the last event but one, its peak and the start of the last."""
    events = run.events("fault")
    return events["start"][-2], events["peak_time"][-2], events["start"][-1]


class Afterslip:
    """What one point does between two events."""

    def __init__(self, run, place):
        history = FaultHistory(run.history(), "fault")
        node = history.node(place)
        _, peak, following = last_interval(run)
        chosen = (history.time > peak) & (history.time < following)
        self.x = history.x[node]
        self.time = history.time[chosen] - peak
        self.slip = history.field("slip")[chosen, node]
        self.rate = history.rate()[chosen, node]
        self.traction = history.field("shear_traction")[chosen, node]
        top = int(np.argmax(self.rate))
        # From half of its largest slip rate down to 1.5 times that of loading.
        late = np.arange(len(self.rate)) > top
        self.fitted = late & (self.rate < self.rate[top] / 2) & (
            self.rate > 1.5 * LOADING_RATE)
        self.largest_rate = self.rate[top]

    def fit(self):
        """Slope of slip over ln t and what it leaves; traction over ln V; stiffness."""
        log_time = np.log(self.time[self.fitted])
        slip, traction = self.slip[self.fitted], self.traction[self.fitted]
        slope, start = np.polyfit(log_time, slip, 1)
        left = np.abs(slip - slope * log_time - start).max() / np.ptp(slip)
        direct = np.polyfit(np.log(self.rate[self.fitted]), traction, 1)[0]
        stiffness = -np.polyfit(slip, traction, 1)[0]
        return slope, left, direct, stiffness


def afterslip_rows(run):
    rows = []
    for place in PLACES:
        point = Afterslip(run, place)
        slope, left, direct, stiffness = point.fit()
        rows.append((
            f"{point.x:.2f}", f"{point.largest_rate:.2g}",
            f"{point.time[point.fitted][0]:.2g} to {point.time[point.fitted][-1]:.2g}",
            f"{1e6 * slope:.1f}", f"{100 * left:.1f} %", f"{direct:.0f}",
            f"{stiffness / 1e6:.1f}", f"{1e6 * direct / stiffness:.1f}",
        ))
    return page.table(
        ("x, m", "largest slip rate, m/s", "fitted from t to t, s",
         "slip over ln t, µm", "largest misfit", "traction over ln V, Pa",
         "stiffness, MPa/m", "their ratio, µm"), rows)


def extent(run, rate):
    """Half length of what exceeds a slip rate in the last event but one."""
    history = FaultHistory(run.history(), "fault")
    start, _, following = last_interval(run)
    chosen = (history.time > start - 0.3) & (history.time < 0.5 * (start + following))
    fast = (history.rate()[chosen] > rate).any(axis=0)
    return np.abs(history.x[fast]).max() if fast.any() else 0.0


def creep(run):
    """Half length of the part of the patch that is slower than a tenth of the loading
    rate: some seconds after an event, and shortly before the next one nucleates."""
    history = FaultHistory(run.history(), "fault")
    _, peak, following = last_interval(run)
    result = []
    for share in (0.2, 0.4, 0.6, 0.8, 0.9):
        k = np.argmin(np.abs(history.time - peak - share * (following - peak)))
        slow = history.rate()[k] < LOADING_RATE / 10
        result.append((share, np.abs(history.x[slow]).max() if slow.any() else 0.0))
    return result


def late_maxima(run):
    """Times and values of the largest slip rate's maxima once cycles repeat."""
    series = run.series()
    time, peaks = cases.maxima(series["time"], np.log(series["fault.max_slip_rate"]))
    high = (time > SETTLED) & (peaks > np.log(LOADING_RATE) + 0.5 * (
        np.log(series["fault.max_slip_rate"][series["time"] > SETTLED].max())
        - np.log(LOADING_RATE)))
    return time[high], np.exp(peaks[high])


def sweep_row(half_width, run):
    width = weakening_width(half_width)
    series = run.series()
    late = series["time"] > SETTLED
    largest = series["fault.max_slip_rate"][late].max()
    events = run.events("fault")
    late_events = events["start"][events["start"] > SETTLED]
    # Several maxima belong to one event; starts are what recurs.
    if len(late_events) > 1:
        recurrence = f"{np.diff(late_events).mean():.2f}"
    elif largest > 1.5 * LOADING_RATE:
        times, _ = late_maxima(run)
        recurrence = f"{np.diff(times).mean():.2f}" if len(times) > 1 else "–"
    else:
        recurrence = "–"
    return (
        f"{width:.2f}", f"{width / nucleation_length():.2f}", f"{largest:.2g}",
        f"{largest / LOADING_RATE:.3g}", recurrence, len(late_events),
    )


def outcome(store):
    shipped = store.run(cases.case("weakening patch", SCENE))
    runs = {
        half_width: shipped if half_width == 1.0 else store.run(cases.case(
            f"weakening patch, half width {half_width:g} m", SCENE,
            {"Faults/fault/b": patch(half_width), "Output/Write volume": "false",
             # One event may be small beside the whole fault.
             "Output/Event start slip rate": "1e-4"}))
        for half_width in HALF_WIDTHS
    }
    events = shipped.events("fault")
    text = (
        f"Nucleation length 2 G* b L / (pi sigma_n (b - a)^2): "
        f"{nucleation_length():.3f} m; process zone {process_zone():.3f} m.\n\n"
        + page.table(
            ("event", "start, s", "largest slip rate, m/s", "mean slip, mm"),
            [(k + 1, f"{events['start'][k]:.2f}", f"{events['peak_slip_rate'][k]:.3g}",
              f"{1e3 * events['mean_slip'][k]:.4f}")
             for k in range(len(events["start"]))])
        + f"\n1 mm/s is exceeded within {extent(shipped, 1e-3):.2f} m of the middle, "
        f"five times the loading rate within {extent(shipped, 5 * LOADING_RATE):.2f} m. "
        "Half length of what is slower than a tenth of the loading rate: "
        + ", ".join(f"{x:.2f} m after {share:g}" for share, x in creep(shipped))
        + " of the interval.\n\n" + afterslip_rows(shipped) + "\n"
        + page.table(
            ("width of b > a, m", "over the nucleation length", "largest slip rate, m/s",
             "over that of loading", "recurrence, s", "events from 430 s to 500 s"),
            [sweep_row(half_width, run) for half_width, run in runs.items()])
        + "\n" + page.table(cases.COST_TITLES, [cases.cost(shipped)])
    )
    return cases.Outcome(text, {"weakening_patch": lambda: draw(shipped, runs)})


def draw(shipped, runs):
    figure, axes = new_figure(4, height=11.0, ratios=(1.2, 1.2, 1, 1))
    history = FaultHistory(shipped.history(), "fault")
    start, peak, following = last_interval(shipped)
    draw_map(figure, axes[0], history, (400, 500), (1e-9, 2e-2))
    title(axes[0], "Slip rate along the fault: events in the patch, |x| < 1 m")

    draw_slip(axes[1], history, start, peak, following)
    for place, colour in zip(PLACES, (VERMILION, ORANGE, BLUE, GREEN)):
        point = Afterslip(shipped, place)
        slip = 1e6 * (point.slip - point.slip[0])
        axes[2].semilogx(point.time, slip, ".", color=colour, markersize=3,
                         label=f"x = {point.x:.2f} m")
        log_time = np.log(point.time[point.fitted])
        line = np.polyfit(log_time, slip[point.fitted], 1)
        axes[2].semilogx(point.time[point.fitted], np.polyval(line, log_time),
                         color=colour, linewidth=1)
    axes[2].set(xlabel="time since the largest slip rate of an event [s]",
                ylabel="slip [µm]", xlim=(1e-2, following - peak))
    axes[2].legend(loc="upper left")
    title(axes[2], "Afterslip beside the patch, and straight lines in ln t")

    ratios = [weakening_width(w) / nucleation_length() for w in runs]
    largest = [
        run.series()["fault.max_slip_rate"][run.series()["time"] > SETTLED].max()
        / LOADING_RATE for run in runs.values()
    ]
    axes[3].semilogy(ratios, largest, "o-", color=BLUE)
    axes[3].axvline(1, color=GREY, linewidth=0.8, linestyle=":")
    axes[3].set(xlabel="width of the patch / nucleation length",
                ylabel="largest slip rate / loading rate")
    axes[3].grid(alpha=0.3)
    title(axes[3], "Smaller and larger patches")
    return figure


def draw_slip(axes, history, start, peak, following):
    """Slip of one cycle along the fault."""
    first = np.argmin(np.abs(history.time - (start - 0.5)))
    slip = 1e6 * (history.field("slip") - history.field("slip")[first])
    moments = (
        (start, GREY, "start of the event"), (peak + 0.01, VERMILION, "10 ms after its peak"),
        (peak + 0.3, ORANGE, "0.3 s"), (peak + 3, GREEN, "3 s"),
        (following - 0.5, BLUE, "before the next event"),
    )
    for time, colour, label in moments:
        k = np.argmin(np.abs(history.time - time))
        axes.plot(history.x, slip[k], color=colour, label=label)
    axes.set(xlabel="x [m]", ylabel="slip [µm]", xlim=(-5, 5))
    axes.legend(loc="upper right")
    title(axes, "Slip of one cycle: the event, afterslip, and creep that comes in")
