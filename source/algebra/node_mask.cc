// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/node_mask.h>

#include <algorithm>

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



  unsigned int
  NodeMask::n_masked(const unsigned int n) const
  {
    unsigned int count = 0;
    for (const unsigned int node : restricted)
      for (unsigned int c = 0; c < components; ++c)
        count += (node < n && !is_active(node, c));
    return count;
  }



  void
  NodeMask::update_ghosts(const NodePartition &nodes)
  {
    AssertDimension(active.size(), nodes.n_local());
    if (nodes.nodes()->n_mpi_processes() == 1)
      return;
    const unsigned int n_owned = nodes.n_owned();
    NodalVector        masked  = nodes.make_vector();
    for (const unsigned int node : restricted)
      if (node < n_owned)
        for (unsigned int c = 0; c < components; ++c)
          if (!is_active(node, c))
            masked.local_element(node * components + c) = 1.;
    StickSlip::update_ghosts(masked);

    restricted.erase(std::remove_if(restricted.begin(),
                                    restricted.end(),
                                    [n_owned](const unsigned int node) {
                                      return node >= n_owned;
                                    }),
                     restricted.end());
    for (unsigned int i = n_owned; i < active.size(); ++i)
      {
        active[i] = full;
        for (unsigned int c = 0; c < components; ++c)
          if (masked.local_element(i * components + c) != 0.)
            mask(i, c);
      }
  }



  template <typename Number>
  void
  NodeMask::apply(NodeValues<Number> &vector) const
  {
    Number *values = vector.begin();
    for (const unsigned int node : restricted)
      for (unsigned int c = 0; c < components; ++c)
        if (!is_active(node, c))
          values[node * components + c] = 0;
  }



  bool
  NodeMask::is_equal(const NodeMask &other, const unsigned int n) const
  {
    return std::equal(active.begin(), active.begin() + n, other.active.begin());
  }



  template void
  NodeMask::apply<double>(NodalVector &) const;
  template void
  NodeMask::apply<float>(NodeValues<float> &) const;
} // namespace StickSlip
