// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/node_mask.h>

namespace StickSlip
{
  NodeMask::NodeMask(const unsigned int n_nodes, const unsigned int components)
    : components(components)
    , full((1u << components) - 1)
    , active(n_nodes, full)
  {}



  void
  NodeMask::mask(const unsigned int node, const unsigned int component)
  {
    if (active[node] == full)
      restricted.push_back(node);
    active[node] &= ~(1u << component);
  }



  void
  NodeMask::mask_node(const unsigned int node)
  {
    for (unsigned int c = 0; c < components; ++c)
      mask(node, c);
  }



  bool
  NodeMask::is_active(const unsigned int node,
                      const unsigned int component) const
  {
    return (active[node] >> component) & 1u;
  }



  bool
  NodeMask::is_fully_active(const unsigned int node) const
  {
    return active[node] == full;
  }



  unsigned int
  NodeMask::n_nodes() const
  {
    return active.size();
  }



  unsigned int
  NodeMask::n_masked() const
  {
    unsigned int count = 0;
    for (const unsigned int node : restricted)
      for (unsigned int c = 0; c < components; ++c)
        count += !is_active(node, c);
    return count;
  }



  void
  NodeMask::apply(NodalVector &vector) const
  {
    double *values = vector.begin();
    for (const unsigned int node : restricted)
      for (unsigned int c = 0; c < components; ++c)
        if (!is_active(node, c))
          values[node * components + c] = 0;
  }



  bool
  NodeMask::operator==(const NodeMask &other) const
  {
    return active == other.active;
  }
} // namespace StickSlip
