// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_node_partition_h
#define stickslip_algebra_node_partition_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A vector of nodal values, dim consecutive entries for each node of a
   * NodePartition; owned nodes first, ghost nodes behind.
   */
  using NodalVector = LinearAlgebra::distributed::Vector<double>;

  /**
   * Which nodes of one level this process owns and which others it reads, and
   * the matching partition of vectors with dim entries a node.
   */
  class NodePartition
  {
  public:
    NodePartition() = default;

    /**
     * @p owned nodes form a contiguous range of the global numbering,
     * @p ghosts are any others.
     */
    NodePartition(const IndexSet    &owned,
                  const IndexSet    &ghosts,
                  const unsigned int components,
                  const MPI_Comm    &communicator);

    /** Number of nodes owned by this process. */
    unsigned int
    n_owned() const;

    /** Number of owned and ghost nodes. */
    unsigned int
    n_local() const;

    /** Number of nodes on all processes. */
    types::global_dof_index
    n_global() const;

    /** Number of vector entries a node. */
    unsigned int
    n_components() const;

    const MPI_Comm &
    communicator() const;

    /** Local index of a node given by its global number. */
    unsigned int
    local_index(const types::global_dof_index node) const;

    /** The partition of the nodes. */
    const std::shared_ptr<const Utilities::MPI::Partitioner> &
    nodes() const;

    /** A zero vector. */
    NodalVector
    make_vector() const;

  private:
    unsigned int                                       components = 0;
    std::shared_ptr<const Utilities::MPI::Partitioner> node_partitioner;
    std::shared_ptr<const Utilities::MPI::Partitioner> entry_partitioner;
  };
} // namespace StickSlip

#endif
