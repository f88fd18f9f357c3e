# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The figures of a run, section by section: titles and figures."""

from . import along_fault, geometry, over_fault, over_time, steps
from .style import panels, say


def over_whole_run(run, faults):
    unilateral = [fault for fault in faults if run.may_open(fault)]
    figure, axes = panels([2.4, 1.6, 1.6] + [1.8] * bool(unilateral))
    over_time.slip_rates(axes[0][0], run, faults)
    over_time.means(axes[1][0], run, faults, "mean_slip", "slip", "m")
    over_time.means(axes[2][0], run, faults, "mean_shear_traction", "shear traction",
                    "Pa")
    if unilateral:
        over_time.openings(axes[3][0], run, unilateral)
    return figure


def along_plane_fault(run, fault):
    """Of the whole run."""
    fields = run.fields(fault)
    opens = fields.has("gap")
    figure, axes = panels([2.4, 2.8, 2.2] + [2.2] * opens)
    along_fault.slip_rates(axes[0][0], fields)
    along_fault.slip_contours(axes[1][0], fields, run.events_of(fault))
    along_fault.shear_tractions(axes[2][0], fields)
    if opens:
        along_fault.gaps(axes[3][0], fields)
    return figure


def event_along(run, fault, event):
    """One event along a fault in the plane."""
    fields = run.fields(fault)
    opens = fields.has("gap")
    figure, axes = panels([2.6, 2.2] + [2.2] * opens)
    along_fault.slip_rates(axes[0][0], fields, event)
    along_fault.shear_tractions(axes[1][0], fields, event)
    if opens:
        along_fault.gaps(axes[2][0], fields, event)
    return figure


def profiles(run, fault, event):
    fields = run.fields(fault)
    columns = 2 + fields.has("gap")
    figure, axes = panels([2.4], columns)
    along_fault.profiles(axes[0], fields, event.window if event else run.times)
    return figure


def maps_over(run, fault, event):
    """Of a fault in space: what happens in an event, or in the whole run."""
    fields = run.fields(fault)
    n = over_fault.n_maps(fields, event)
    if fields.is_long:
        figure, axes = panels([2.0] * n)
        axes = axes[:, 0]
    else:
        figure, axes = panels([3.4] * ((n + 2) // 3), 3)
        axes = axes.ravel()
        for axis in axes[n:]:
            axis.axis("off")
    over_fault.maps(axes[: n - 1 if event else n], fields,
                    event.window if event else run.times)
    if event:
        over_fault.rupture_front(axes[n - 1], fields, event)
    return figure


def energy(run):
    figure, axes = panels([2.8])
    over_time.energies(axes[0][0], run)
    return figure


def work(run):
    figure, axes = panels([1.6, 1.1, 1.1, 1.3])
    steps.sizes(axes[0][0], run)
    steps.iterations(axes[1:, 0], run)
    return figure


def of_run(run, faults, number):
    """Titles and figures of all that is drawn of a run; NUMBER is that of an event of
    the first fault."""
    scene = geometry.draw(run)
    if scene is not None:
        yield "Bodies and faults", scene
    yield "Over time", over_whole_run(run, faults)
    for fault in faults:
        event = run.event(fault, number if fault == faults[0] else None)
        name = f"event {event.number} of {fault}" if event else ""
        if run.fields(fault).is_plane:
            yield f"Along {fault}", along_plane_fault(run, fault)
            if event:
                yield name.capitalize(), event_along(run, fault, event)
            yield f"Before and after {name or 'the whole run'}", profiles(
                run, fault, event)
        else:
            yield f"Over {fault}", maps_over(run, fault, None)
            if event:
                yield name.capitalize(), maps_over(run, fault, event)
    yield "Energy", energy(run)
    yield "Time steps", work(run)


def overview(run, faults, number):
    """One figure of what matters most."""
    fields = [run.fields(fault) for fault in faults]
    event = run.event(faults[0], number)
    unilateral = [fault for fault in faults if run.may_open(fault)]
    plane = fields[0].is_plane
    heights = [2.4] + [1.8] * bool(unilateral)
    if plane:
        heights += [2.4, 2.4] * len(fields)
    else:
        heights += [2.0 if f.is_long else 3.4 for f in fields]
    figure, axes = panels(heights + [1.4, 1.0, 1.0, 1.2])
    axes = iter(axes[:, 0])
    over_time.slip_rates(next(axes), run, faults)
    if unilateral:
        over_time.openings(next(axes), run, unilateral)
    for of_fault in fields:
        if plane:
            along_fault.slip_rates(next(axes), of_fault)
            axis = next(axes)
            if event:
                along_fault.slip_rates(axis, of_fault, event)
            else:
                say(axis, "no events")
        elif event:
            over_fault.rupture_front(next(axes), of_fault, event)
        else:
            over_fault.maps([next(axes)], of_fault, run.times)
    steps.sizes(next(axes), run)
    steps.iterations(list(axes), run)
    return figure
