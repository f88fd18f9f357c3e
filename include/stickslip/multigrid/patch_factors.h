// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_patch_factors_h
#define stickslip_multigrid_patch_factors_h

#include <deal.II/base/aligned_vector.h>

#include <stickslip/algebra/node_mask.h>
#include <stickslip/multigrid/sweep_triangles.h>
#include <stickslip/multigrid/volume_cells.h>

#include <cstdint>
#include <vector>

namespace StickSlip
{
  /**
   * The inverses of the parts of a symmetric block matrix that belong to
   * patches of a few nodes, which may overlap. Masked components are left out:
   * rows and columns of theirs are zero.
   */
  template <int n_components, typename Number>
  class PatchFactors
  {
  public:
    PatchFactors() = default;

    /** @p n_nodes: of the matrix. */
    PatchFactors(const unsigned int            n_nodes,
                 const std::vector<NodePatch> &patches);

    unsigned int
    n_patches() const
    {
      return first_node.size() - 1;
    }

    unsigned int
    n_nodes(const unsigned int p) const
    {
      return first_node[p + 1] - first_node[p];
    }

    const unsigned int *
    nodes(const unsigned int p) const
    {
      return node.data() + first_node[p];
    }

    /** The number of nodes of the largest patch. */
    unsigned int
    largest() const;

    /** The row of a node has changed. */
    void
    touch(const unsigned int i);

    /** Set the diagonal block of a node, of which only the @p active components
     * take part. */
    void
    set_diagonal(const unsigned int             i,
                 const Tensor<2, n_components> &block,
                 const NodeMask                &active);

    /** Factorise the patches of nodes that have changed, whose couplings are
     * those of the matrix; nodes come by their numbers in it. */
    void
    factorise(const SweepTriangles<n_components, Number> &matrix);

    /** Subtract the product of the diagonal block of a node and x from @p s. */
    void
    subtract_diagonal(const unsigned int i, const Number *x, Number *s) const
    {
      const Number *block = diagonal.data() + std::size_t(i) * block_size;
      const Number *x_i   = x + std::size_t(i) * n_components;
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          s[c] -= block[Kernels::sweep_position<n_components>(c, d)] * x_i[d];
    }

    /** Add the solution for a right hand side, one node after the other, to
     * x at these nodes. */
    void
    add_solution(const unsigned int p, const Number *rhs, Number *x) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    static constexpr unsigned int block_size = n_components * n_components;

    /** The part of the matrix that belongs to a patch, row by row, zero where
     * components take no part. */
    void
    copy_patch(const unsigned int                          p,
               const SweepTriangles<n_components, Number> &matrix,
               std::vector<double>                        &entries) const;

    std::vector<unsigned int> first_node = {0};
    std::vector<unsigned int> node;
    /** Patches of the nodes. */
    std::vector<unsigned int> first_patch = {0};
    std::vector<unsigned int> patch;
    /** The first entry of each inverse, a full matrix, row by row. */
    std::vector<std::size_t> first_entry;
    AlignedVector<Number>    inverse;
    std::vector<bool>        is_current;
    /** By node: its diagonal block, as the kernels store it, and bits of the
     * components that take part. */
    std::vector<Number>       diagonal;
    std::vector<std::uint8_t> components;
  };
} // namespace StickSlip

#endif
