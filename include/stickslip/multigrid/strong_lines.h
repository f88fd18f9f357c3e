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
   * each couples strongly to the next, in one of the matrices. With A_ij and
   * A_ii the blocks of such a matrix, the strength is
   *
   *   -sum_c (A_ij)_cc / sqrt(sum_c (A_ii)_cc sum_c (A_jj)_cc)
   *
   * over the components c that take part at both nodes. For elasticity in all
   * components it is that of the Laplacian, whatever Poisson's ratio: 0.12 for
   * square cells, 0.35 at an aspect of two, 0.42 of three, from where on there
   * are lines, and a half for very thin cells.
   *
   * A node has at most the two strongest neighbours that have it among theirs.
   * Lines of two need a strength of 0.7, which both ends of one have across a
   * layer of cells four times as wide as thick. In some of the components
   * alone nodes couple as strongly on square cells; so nonsmooth nodes and
   * those with fixed components are in lines only beside nodes that are
   * in one with all of their components, or if they couple like both ends of a
   * line of two. Nonsmooth nodes have no others beside them, since what couples
   * the jump of a fault to its other side is no mesh.
   *
   * The lines depend on neither coefficients of the matrices, which are
   * BlockMatrix or TermMatrix, nor truncation.
   */
  template <typename Matrix>
  std::vector<NodeLine>
  find_strong_lines(const BlockSparsity             &sparsity,
                    const std::vector<Matrix>       &matrices,
                    const NodeMask                  &fixed,
                    const std::vector<unsigned int> &nonsmooth_nodes);
} // namespace StickSlip

#endif
