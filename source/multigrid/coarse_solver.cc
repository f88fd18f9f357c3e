// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/amg_coarse_solver.h>
#include <stickslip/multigrid/coarse_solver.h>
#include <stickslip/multigrid/direct_coarse_solver.h>

namespace StickSlip
{
  template <int dim>
  std::unique_ptr<CoarseSolver<dim>>
  make_coarse_solver(const CoarseSolverType type)
  {
    if (type == CoarseSolverType::amg)
      return std::make_unique<AMGCoarseSolver<dim>>();
    return std::make_unique<DirectCoarseSolver<dim>>();
  }



  template class CoarseSolver<2>;
  template class CoarseSolver<3>;
  template std::unique_ptr<CoarseSolver<2>>
  make_coarse_solver<2>(const CoarseSolverType);
  template std::unique_ptr<CoarseSolver<3>>
  make_coarse_solver<3>(const CoarseSolverType);
} // namespace StickSlip
