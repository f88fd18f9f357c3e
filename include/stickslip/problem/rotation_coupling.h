// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_rotation_coupling_h
#define stickslip_problem_rotation_coupling_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/row_exchange.h>
#include <stickslip/mortar/jump_basis.h>

#include <map>

namespace StickSlip
{
  /**
   * A change of basis that makes the jumps of curved faults free of rotations:
   * where B_0 is the basis by rows of scalars (JumpBasis),
   *
   *   B = B_0 (1 - K),   B^-1 = (1 + K) B_0^-1,
   *
   * with blocks K_pq = averaging_factor_p R_p^T C_pq R_q from master nodes q to
   * the jumps at slave nodes p (MortarCoupling), between the axes R of both;
   * K^2 = 0, since no node is both. On the finest level only: transfers to
   * coarser ones keep B_0.
   *
   * Columns of K are columns of B_0 as well (JumpBasis sees to that), so that
   * the matrix B^T A B = (1 - K)^T (B_0^T A B_0) (1 - K) has the sparsity of
   * the one without K.
   *
   * Without curved faults K is zero, and nothing is stored or done.
   */
  template <int dim, int n_components = dim>
  class RotationCoupling
  {
  public:
    RotationCoupling() = default;

    /** The coupling of the active slave nodes of @p basis; @p frames: the axes
     * of all nodes, @p nodes, @p sparsity: of vectors and matrices in that
     * basis. Collective. */
    RotationCoupling(const JumpBasis<dim>           &basis,
                     const NodeFrames<n_components> &frames,
                     const NodePartition            &nodes,
                     const BlockSparsity            &sparsity);

    /** True if K is zero on all processes. */
    bool
    empty() const
    {
      return !is_needed;
    }

    /** w += factor K w. Collective among neighbours, like the next. */
    void
    add(const double factor, NodalVector &w) const;

    /** f += factor K^T f. */
    void
    add_transpose(const double factor, NodalVector &f) const;

    /** A becomes (1 - K)^T A (1 - K). */
    void
    transform(BlockMatrix<n_components> &A) const;

  private:
    /** The blocks of one slave node: local indices of master nodes. */
    using Row = std::vector<std::pair<unsigned int, Tensor<2, n_components>>>;

    bool         is_needed = false;
    unsigned int n_owned   = 0;
    /** Rows of owned and ghost slave nodes, by local index. */
    std::map<unsigned int, Row> rows;
    /** The shares of this process in rows of ghosts. */
    BlockSparsity ghost_rows;
    RowExchange   exchange;
  };
} // namespace StickSlip

#endif
