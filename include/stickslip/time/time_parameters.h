// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_time_parameters_h
#define stickslip_time_time_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/base/automatic_number.h>
#include <stickslip/friction/state_evolution.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Control of the step size.
   */
  enum class StepSizeControl
  {
    /** Error estimate from the history, one solve per step; the default. */
    embedded,
    /** One step of 2 tau against two of tau, as published. */
    step_doubling,
    /** Always the largest step. */
    constant,
    /** Explicit steps of fifth order, without mass and viscosity. */
    runge_kutta,
    /** Explicit steps of one size, with lumped mass. */
    central_differences
  };

  /**
   * Inertia of the bodies as far as it is part of the model.
   */
  enum class Inertia
  {
    /** All of it; the default. */
    dynamic,
    /** Only what waves that leave a fault take from it: radiation damping. */
    quasi_dynamic,
    /** Nothing. */
    quasi_static
  };

  /**
   * Iteration between the rate and the state problem of a step.
   */
  enum class RateStateMethod
  {
    /** One iteration of the rate solver for each state update. */
    interleaved,
    /** Each rate problem is solved before the state is updated, as published.
     */
    nested
  };

  /**
   * Solver of the rate problem.
   */
  enum class RateSolver
  {
    /** The one of the others that choose_rate_solver() expects to be faster. */
    automatic,
    /** On all of the bodies, by truncated nonsmooth Newton multigrid. */
    tnnmg,
    /** Condensed to the faults, by Newton's method with dense matrices. */
    condensed_newton
  };

  /**
   * Settings of the time stepping.
   */
  struct TimeParameters
  {
    /** Simulated time at the end, s. */
    double end_time = 60.;

    StepSizeControl control = StepSizeControl::embedded;

    /** Errors that the embedded control allows in a step, see StepError. */
    double tolerance = 1.3e-6, body_tolerance = 1e-3;

    /** Energy that contacts may take in a step, over the kinetic energy. */
    double impact_tolerance = 1e-3;

    /** Threshold of the step doubling control: largest difference of ln theta
     * between one step and two in the fault_norm(). */
    double doubling_threshold = 4.5e-6;

    /** Step sizes, s. The step sizes used are largest_step 2^-k. */
    double          initial_step  = 1e-3;
    double          smallest_step = 1e-9;
    AutomaticNumber largest_step  = 0.5;

    /**
     * No step is longer than this fraction of the longest loading ramp while
     * the ramp lasts: the error estimates see nothing of a load to come.
     */
    double ramp_fraction = 0.025;

    /** Error allowed in what loads do in a step, relative. */
    double loading_tolerance = 1e-4;

    /** Times at which steps end, s: as given, and all of them in ascending
     * order, see load_breaks(). Constant steps do not follow them. */
    std::vector<double> load_times, step_ends;

    Inertia inertia = Inertia::dynamic;

    StateUpdate state_update = StateUpdate::exponential;

    RateStateMethod rate_state_method = RateStateMethod::interleaved;

    RateSolver rate_solver = RateSolver::tnnmg;

    /** The rate-state iteration ends when the state changes less, in the
     * fault_norm(). */
    double rate_state_tolerance = 4.5e-7;

    /** More iterations than this reject the step. */
    unsigned int max_rate_state_iterations = 100;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
