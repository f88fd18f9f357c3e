// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/entries.h>
#include <stickslip/time/time_parameters.h>

namespace StickSlip
{
  void
  TimeParameters::add_parameters(ParameterHandler &prm)
  {
    add_number(prm,
               "End time",
               end_time,
               NumberRange().above(0).in("s"),
               "Simulated time at the end of the run, in s.");
    add_choice(
      prm,
      "Step size control",
      control,
      {{StepSizeControl::embedded, "embedded"},
       {StepSizeControl::step_doubling, "step doubling"},
       {StepSizeControl::constant, "constant"},
       {StepSizeControl::runge_kutta, "Runge-Kutta"},
       {StepSizeControl::central_differences, "central differences"}},
      "How the step size is chosen: an error estimate from the past "
      "steps, one step of double size against two, or always the "
      "largest step. Runge-Kutta: explicit steps of fifth order by "
      "Dormand and Prince with the error that these tell, on the "
      "faults alone, with a dense matrix; only with 'Inertia' = "
      "'quasi-dynamic', bodies without viscosity and faults that do "
      "not open. central differences: explicit steps with a lumped "
      "mass, of 0.9 of their stability limit or, where the error "
      "estimate asks for it, of that over a power of two; only with "
      "'Inertia' = 'dynamic', faults that do not open and normal "
      "stresses that do not follow the slip. They pay where the "
      "smallest cells are not far smaller than those that the accuracy "
      "needs. Neither of them solves rate problems.");
    add_number(
      prm,
      "Tolerance",
      tolerance,
      NumberRange().above(0),
      "Error allowed on the faults in a step under the embedded control, with "
      "central differences and in Runge-Kutta steps, without unit: the root "
      "of the mean square over a fault of the error of the logarithm of the "
      "state and, at each node, of the smaller one of two: the error of the "
      "friction coefficient over the larger one of a and b, times the normal "
      "stress over its mean; or that of the slip rate over the largest one of "
      "the fault. Squares of several faults add up, and nodes with a "
      "prescribed slip rate do not count. Before three steps have been taken, "
      "the state alone does. In Runge-Kutta steps the errors are those of the "
      "logarithm of the state and of the slip over the characteristic slip.");
    add_number(
      prm,
      "Body tolerance",
      body_tolerance,
      NumberRange().above(0),
      "Error of the velocity of the bodies allowed in a step under the "
      "embedded control and with central differences, without unit: its mean, "
      "weighted by the mass and by itself, times the impedance of shear "
      "waves, over the larger one of a and b times the normal stress (of the "
      "fault where these are least): what the error of waves brings to the "
      "faults; over the mean speed of the bodies where sides may open and none "
      "of that friction touch. Its square root is the longest step in which "
      "sides meet, or have just met or parted, over the time that shear waves "
      "take through half a cell at the fault. Used only with 'Inertia = "
      "dynamic', after three steps, and where friction is rate and state.");
    add_number(prm,
               "Impact tolerance",
               impact_tolerance,
               NumberRange().above(0),
               "Energy that sides which come together may take in a step, over "
               "the kinetic energy of the bodies, without unit. A step that "
               "takes more is split at the moment of contact, if that takes "
               "less. Used only with 'Inertia = dynamic' and faults that may "
               "open.");
    add_number(prm,
               "Doubling threshold",
               doubling_threshold,
               NumberRange().above(0),
               "Difference allowed between one step and two under step "
               "doubling, of the logarithm of the state: the root of the mean "
               "square over a fault, without unit. Squares of several faults "
               "add up.");
    add_number(prm,
               "Initial step",
               initial_step,
               NumberRange().above(0).in("s"),
               "Size of the first step, in s.");
    add_number(prm,
               "Smallest step",
               smallest_step,
               NumberRange().above(0).in("s"),
               "The run stops with a message where an even smaller step would "
               "be needed, in s.");
    add_number(prm,
               "Largest step",
               largest_step,
               NumberRange().above(0).in("s"),
               "Largest size of a step, in s; smaller steps are this divided "
               "by powers of two. auto: 0.5 s; in runs of more than 1000 s "
               "1/2000 of 'End time', but not more than five times the "
               "shortest characteristic slip over the largest prescribed "
               "velocity, and not less than 0.5 s or the initial step.");
    add_number(prm,
               "Ramp fraction",
               ramp_fraction,
               NumberRange().above(0).at_most(1),
               "No step is longer than this fraction of the longest loading "
               "ramp while that lasts, without unit.");
    add_number(prm,
               "Loading tolerance",
               loading_tolerance,
               NumberRange().above(0),
               "Error allowed in the displacement of driven sides and in the "
               "impulse of tractions over a step, over the step times their "
               "largest velocity and traction so far, without unit; for loads "
               "that depend on time, after the ramp. No step becomes shorter "
               "than the initial one for that. Not used by constant steps.");
    add_numbers(prm,
                "Load times",
                load_times,
                NumberRange().at_least(0).in("s").any_number_of(),
                "Times at which steps end, in s, besides those at which "
                "prescribed velocities and tractions jump or have a kink: such "
                "times are found by themselves where they are 1/20000 of 'End "
                "time' or more from each other, at the corners and centres of "
                "sides. Not used by constant steps.");
    add_choice(
      prm,
      "Inertia",
      inertia,
      {{Inertia::dynamic, "dynamic"},
       {Inertia::quasi_dynamic, "quasi-dynamic"},
       {Inertia::quasi_static, "quasi-static"}},
      "What of the mass of the bodies counts: all of it, with waves "
      "(dynamic); or nothing but a traction against the slip, eta V, "
      "for the shear waves that a fault sends into the bodies, with "
      "1/eta the sum of 1/sqrt(density times shear modulus) of both "
      "sides (quasi-dynamic, Rice 1993); or nothing at all "
      "(quasi-static). In the last case slip rates can grow without bound "
      "once a fault has become unstable, and the run ends there with a "
      "message. Without mass there is no matrix of it, and each step "
      "takes backward differences of second order.");
    add_choice(prm,
               "State update",
               state_update,
               {{StateUpdate::exponential, "exponential"},
                {StateUpdate::implicit_euler, "implicit Euler"}},
               "How the state is advanced by a step: by the exact solution for "
               "the mean slip rate (second order), or by an implicit Euler "
               "step (first order).");
    add_choice(prm,
               "Rate-state method",
               rate_state_method,
               {{RateStateMethod::interleaved, "interleaved"},
                {RateStateMethod::nested, "nested"}},
               "Whether the state is updated after each iteration of the rate "
               "solver (interleaved) or after each converged solve (nested).");
    add_choice(prm,
               "Rate solver",
               rate_solver,
               {{RateSolver::automatic, "automatic"},
                {RateSolver::tnnmg, "TNNMG"},
                {RateSolver::condensed_newton, "condensed Newton"}},
               "How the rate problem is solved: on all of the bodies by "
               "multigrid (TNNMG), which suits every scene; or on the unknowns "
               "of the faults alone (condensed Newton), after a factorisation "
               "of the bodies for each step size, or a single one where they "
               "have neither mass nor viscosity, which pays where few step "
               "sizes occur and the faults have at most some hundred nodes. "
               "The latter needs memory and time that grow with the square and "
               "the cube of the number of fault unknowns, takes its tolerance "
               "from the section TNNMG, and runs on one process only. The "
               "program chooses (automatic) by numbers of unknowns, step sizes "
               "with one operator, tolerance, dimension, processes and memory, "
               "and says what and why at the start and in summary.txt.");
    add_number(prm,
               "Rate-state tolerance",
               rate_state_tolerance,
               NumberRange().above(0),
               "The rate-state iteration ends when the logarithm of the state "
               "changes less than this, and less than this in all further "
               "iterations together if they go on as the last one: the root "
               "of the mean square over a fault, without unit. Squares of "
               "several faults add up.");
    add_count(prm,
              "Largest number of rate-state iterations",
              max_rate_state_iterations,
              1,
              100000,
              "More rate-state iterations than this reject the step.");
  }
} // namespace StickSlip
