// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_examples_active_set_h
#define stickslip_examples_active_set_h

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/vector.h>

#include <functional>

/**
 * The primal-dual active set method (Hintermueller, Ito and Kunisch 2003) with
 * the classes of deal.II, which the examples compare with. It is a semismooth
 * Newton method: from the last iterate the unknowns are divided into those with
 * prescribed values and the others, and a linear problem gives the next
 * iterate, until the division repeats itself.
 */
namespace StickSlip::Examples
{
  using namespace dealii;

  /** Outcome of the active set method. */
  struct ActiveSetSummary
  {
    bool         converged  = false;
    unsigned int iterations = 0, cg_steps = 0;
  };

  /**
   * One division of the unknowns: where the value is prescribed, and which, and
   * the forces on the others.
   */
  struct Division
  {
    std::vector<bool>   is_prescribed;
    std::vector<double> values;
    Vector<double>      load;

    bool
    operator==(const Division &other) const
    {
      return is_prescribed == other.is_prescribed && load == other.load;
    }
  };

  /**
   * Solve the linear problem of a division by conjugate gradients with
   * Trilinos' algebraic multigrid method, from @p u, to a residual of 1e-10
   * times @p force. Returns the steps.
   *
   * Rows and columns of prescribed unknowns are those of a diagonal matrix.
   */
  inline unsigned int
  solve_division(const SparseMatrix<double>           &A,
                 const Division                       &division,
                 const double                          force,
                 const std::vector<std::vector<bool>> &constant_modes,
                 Vector<double>                       &u)
  {
    for (unsigned int i = 0; i < u.size(); ++i)
      if (division.is_prescribed[i])
        u(i) = division.values[i];
    Vector<double> residual(u.size()), change(u.size());
    A.residual(residual, u, division.load);

    SparseMatrix<double> reduced(A.get_sparsity_pattern());
    for (unsigned int i = 0; i < A.m(); ++i)
      {
        if (division.is_prescribed[i])
          residual(i) = 0.;
        auto target = reduced.begin(i);
        for (auto entry = A.begin(i); entry != A.end(i); ++entry, ++target)
          if (entry->column() == i ||
              (!division.is_prescribed[i] &&
               !division.is_prescribed[entry->column()]))
            target->value() = entry->value();
      }

    TrilinosWrappers::PreconditionAMG                 amg;
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.constant_modes = constant_modes;
    amg.initialize(reduced, data);
    SolverControl            control(1000, 1e-10 * force);
    SolverCG<Vector<double>> cg(control);
    cg.solve(reduced, change, residual, amg);
    u += change;
    return control.last_step();
  }



  /**
   * Iterate from @p u. @p divide finds the division from an iterate u and the
   * reaction A u - b there.
   */
  inline ActiveSetSummary
  solve_by_active_set(
    const SparseMatrix<double>           &A,
    const Vector<double>                 &b,
    const std::vector<std::vector<bool>> &constant_modes,
    const std::function<Division(const Vector<double> &u,
                                 const Vector<double> &reaction)> &divide,
    Vector<double>                                                &u)
  {
    constexpr unsigned int max_iterations = 500;

    ActiveSetSummary summary;
    Vector<double>   reaction(u.size());
    Division         last;
    while (summary.iterations < max_iterations)
      {
        A.residual(reaction, u, b);
        reaction *= -1.;
        Division division = divide(u, reaction);
        if (summary.iterations > 0 && division == last)
          {
            summary.converged = true;
            break;
          }
        ++summary.iterations;
        summary.cg_steps +=
          solve_division(A, division, b.l2_norm(), constant_modes, u);
        last = std::move(division);
      }
    return summary;
  }
} // namespace StickSlip::Examples

#endif
