// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_linear_method_h
#define stickslip_contrib_linear_method_h

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "measurement.h"

namespace Measure
{
  /** Error of solutions, relative and in the energy norm: as much as rate
   * problems are asked for. */
  constexpr double tolerance = 1e-8;

  constexpr unsigned int max_iterations = 1000;



  /** One solver, ready to solve, and what has been measured of it. */
  struct Method
  {
    std::string             name;
    types::global_dof_index unknowns = 0;
    double                  meshes_s = 0, assembly_s = 0, preconditioner_s = 0;
    double                  bytes = 0, mesh_bytes = 0;
    /** Find what solve() needs to know and a user need not. */
    std::function<void()> prepare = []() {};
    /** Solve from zero; returns the numbers of iterations and cycles. */
    std::function<std::pair<unsigned int, unsigned int>()> solve;
    std::function<double()>                                error;
    unsigned int                                           repetitions = 1;

    std::pair<unsigned int, unsigned int> iterations;
    double solve_s = std::numeric_limits<double>::max();
  };



  /** The norm of x - y over that of y, in the energy norm. */
  template <typename Operator, typename VectorType>
  double
  relative_energy_error(const Operator   &A,
                        const VectorType &x,
                        const VectorType &y)
  {
    VectorType product = y, difference = x;
    A.vmult(product, y);
    const double size = y * product;
    difference -= y;
    A.vmult(product, difference);
    return std::sqrt(std::abs(difference * product) / size);
  }



  /** Solve by CG as exactly as rounding allows. */
  template <typename Operator, typename Preconditioner, typename VectorType>
  void
  solve_exactly(const Operator       &A,
                const Preconditioner &preconditioner,
                VectorType           &x,
                const VectorType     &b)
  {
    constexpr double reduction = 1e-14;
    x                          = 0.;
    SolverControl        control(max_iterations, reduction * b.l2_norm());
    SolverCG<VectorType> solver(control);
    solver.solve(A, x, b, preconditioner);
  }



  /** Steps of CG from zero that an error of at most the tolerance takes. */
  template <typename Operator, typename Preconditioner, typename VectorType>
  unsigned int
  count_steps(const Operator       &A,
              const Preconditioner &preconditioner,
              const VectorType     &b,
              const VectorType     &solution)
  {
    VectorType x = b;
    x            = 0.;
    // Any residual will do.
    SolverControl control(max_iterations, std::numeric_limits<double>::max());
    SolverCG<VectorType> solver(control);
    solver.connect(
      [&](const unsigned int, const double, const VectorType &iterate) {
        return relative_energy_error(A, iterate, solution) > tolerance ?
                 SolverControl::iterate :
                 SolverControl::success;
      });
    solver.solve(A, x, b, preconditioner);
    return control.last_step();
  }



  /** Take some steps of CG from zero. */
  template <typename Operator, typename Preconditioner, typename VectorType>
  void
  take_steps(const Operator       &A,
             const Preconditioner &preconditioner,
             VectorType           &x,
             const VectorType     &b,
             const unsigned int    n_steps)
  {
    x = 0.;
    IterationNumberControl control(n_steps, std::numeric_limits<double>::min());
    SolverCG<VectorType>   solver(control);
    solver.solve(A, x, b, preconditioner);
  }
} // namespace Measure

#endif
