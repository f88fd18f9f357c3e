// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/amg_coarse_solver.h>
#include <stickslip/multigrid/coarse_solver.h>
#include <stickslip/multigrid/direct_coarse_solver.h>

namespace StickSlip
{
  template <int n_components>
  std::unique_ptr<CoarseSolver<n_components>>
  make_coarse_solver(const CoarseSolverType type,
                     const NodePartition   &nodes,
                     const LocalFrames     &frames)
  {
    if (type == CoarseSolverType::amg)
      return std::make_unique<AMGCoarseSolver<n_components>>(nodes, frames);
    return std::make_unique<DirectCoarseSolver<n_components>>();
  }



  template class CoarseSolver<1>;
  template class CoarseSolver<2>;
  template class CoarseSolver<3>;
  template std::unique_ptr<CoarseSolver<1>>
  make_coarse_solver<1>(const CoarseSolverType,
                        const NodePartition &,
                        const LocalFrames &);
  template std::unique_ptr<CoarseSolver<2>>
  make_coarse_solver<2>(const CoarseSolverType,
                        const NodePartition &,
                        const LocalFrames &);
  template std::unique_ptr<CoarseSolver<3>>
  make_coarse_solver<3>(const CoarseSolverType,
                        const NodePartition &,
                        const LocalFrames &);
} // namespace StickSlip
