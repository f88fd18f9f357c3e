// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_algebraic_multigrid_h
#define stickslip_contrib_algebraic_multigrid_h

#include <memory>

#include "welded_problem.h"

namespace Measure
{
  /**
   * Smoothed aggregation with ML of Trilinos, with the translations and
   * rotations as near null space; has its own copy of the matrix.
   */
  template <int dim>
  class AlgebraicMultigrid
  {
  public:
    explicit AlgebraicMultigrid(const WeldedProblem<dim> &problem);

    ~AlgebraicMultigrid();

    /** Copy the matrix into the form of Trilinos. */
    void
    copy_matrix();

    void
    set_up();

    void
    vmult(Vector<double> &y, const Vector<double> &x) const;

  private:
    struct Implementation;

    const WeldedProblem<dim>       &problem;
    std::unique_ptr<Implementation> implementation;
  };



  /**
   * Factorisation with MUMPS through Amesos of Trilinos.
   */
  template <int dim>
  class MumpsSolver
  {
  public:
    explicit MumpsSolver(const WeldedProblem<dim> &problem);

    ~MumpsSolver();

    void
    factorise();

    void
    solve(Vector<double> &x, const Vector<double> &b);

  private:
    struct Implementation;

    std::unique_ptr<Implementation> implementation;
  };
} // namespace Measure

#endif
