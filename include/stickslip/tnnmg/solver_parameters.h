// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_solver_parameters_h
#define stickslip_tnnmg_solver_parameters_h

#include <stickslip/base/automatic_number.h>
#include <stickslip/multigrid/v_cycle.h>

namespace StickSlip
{
  /**
   * The ways to solve the linearised problem of an iteration.
   */
  enum class LinearCorrectionType
  {
    /** A few steps of CG, each with one V-cycle. */
    multigrid,
    /** Sparse factorisation with UMFPACK or MUMPS. */
    umfpack,
    mumps
  };

  /**
   * Settings of the truncated nonsmooth Newton multigrid iteration.
   */
  struct TNNMGParameters
  {
    /**
     * The iteration ends when the error, as IterationSummary::relative_error()
     * estimates it, is below this.
     */
    double tolerance = 1e-6;

    /** More iterations than this are a failure. */
    unsigned int max_iterations = 100;

    /**
     * A node is truncated where the least curvature of its nonsmooth term
     * exceeds this times the diagonal of the matrix.
     */
    double truncation_factor = 10.;

    /** The solver of the linearised problem. */
    LinearCorrectionType linear_correction = LinearCorrectionType::multigrid;

    /** Steps of CG, each with one V-cycle, in a linear correction at least. */
    unsigned int cycles_per_correction = 2;

    /** More are taken, up to a hundred, until the residual is expected to be so
     * small, relative to the initial one in the norm of the preconditioner; 1:
     * never more. */
    double linear_reduction = 0.05;

    /** The first corrections of a problem take one V-cycle each. */
    unsigned int single_cycle_corrections = 3;

    /** Gauss-Seidel sweeps before and after each coarse grid correction, a
     * whole number. */
    AutomaticNumber smoothing_sweeps = 1.;

    /**
     * The coarse levels are given the second derivative of the nonsmooth term
     * anew where it has changed by more than this fraction since the last time.
     */
    double coarse_update_threshold = 0.5;

    /** The precision of the cycles. */
    CyclePrecision cycle_precision = CyclePrecision::single_precision;

    /** The solver of the coarsest level. */
    CoarseSolverType coarse_solver = CoarseSolverType::direct;

    /** Print a line for every iteration. */
    bool print_iterations = false;

    /**
     * True if an iteration begins with the nonlinear smoother. Without it the
     * iteration is the semismooth Newton method with line search, for
     * comparisons. Truncated components would then never move, so that only
     * those are truncated at which the nonsmooth term has no second derivative
     * at all, not even a one-sided one, as at the kink of Coulomb's friction;
     * these keep their values, and the iteration may end short of the
     * minimiser.
     */
    bool nonlinear_smoothing = true;
  };
} // namespace StickSlip

#endif
