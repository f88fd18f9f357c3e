# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scenes crossing_faults.prm and branching_fault.prm: what events of one fault do to
the other."""

import h5py
import numpy as np

from common import page
from common.figures import BLUE, GREY, VERMILION, new_figure, title

from . import cases

COLOURS = (VERMILION, BLUE)
# m/s: slower events are aftershocks next to the other fault, or creep.
LEAST_RATE = 1e-3


class Fault:
    """Mean fields and fields along one fault of a run, at nodes in contact."""

    def __init__(self, path, name):
        self.name = name
        with h5py.File(path, "r") as file:
            group = file[name]
            weight = group["weight"][...]
            order = np.argsort(group["arc_length"][...], kind="stable")
            self.nodes = order[weight[order] > 0]
            self.weight = weight[self.nodes] / weight[self.nodes].sum()
            self.points = group["coordinates"][...][self.nodes]
            self.along = group["arc_length"][...][self.nodes]
            self.time = group["time"][...]
            self.slip, self.rate, self.traction = (
                np.abs(group[field][...][:, self.nodes])
                for field in ("slip", "slip_rate", "shear_traction"))

    def mean(self, values):
        return values @ self.weight

    def at(self, time):
        """The last record up to a time."""
        return max(np.searchsorted(self.time, time, side="right") - 1, 0)

    def change(self, values, start, end):
        """Of a mean value between two times."""
        mean = self.mean(values)
        return mean[self.at(end)] - mean[self.at(start)]


class Pair:
    """A run of two faults, and its events that are fast, by start."""

    def __init__(self, run, names):
        self.run = run
        self.faults = [Fault(run.history(), name) for name in names]
        self.events = []
        for own, fault in enumerate(self.faults):
            events = run.events(fault.name)
            for k in np.flatnonzero(events["peak_mean_slip_rate"] > LEAST_RATE):
                if np.isfinite(events["end"][k]):
                    self.events.append(
                        {name: values[k] for name, values in events.items()}
                        | {"own": own})
        self.events.sort(key=lambda event: event["start"])

    def rows(self):
        for event in self.events:
            own, other = self.faults[event["own"]], self.faults[1 - event["own"]]
            window = event["start"], event["end"]
            yield (
                own.name, f"{event['start']:.2f}",
                f"{event['nucleation_arc_length']:.1f}",
                f"{1e3 * abs(event['mean_slip']):.2f}",
                f"{1e3 * other.change(other.slip, *window):.3f}",
                f"{own.change(own.traction, *window) / 1e3:.2f}",
                f"{other.change(other.traction, *window) / 1e3:.2f}",
            )

    def text(self):
        return (
            page.table(("event of", "begins at, s", "there, m", "mean slip, mm",
                        "of the other fault", "its mean shear traction, kPa",
                        "that of the other fault"), self.rows())
            + "\n" + page.table(cases.COST_TITLES, [cases.cost(self.run)]))

    def draw(self, shown):
        """@p shown: the number of the event that is looked at closely."""
        figure, axes = new_figure(3, 2, height=9.0, ratios=(1.1, 1, 1))
        event = self.events[shown]
        window = event["start"], event["end"]
        margin = 0.4 * (window[1] - window[0])
        begin, close = self.events[0]["start"] - 15, (window[0] - margin, window[1] + margin)
        for fault, colour in zip(self.faults, COLOURS):
            axes[0, 0].plot(*fault.points.T, color=colour, linewidth=2, label=fault.name)
            traction, rate = fault.mean(fault.traction) / 1e3, fault.mean(fault.rate)
            late = fault.time >= begin
            axes[0, 1].plot(fault.time[late], traction[late], color=colour, linewidth=0.9)
            inside = (fault.time >= close[0]) & (fault.time <= close[1])
            since = fault.time[inside] - window[0]
            axes[1, 0].plot(since, traction[inside], color=colour)
            axes[1, 1].semilogy(since, rate[inside], color=colour)
        axes[0, 0].set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
        axes[0, 0].legend()
        title(axes[0, 0], "The faults")
        axes[0, 1].set(xlim=(begin, self.run.end()), xlabel="time [s]", ylabel="kPa")
        title(axes[0, 1], "Mean shear tractions")
        axes[1, 0].set(xlabel="time since it began [s]", ylabel="kPa")
        title(axes[1, 0], f"... in the event of {event['fault']} at {event['start']:.1f} s")
        axes[1, 1].set(xlabel="time since it began [s]", ylabel="m/s")
        title(axes[1, 1], "Mean slip rates in it")
        for panel, fault, colour in zip(axes[2], self.faults, COLOURS):
            panel.plot(fault.along, fault.traction[fault.at(window[0])] / 1e3, color=GREY,
                       label="at its beginning")
            panel.plot(fault.along, fault.traction[fault.at(window[1])] / 1e3,
                       color=colour, label="at its end")
            panel.set(xlabel="position along the fault [m]", ylabel="kPa")
            panel.legend()
            title(panel, f"Shear traction along {fault.name}")
        for panel in axes.flat:
            panel.grid(alpha=0.3)
        return figure


def crossing(store):
    pair = Pair(store.run(cases.case("crossing faults", "crossing_faults")),
                ("rising", "falling"))
    return cases.Outcome(pair.text(), {"crossing_faults": lambda: pair.draw(0)})


def branching(store):
    pair = Pair(store.run(cases.case("branching fault", "branching_fault")),
                ("main", "branch"))
    # The branch does not slip in the largest event of the main fault alone.
    alone = [k for k, event in enumerate(pair.events) if event["fault"] == "main"
             and pair.faults[1].change(pair.faults[1].slip, event["start"],
                                       event["end"]) < 1e-6]
    shown = max(alone, key=lambda k: abs(pair.events[k]["mean_slip"]))
    return cases.Outcome(pair.text(), {"branching_fault": lambda: pair.draw(shown)})
