// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_patch_factors_h
#define stickslip_multigrid_patch_factors_h

#include <deal.II/base/aligned_vector.h>

#include <stickslip/multigrid/volume_cells.h>

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

    /** Return if the patch has a node that has been touched since it was set
     * last. */
    bool
    is_outdated(const unsigned int p) const;

    /** Set a patch by its part of the matrix, row by row, with rows and columns
     * of components that take no part zero; destroys that. */
    void
    set_patch(const unsigned int p, std::vector<double> &entries);

    /** Add the solution for a right hand side, one node after the other, to
     * x at these nodes. */
    void
    add_solution(const unsigned int p, const Number *rhs, Number *x) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    std::vector<unsigned int> first_node = {0};
    std::vector<unsigned int> node;
    /** Patches of the nodes. */
    std::vector<unsigned int> first_patch = {0};
    std::vector<unsigned int> patch;
    /** The first entry of each inverse, a full matrix, row by row. */
    std::vector<std::size_t> first_entry;
    AlignedVector<Number>    inverse;
    std::vector<bool>        is_current;
    /** Work space. */
    std::vector<double> diagonal;
  };
} // namespace StickSlip

#endif
