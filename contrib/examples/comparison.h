// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_examples_comparison_h
#define stickslip_examples_comparison_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <stickslip/tnnmg/nonsmooth_solver.h>

#include <iostream>
#include <memory>

#include "active_set.h"
#include "refinement_levels.h"

/**
 * Both methods on a sequence of meshes, and the table of their iterations and
 * times.
 */
namespace StickSlip::Examples
{
  /**
   * Solve a problem by both methods, from the result on a coarser mesh if there
   * is one, and add a line to the table.
   */
  template <int n_components, typename Problem>
  void
  compare(Problem &problem, const Problem *coarser, TableHandler &table)
  {
    problem.solution.reinit(problem.A.m());
    if (coarser)
      interpolate<n_components>(coarser->dof_handler,
                                coarser->solution,
                                problem.dof_handler,
                                problem.solution);
    Vector<double> &u = problem.solution, v = u;

    Timer              timer;
    const SolveSummary tnnmg         = problem.solve_by_tnnmg(u);
    const double       tnnmg_seconds = timer.cpu_time();
    AssertThrow(tnnmg.converged, ExcMessage("TNNMG did not converge."));

    timer.restart();
    const ActiveSetSummary active_set         = problem.solve_by_active_set(v);
    const double           active_set_seconds = timer.cpu_time();
    AssertThrow(active_set.converged,
                ExcMessage("The active set method did not converge."));

    const double size = std::sqrt(problem.A.matrix_norm_square(v));
    v -= u;
    problem.add_columns(table);
    table.add_value("TNNMG",
                    static_cast<unsigned int>(tnnmg.iterations.size()));
    table.add_value("V-cycles", tnnmg.n_cycles());
    table.add_value("seconds", tnnmg_seconds);
    table.add_value("active set", active_set.iterations);
    table.add_value("AMG cycles", active_set.cg_steps);
    table.add_value("its seconds", active_set_seconds);
    table.add_value("difference",
                    std::sqrt(problem.A.matrix_norm_square(v)) / size);
  }



  /** The program: problems on meshes with 1, 2, ... refinements, as many as the
   * user says, 6 without. */
  template <int n_components, typename Problem>
  int
  compare_on_meshes(int argc, char *argv[])
  {
    Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

    const unsigned int finest =
      argc > 1 ? Utilities::string_to_int(argv[1]) : 6;
    TableHandler             table;
    std::unique_ptr<Problem> coarser;
    for (unsigned int n = 1; n <= finest; ++n)
      {
        auto problem = std::make_unique<Problem>(n);
        compare<n_components>(*problem, coarser.get(), table);
        coarser = std::move(problem);
      }
    table.set_precision("seconds", 3);
    table.set_precision("its seconds", 3);
    table.set_scientific("difference", true);
    table.set_precision("difference", 1);
    table.write_text(std::cout, TableHandler::org_mode_table);
    return 0;
  }
} // namespace StickSlip::Examples

#endif
