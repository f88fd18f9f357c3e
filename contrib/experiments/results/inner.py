# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The faults below the uppermost one: what their slip rates follow from."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.signal import butter, find_peaks, sosfiltfilt, welch

from . import layers
from .block import Block
from .history import FaultHistory

# s: equidistant times for spectra, and steps of the block before and in events.
STEP, QUIET_STEP, BLOCK_STEP = 1e-3, 0.02, 2e-3
# Hz
LARGEST_FREQUENCY = 45.0
# Between the events, 0.4 Hz, and the slowest vibration of the layers, 9 Hz.
SPLIT = 4.0
# s: around events, and after them.
MARGIN, SETTLED = 0.5, 0.1


def resampled(series, name, time):
    return np.interp(time, series["time"], series[name])


def block_times(first_event, last):
    """Coarse while only the load grows, fine from shortly before the first event."""
    quiet = np.arange(0.0, max(first_event - 0.5, BLOCK_STEP), QUIET_STEP)
    start = quiet[-1] + QUIET_STEP
    return np.concatenate((quiet, np.arange(start, last, BLOCK_STEP)))


def slip_on(x, history, time):
    """Slip of a fault at given positions and times: linear in x, and between records
    the cubic polynomials with their slips and slip rates. Straight lines would give the
    slip rate a jump at each record, which makes waves."""
    slip, rate = (
        np.stack([np.interp(x, history.x, record) for record in history.field(name)])
        for name in ("slip", "slip_rate")
    )
    return CubicHermiteSpline(history.time, slip, rate)(time)


def compare_with_block(run, first_event, last):
    """For each lower fault, from above: time in s, log10 of the mean slip rate in m/s,
    and mean traction in Pa, as computed and in the block whose top fault slips like the
    computed one while the lower ones are locked."""
    names = run.case.faults()
    model = Block()
    time = block_times(first_event, last)
    slip = slip_on(model.x, FaultHistory(run.history(), names[-1]), time)
    tractions = model.tractions(time, slip)
    share = model.width / model.width.sum()
    stresses, from_weight = model.under_weight()
    state = (layers.INITIAL_STATE + time)[:, None]
    results = []
    for k in reversed(range(len(names) - 1)):
        own = tractions[:, k] + from_weight[k]
        rate = np.exp(layers.log_rate(own, stresses[k], state)) @ share
        series = run.series()
        computed = np.maximum(series[f"{names[k]}.mean_slip_rate"], 1e-300)
        results.append({
            "fault": names[k],
            "time": time,
            "traction": resampled(series, f"{names[k]}.mean_shear_traction", time),
            "block_traction": own @ share,
            "rate": np.interp(time, series["time"], np.log10(computed)),
            "block_rate": np.log10(np.maximum(rate, 1e-300)),
        })
    return results


def agreement(result, first, last):
    """Means and standard deviations of the differences, computed less block, of log10
    of the slip rate and of the traction in Pa; correlation of the former."""
    chosen = (result["time"] > first) & (result["time"] < last)
    rate, block_rate = result["rate"][chosen], result["block_rate"][chosen]
    traction = (result["traction"] - result["block_traction"])[chosen]
    return {
        "rate_offset": float(np.mean(rate - block_rate)),
        "rate_deviation": float(np.std(rate - block_rate)),
        "rate_range": float(np.ptp(rate)),
        "correlation": float(np.corrcoef(rate, block_rate)[0, 1]),
        "traction_offset": float(np.mean(traction)),
        "traction_deviation": float(np.std(traction)),
    }


def distance_to_steady(run, fault):
    """Largest V theta / L, and by how much the state differs from pure ageing at
    most, in per cent."""
    history = FaultHistory(run.history(), fault)
    state = history.field("state")
    aged = layers.INITIAL_STATE + history.time[:, None]
    return {
        "largest": float((history.rate() * state).max() / layers.L),
        "healing": float(100 * np.abs(state / aged - 1).max()),
    }


def law_residual(run, fault):
    """How far log10 of the slip rate is from the friction law at the traction,
    normal stress and state of each node, at most, where there is traction."""
    history = FaultHistory(run.history(), fault)
    stress = history.field("normal_stress")
    traction = np.abs(history.field("shear_traction"))
    expected = layers.log_rate(traction, stress, history.field("state"))
    # Below, the truncated law has no slip.
    chosen = (history.time[:, None] > 1.0) & (traction > 0.05 * stress)
    with np.errstate(divide="ignore"):
        computed = np.log(history.rate())
    if not chosen.any():
        return float("nan")
    return float(np.abs(computed - expected)[chosen].max() / np.log(10))


def spectrum(run, fault, first, last, scale=1.0):
    """Frequencies in Hz and power density in Pa^2/Hz of the mean shear traction between
    two times. With a scale all is as fast as that many times."""
    series = run.series()
    time = np.arange(first, last, STEP)
    values = resampled(series, f"{fault}.mean_shear_traction", time)
    length = min(len(time), round(4.0 / scale / STEP))
    frequency, power = welch(values, fs=1 / STEP, nperseg=length, detrend="linear")
    chosen = frequency <= scale * LARGEST_FREQUENCY
    return frequency[chosen], power[chosen]


def peaks(frequency, power, least=SPLIT, count=6):
    """Frequencies in Hz of the highest maxima above the least one that stand out by a
    factor of two, in increasing order."""
    logarithm = np.log10(np.maximum(power, 1e-300))
    found, _ = find_peaks(logarithm, prominence=0.3)
    found = found[frequency[found] > least]
    highest = found[np.argsort(power[found])[::-1][:count]]
    return np.sort(frequency[highest])


def drop_and_ringing(run, fault, first, last):
    """What the top fault's events do to log10 of the mean slip rate of another one: its
    median over time, the mean drop over an event, of what varies slower than SPLIT, and
    the standard deviation of the rest between the events; all in decades."""
    series = run.series()
    time = np.arange(first, last, STEP)
    rate = np.maximum(series[f"{fault}.mean_slip_rate"], 1e-300)
    values = np.interp(time, series["time"], np.log10(rate))
    filters = butter(4, SPLIT, "highpass", fs=1 / STEP, output="sos")
    fast = sosfiltfilt(filters, values)
    # Left out is what the filter makes of the ends and of the drops in events.
    quiet = (time > first + MARGIN) & (time < last - MARGIN)
    drops = []
    events = run.events(run.case.top_fault())
    for start, end in zip(events["start"], events["end"]):
        quiet &= (time < start - MARGIN) | (time > end + MARGIN)
        if start > first + MARGIN and end < last - MARGIN:
            before, after = np.interp((start, end + SETTLED), time, values - fast)
            drops.append(before - after)
    return {
        "median": float(np.median(values)),
        "drop": float(np.mean(drops)) if drops else float("nan"),
        "ringing": float(np.std(fast[quiet])) if quiet.any() else float("nan"),
    }


def friction_work(run, fault):
    """What friction has taken on a fault since the start, in J per metre out of the
    plane: traction times slip rate, by the trapezoidal rule over all records."""
    history = FaultHistory(run.history(), fault)
    power = (history.field("shear_traction") * history.field("slip_rate"))
    power = power @ history.weight
    return float(np.sum(np.diff(history.time) * (power[1:] + power[:-1]) / 2))
