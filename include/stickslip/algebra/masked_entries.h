// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_masked_entries_h
#define stickslip_algebra_masked_entries_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>

namespace StickSlip
{
  /**
   * The scalar entry (c, d) of the block at a @p position in a @p row, where
   * rows and columns of masked components are those of the identity.
   */
  template <int n_components>
  inline double
  masked_entry(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask,
               const unsigned int               row,
               const unsigned int               position,
               const unsigned int               c,
               const unsigned int               d)
  {
    const unsigned int column = matrix.sparsity().column[position];
    if (mask.is_active(row, c) && mask.is_active(column, d))
      return matrix.block(position)[c * n_components + d];
    return row == column && c == d ? 1. : 0.;
  }



  /**
   * All masked entries, scalar row after scalar row, each from its first column
   * to its last one.
   */
  template <int n_components>
  inline void
  write_masked_entries(const BlockMatrix<n_components> &matrix,
                       const NodeMask                  &mask,
                       double                          *value)
  {
    const BlockSparsity &sparsity = matrix.sparsity();
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          for (unsigned int d = 0; d < n_components; ++d)
            *value++ = masked_entry(matrix, mask, i, k, c, d);
  }



  /**
   * The inverse of the part of a node's diagonal @p block that belongs to
   * active components, zero elsewhere. As a call it would take 3 % of the time
   * of a rate problem on small meshes, where each sweep goes over all nodes.
   */
  template <int n_components>
  inline DEAL_II_ALWAYS_INLINE Tensor<2, n_components>
  invert_active(const Tensor<2, n_components> &block,
                const NodeMask                &active,
                const unsigned int             node)
  {
    if (active.is_fully_active(node))
      return invert(block);
    Tensor<2, n_components> result = block;
    for (unsigned int c = 0; c < n_components; ++c)
      if (!active.is_active(node, c))
        {
          for (unsigned int d = 0; d < n_components; ++d)
            result[c][d] = result[d][c] = 0.;
          result[c][c] = 1.;
        }
    result = invert(result);
    for (unsigned int c = 0; c < n_components; ++c)
      if (!active.is_active(node, c))
        result[c][c] = 0.;
    return result;
  }
} // namespace StickSlip

#endif
