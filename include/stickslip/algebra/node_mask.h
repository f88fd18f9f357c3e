// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_node_mask_h
#define stickslip_algebra_node_mask_h

#include <stickslip/algebra/node_partition.h>

#include <cstdint>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The components of each node that take part in a linear problem. All others
   * (fixed by a boundary condition, determined by a hanging node constraint,
   * truncated) are masked: their corrections are zero.
   */
  class NodeMask
  {
  public:
    NodeMask() = default;

    /** All components of all nodes take part. */
    NodeMask(const unsigned int n_nodes, const unsigned int components);

    void
    mask(const unsigned int node, const unsigned int component);

    void
    mask_node(const unsigned int node);

    bool
    is_active(const unsigned int node, const unsigned int component) const
    {
      return (active[node] >> component) & 1u;
    }

    /** The components of the node that take part, one bit for each. */
    std::uint8_t
    active_components(const unsigned int node) const
    {
      return active[node];
    }

    /** Return whether all components of the node take part. */
    bool
    is_fully_active(const unsigned int node) const
    {
      return active[node] == full;
    }

    /** Return whether the components of the node that take part are the
     * same. */
    bool
    is_equal_at(const NodeMask &other, const unsigned int node) const
    {
      return active[node] == other.active[node];
    }

    unsigned int
    n_nodes() const
    {
      return active.size();
    }

    /** Number of components of a node. */
    unsigned int
    n_components() const
    {
      return components;
    }

    /** Number of masked components of the first @p n nodes. */
    unsigned int
    n_masked(const unsigned int n) const;

    /** Fetch the ghosts' part from their owners. Collective among
     * neighbours. */
    void
    update_ghosts(const NodePartition &nodes);

    /** Set the masked entries of @p vector to zero. */
    template <typename Number>
    void
    apply(NodeValues<Number> &vector) const;

    /** Return whether the masks of the first @p n nodes are the same. */
    bool
    is_equal(const NodeMask &other, const unsigned int n) const;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &components &full &active &restricted;
    }

  private:
    unsigned int              components = 0;
    std::uint8_t              full       = 0;
    std::vector<std::uint8_t> active;
    /** Nodes with a masked component. */
    std::vector<unsigned int> restricted;
  };
} // namespace StickSlip

#endif
