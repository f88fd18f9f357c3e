// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_some_ghosts_h
#define stickslip_algebra_some_ghosts_h

#include <stickslip/algebra/node_partition.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Some of the ghosts of the vectors of a NodePartition, whose values are
   * exchanged without those of the others.
   */
  class SomeGhosts
  {
  public:
    /** None. */
    SomeGhosts() = default;

    /** The ghosts with these local indices, in any order and as often as may
     * be. Collective. */
    SomeGhosts(const NodePartition             &nodes,
               const std::vector<unsigned int> &ghosts);

    /** Fetch their values from their owners. Collective among neighbours. */
    template <typename Number>
    void
    update(const NodeValues<Number> &vector) const;

    /** Add their values to those of their owners, and set them to zero.
     * Collective among neighbours. */
    template <typename Number>
    void
    add_to_owners(NodeValues<Number> &vector) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    bool
    is_exchanged() const;

    /** Carry out @p action for the position of each of their entries among
     * those of all ghosts, and the number of the entry. */
    template <typename Action>
    void
    for_each_entry(const Action &action) const;

    /** Entries of vectors; empty if there are none. */
    std::shared_ptr<const Utilities::MPI::Partitioner> entries;
  };
} // namespace StickSlip

#endif
