// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_border_surplus_h
#define stickslip_multigrid_border_surplus_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The factor s >= 0 of a part S_i = s D_i of a diagonal block by which
   * Gauss-Seidel relaxes more cautiously at a node that couples to those of
   * other processes. All processes relax at the same time, and the cycle stays
   * a positive definite preconditioner if D + 2 S - C is positive definite,
   * where D are the diagonal blocks and C the couplings between processes;
   * without S it is not in three dimensions where cells are twice as wide as
   * thick and the borders are level.
   *
   * It is max(0, rho - 1) / 2 with rho the sum of the 2-norms of D_i^{-1} C_ij,
   * by which the theorem of Gershgorin bounds D^{-1} C. A larger one, up to
   * that of the l1 smoother, takes more iterations. Lines of nodes have
   * diagonal blocks that are weak for what is constant along them: rho is the
   * 2-norm of the sum of D_i^{-1} C_ij then, and 0.2 is there in place of 1,
   * which measurements have shown to be best.
   *
   * A. H. Baker, R. D. Falgout, T. V. Kolev and U. M. Yang, Multigrid smoothers
   * for ultraparallel computing, SIAM J. Sci. Comput. 33 (2011).
   *
   * @param inverse D_i^{-1}, zero for components that take no part.
   * @param couplings C_ij, to nodes of other processes.
   * @param has_lines Whether nodes are relaxed in lines.
   */
  template <int n_components>
  double
  border_surplus(const Tensor<2, n_components>              &inverse,
                 const std::vector<Tensor<2, n_components>> &couplings,
                 const bool                                  has_lines);
} // namespace StickSlip

#endif
