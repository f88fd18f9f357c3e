// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_strong_lines_h
#define stickslip_multigrid_strong_lines_h

#include <stickslip/algebra/operator_sum.h>

#include <vector>

namespace StickSlip
{
  /** Nodes one after the other, of which neighbours couple strongly. */
  using NodeLine = std::vector<unsigned int>;

  /**
   * The lines along which a smoother that takes one node after the other fails,
   * found from matrices with the @p sparsity: chains of owned nodes in which
   * each couples to the next as strongly as to nearly nothing else, in all
   * components and in one of the matrices. With A_ij and A_ii the blocks of
   * such a matrix, the strength is the least of
   *
   *   -(A_ij)_cc / sqrt((A_ii)_cc (A_jj)_cc)
   *
   * over the components c that take part at both nodes: a half along long rows
   * of thin cells, 0.4 from an aspect of about five on, negative for elasticity
   * on square cells. A node has at most the two strongest neighbours that have
   * it among theirs. Lines of two need more strength, 0.5, as across thin
   * layers. Nonsmooth nodes have no others beside them, since what
   * couples the jump of a fault to its other side is no mesh.
   */
  template <int n_components, typename Number>
  std::vector<NodeLine>
  find_strong_lines(
    const BlockSparsity                                  &sparsity,
    const std::vector<BlockMatrix<n_components, Number>> &matrices,
    const NodeMask                                       &fixed,
    const std::vector<unsigned int>                      &nonsmooth_nodes);
} // namespace StickSlip

#endif
