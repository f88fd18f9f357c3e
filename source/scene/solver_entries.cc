// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/entries.h>
#include <stickslip/scene/solver_entries.h>

namespace StickSlip
{
  void
  declare_solver_entries(ParameterHandler &prm, TNNMGParameters &parameters)
  {
    add_number(prm,
               "Tolerance",
               parameters.tolerance,
               NumberRange().above(0).below(1),
               "The iteration ends when the error, estimated from the last two "
               "corrections, is below this times the iterate, both in the "
               "energy norm, without unit. A third of Time/Tolerance adds "
               "nothing to the error of the time steps.");
    add_count(prm,
              "Largest number of iterations",
              parameters.max_iterations,
              1,
              100000,
              "More iterations than this are a failure.");
    add_number(prm,
               "Truncation factor",
               parameters.truncation_factor,
               NumberRange().above(0),
               "A node is left out of the linear correction where the least "
               "curvature of its friction exceeds this times the diagonal of "
               "the matrix, without unit.");
    add_choice(prm,
               "Linear correction",
               parameters.linear_correction,
               {{LinearCorrectionType::multigrid, "multigrid"},
                {LinearCorrectionType::umfpack, "UMFPACK"},
                {LinearCorrectionType::mumps, "MUMPS"}},
               "How the linearised problem of an iteration is solved: by some "
               "steps of conjugate gradients with the geometric multigrid "
               "method (multigrid, recommended), or exactly, by sparse "
               "factorisation with UMFPACK or MUMPS, for small problems and "
               "comparisons. UMFPACK and MUMPS run on one process only.");
    add_count(prm,
              "Cycles per correction",
              parameters.cycles_per_correction,
              1,
              1000,
              "Steps of conjugate gradients, each with one multigrid V-cycle, "
              "in a linear correction after the first ones.");
    add_count(prm,
              "Single-cycle corrections",
              parameters.single_cycle_corrections,
              0,
              1000,
              "So many corrections of each problem take one multigrid V-cycle "
              "only: a time step, which begins at its prediction, hardly needs "
              "more, and from far away the first ones need not be exact.");
    add_count(prm,
              "Smoothing sweeps",
              parameters.smoothing_sweeps,
              1,
              100,
              "Gauss-Seidel sweeps before and after each coarse grid "
              "correction.");
    add_number(prm,
               "Coarse update threshold",
               parameters.coarse_update_threshold,
               NumberRange().at_least(0),
               "The coarse levels, which only precondition, are given the "
               "curvature of the friction anew where it has changed by more "
               "than this fraction since the last time, without unit; 0: in "
               "every iteration.");
    add_choice(prm,
               "Cycle precision",
               parameters.cycle_precision,
               {{CyclePrecision::single_precision, "single"},
                {CyclePrecision::double_precision, "double"}},
               "The precision of matrices and vectors in the multigrid cycles, "
               "which only precondition; the solution is in double precision "
               "either way. Single precision is faster and takes as many "
               "iterations; double precision is for bodies whose stiffness "
               "differs by many orders of magnitude.");
    add_choice(prm,
               "Coarse solver",
               parameters.coarse_solver,
               {{CoarseSolverType::direct, "direct"},
                {CoarseSolverType::amg, "AMG"}},
               "How the coarsest level, which belongs to one process, is "
               "solved: by factorisation (direct), or, for coarse meshes of "
               "many thousand cells in three dimensions, by two cycles of "
               "algebraic multigrid (AMG).");
    add_switch(prm,
               "Print iterations",
               parameters.print_iterations,
               "Whether a line is printed for every iteration.");
  }
} // namespace StickSlip
