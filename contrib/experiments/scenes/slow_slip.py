# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""The scene slow_slip.prm, and what becomes of it on both sides of the critical
stiffness.

The uniform block without ends is a spring slider: its slip rates are compared with
the linear theory of Rice and Ruina (1983) with radiation damping, and with an
ordinary differential equation, integrated by SciPy.
"""

import numpy as np
from scipy.integrate import solve_ivp

from common import page
from common.figures import (
    BLUE, GREY, ORANGE, VERMILION, draw_map, new_figure, title,
)
from experiments.results.history import FaultHistory

from . import cases

SCENE = "slow_slip"
A, B = 0.010, 0.015
LOADING_RATE = 2e-5
DENSITY, GRAVITY, THICKNESS = 5e3, 9.81, 1.0
SHEAR_MODULUS = 4.12e7 / (2 * 1.3)
STIFFNESS = SHEAR_MODULUS / THICKNESS
NORMAL_STRESS = DENSITY * GRAVITY * THICKNESS
# The foundation takes no waves.
RADIATION_DAMPING = np.sqrt(DENSITY * SHEAR_MODULUS)

RATIOS = (1.10, 1.05, 1.02, 1.00, 0.99, 0.97, 0.96, 0.95, 0.90, 0.85, 0.80, 0.70, 0.60,
          0.50)
# Those that are also started next to steady sliding.
GROWING = (0.96, 0.95, 0.90)
# s: fast loading, at which all of these are stable, fades to that of the scene.
GENTLE = "2e-5 * (1 + 9 * if(t < 15, 1, exp(-(t - 15) / 8)))"
# s: near neutral stability oscillations grow and decay slowly.
END, LONG_END, LONG_END_OF_BLOCK = 300.0, 1500.0, 600.0


def characteristic_slip(ratio):
    """L for k = ratio k_c."""
    return ratio * (B - A) * NORMAL_STRESS / STIFFNESS


def end_time(ratio, periodic=True):
    if periodic and ratio < 0.55:
        # Waves of the length of the block grow soon after that.
        return 200
    long = LONG_END if periodic else LONG_END_OF_BLOCK
    return long if 0.95 <= ratio < 1.1 else END


def settings(ratio, periodic, gentle=False):
    result = {
        "Faults/fault/Characteristic slip": f"{characteristic_slip(ratio):.10g}",
        "Time/End time": f"{end_time(ratio, periodic):g}",
        "Output/Write volume": "false",
    }
    if gentle:
        result["Time/End time"] = f"{END:g}"
    if periodic:
        result["Boundary conditions/Periodic along x"] = "true"
        result["Bodies/block/Refinement passes"] = "0"
    if gentle:
        result["Boundary conditions/block top/x value"] = GENTLE
        result["Faults/fault/Initial state"] = "0.1"
    return result


def linear_exponent(ratio):
    """Growth rate and angular frequency of small oscillations, in 1/s."""
    length = characteristic_slip(ratio)
    inertia = A * NORMAL_STRESS / LOADING_RATE + RADIATION_DAMPING
    middle = STIFFNESS - (
        (B - A) * NORMAL_STRESS - RADIATION_DAMPING * LOADING_RATE
    ) / length
    root = np.roots([inertia, middle, STIFFNESS * LOADING_RATE / length])[0]
    return root.real, abs(root.imag)


def neutral_ratio():
    """k/k_c at which radiation damping balances what grows."""
    return 1 - RADIATION_DAMPING * LOADING_RATE / ((B - A) * NORMAL_STRESS)


def measured_exponent(run, growing):
    """Growth rate and angular frequency of ln(V/V_load) where it is small, and the
    number of maxima they are from."""
    series = run.series()
    values = np.log(series["fault.mean_slip_rate"] / LOADING_RATE)
    time, peaks = cases.maxima(series["time"], values)
    low_times, lows = cases.maxima(series["time"], -values)
    # From a maximum to the mean of the minima next to it: what drifts drops out.
    amplitudes = (peaks + np.interp(time, low_times, lows)) / 2
    if growing:
        # After the fast loading, before the oscillation becomes large.
        chosen = np.flatnonzero(time > 85)[:5]
    else:
        chosen = np.flatnonzero(
            (amplitudes > 2e-4) & (amplitudes < 0.05) & (time > low_times[1]))
    time, amplitudes = time[chosen], amplitudes[chosen]
    if len(time) < 4:
        return np.nan, np.nan, len(time)
    growth = np.polyfit(time, np.log(amplitudes), 1)[0]
    period = np.polyfit(np.arange(len(time)), time, 1)[0]
    return growth, 2 * np.pi / period, len(time)


def cycle(time, rate):
    """Largest and least slip rate over the loading rate, and the period, in the last
    fifth of a run."""
    late = time > 0.8 * time[-1]
    values = np.log(rate / LOADING_RATE)
    times, peaks = cases.maxima(time, values)
    # Near its maximum the slip rate of a fast event wavers.
    chosen = (times > time[late][0]) & (peaks > max(0.01, 0.5 * values[late].max()))
    gaps = np.diff(times[chosen])
    gaps = gaps[gaps > 1]
    period = gaps.mean() if len(gaps) > 1 else np.nan
    return (
        rate[late].max() / LOADING_RATE, rate[late].min() / LOADING_RATE, period
    )


def slider(ratio):
    """The same of the ordinary differential equation, from a finite perturbation."""
    length = characteristic_slip(ratio)

    def derivative(_, y):
        rate = np.exp(y[0])
        state = np.exp(-y[1]) - rate / length
        acceleration = STIFFNESS * (LOADING_RATE - rate) - B * NORMAL_STRESS * state
        return acceleration / (A * NORMAL_STRESS + RADIATION_DAMPING * rate), state

    start = np.log(LOADING_RATE) + 3, np.log(length / LOADING_RATE)
    end = 2 * end_time(ratio)
    result = solve_ivp(
        derivative, (0, end), start, method="LSODA", rtol=1e-9, atol=1e-11,
        max_step=0.05,
    )
    return cycle(result.t, np.exp(result.y[0]))


def outcome(store):
    shipped = store.run(cases.case("slow slip", SCENE))
    uniform, blocks, gentle = {}, {}, {}
    for ratio in RATIOS:
        uniform[ratio] = store.run(cases.case(
            f"slow slip without ends, k/k_c = {ratio:.2f}", SCENE,
            settings(ratio, True)))
        blocks[ratio] = store.run(cases.case(
            f"slow slip, k/k_c = {ratio:.2f}", SCENE, settings(ratio, False)))
        if ratio in GROWING:
            gentle[ratio] = store.run(cases.case(
                f"slow slip without ends, gently loaded, k/k_c = {ratio:.2f}", SCENE,
                settings(ratio, True, gentle=True)))
    odes = {ratio: slider(ratio) for ratio in RATIOS}
    text = f"Steady sliding is neutrally stable at k/k_c = {neutral_ratio():.4f}.\n\n"
    text += exponents(uniform, gentle) + "\n" + cycles(uniform, odes, blocks) + "\n"
    text += page.table(cases.COST_TITLES, [cases.cost(shipped)])
    return cases.Outcome(
        text, {"slow_slip": lambda: draw(shipped, uniform, odes, blocks)}
    )


def exponents(uniform, gentle):
    rows = []
    for ratio in RATIOS:
        run = gentle.get(ratio) or uniform[ratio]
        growth, frequency, count = measured_exponent(run, ratio in gentle)
        if count < 4:
            continue
        theory = linear_exponent(ratio)
        rows.append((
            f"{ratio:.2f}", f"{theory[0]:.4f}", f"{growth:.4f}",
            f"{2 * np.pi / theory[1]:.3f}", f"{2 * np.pi / frequency:.3f}", count,
        ))
    return page.table(
        ("k/k_c", "growth rate, theory, 1/s", "measured", "period, theory, s",
         "measured", "from maxima"), rows)


def run_cycle(run, column="mean"):
    series = run.series()
    return cycle(series["time"], series[f"fault.{column}_slip_rate"])


def cycles(uniform, odes, blocks):
    rows = []
    for ratio in RATIOS:
        own, ode, block = run_cycle(uniform[ratio]), odes[ratio], run_cycle(blocks[ratio])
        starts = blocks[ratio].events("fault")["start"]
        starts = starts[starts > 0.8 * blocks[ratio].end()]
        rows.append((
            f"{ratio:.2f}", *(f"{v:.4g}" for v in (own[0], ode[0], own[1], ode[1])),
            *(f"{v:.3f}".replace("nan", "–") for v in (own[2], ode[2])),
            f"{block[0]:.3g}", f"{run_cycle(blocks[ratio], 'max')[0]:.3g}",
            f"{np.diff(starts).mean():.2f}" if len(starts) > 2 else "–",
        ))
    return page.table(
        ("k/k_c", "largest slip rate over that of loading", "ODE", "least", "ODE",
         "recurrence, s", "ODE", "block with ends: largest mean", "largest of a node",
         "recurrence, s"), rows)


def draw(shipped, uniform, odes, blocks):
    figure, axes = new_figure(3, height=9.0, ratios=(1, 1.2, 1.2))
    for ratio, colour in ((1.05, GREY), (0.95, BLUE), (0.90, ORANGE), (0.50, VERMILION)):
        series = uniform[ratio].series()
        axes[0].semilogy(series["time"], series["fault.mean_slip_rate"], color=colour,
                         linewidth=0.8, label=f"{ratio:.2f}")
    axes[0].set(xlim=(90, 200), ylim=(1e-7, 3e-2), xlabel="time [s]",
                ylabel="slip rate [m/s]")
    axes[0].axhline(LOADING_RATE, color="black", linewidth=0.6, linestyle=":")
    axes[0].legend(title="k/k_c", ncol=4, loc="upper right")
    title(axes[0], "Without ends: decaying oscillations, slow slip, fast events")

    draw_map(figure, axes[1], FaultHistory(shipped.history(), "fault"), (150, 180),
             limits=(1e-6, 2e-3))
    title(axes[1], "The scene as shipped: slip rate along the block, k/k_c = 0.90")

    fine = np.array(RATIOS)
    axes[2].axvline(neutral_ratio(), color="black", linewidth=0.6, linestyle=":",
                    label="neutrally stable with radiation damping")
    axes[2].semilogy(fine, [odes[r][0] for r in RATIOS], color=GREY,
                     label="spring slider (ODE)")
    axes[2].semilogy(fine, [run_cycle(uniform[r])[0] for r in RATIOS], "o", color=BLUE,
                     label="without ends")
    axes[2].semilogy(fine, [run_cycle(blocks[r])[0] for r in RATIOS], "s",
                     color=ORANGE, markersize=4, label="with ends: mean")
    axes[2].semilogy(fine, [run_cycle(blocks[r], "max")[0] for r in RATIOS], "^",
                     color=VERMILION, markersize=4, label="with ends: fastest node")
    axes[2].set(xlabel="k/k_c", ylabel="largest slip rate / loading rate",
                xlim=(1.12, 0.48))
    axes[2].legend(loc="upper left")
    axes[2].grid(alpha=0.3)
    title(axes[2], "Largest slip rate in the cycle that is left")
    return figure
