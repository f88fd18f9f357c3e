// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_rate_solver_choice_h
#define stickslip_time_rate_solver_choice_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/time/time_parameters.h>
#include <stickslip/tnnmg/solver_parameters.h>

#include <string>

namespace StickSlip
{
  /**
   * Numbers that tell the faster solver of the rate problems of a run.
   */
  struct RateProblemSize
  {
    unsigned int dimension = 2, n_processes = 1;

    /** Unknowns that are not fixed: of all, and those at nodes of faults. */
    unsigned int n_unknowns = 0, n_on_faults = 0;

    /** True if the operators of all step sizes are multiples of one. */
    bool has_one_operator = false;

    /** TNNMG/Tolerance. */
    double tolerance = 1e-6;

    /** Memory that the machine has, bytes. */
    double memory = 0;
  };

  /**
   * A solver and the reason for it, a part of a sentence.
   */
  struct RateSolverChoice
  {
    RateSolver  solver = RateSolver::tnnmg;
    std::string reason;
  };

  /** The name of the solver as the entry has it, and the reason. */
  std::string
  text_of(const RateSolverChoice &choice);

  /** Memory of the dense matrices and the factors of all operators that the
   * condensed solver keeps, bytes. */
  double
  condensed_memory(const RateProblemSize &size);

  /**
   * The time that the condensed solver is expected to take over that of TNNMG,
   * in two dimensions on one process: a formula through the measurements of
   * doc/performance.md. Where faults open or slide through many contact
   * mappings it may be off by a factor of two to three.
   */
  double
  condensed_over_tnnmg(const RateProblemSize &size);

  /**
   * The solver that is expected to be faster, TNNMG or condensed Newton. It
   * follows from numbers alone and not from times, so that a run is the same
   * each time.
   */
  RateSolverChoice
  choose_rate_solver(const RateProblemSize &size);

  /**
   * The solver of a run: the one that is asked for, without a reason, or the
   * one that is expected to be faster. The same for all contact mappings of the
   * run. Collective.
   */
  template <int dim, int n_components>
  RateSolverChoice
  choose_rate_solver(const TimeParameters                    &parameters,
                     const TNNMGParameters                   &tnnmg,
                     const SpatialProblem<dim, n_components> &problem);
} // namespace StickSlip

#endif
