// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_node_partition_h
#define stickslip_algebra_node_partition_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A vector of nodal values, consecutive entries for each node of a
   * NodePartition; owned nodes first, ghost nodes behind. Single precision is
   * for preconditioners.
   */
  template <typename Number>
  using NodeValues = LinearAlgebra::distributed::Vector<Number>;

  using NodalVector = NodeValues<double>;

  /**
   * Fetch the values of the ghost nodes from their owners. Collective among
   * neighbours. Whatever reads ghost values calls this first; the vector's own
   * flag stays unset, so that the library does not repeat it unasked after each
   * of its operations.
   */
  template <typename Number>
  void
  update_ghosts(const NodeValues<Number> &vector);

  /**
   * Add the values of the ghost nodes to those of their owners, and set them to
   * zero. Collective among neighbours.
   */
  template <typename Number>
  void
  add_ghosts_to_owners(NodeValues<Number> &vector);

  /**
   * All entries of a vector in the order of their global numbers, on the first
   * process; empty on the others. Collective.
   */
  std::vector<double>
  gather_on_first(const NodalVector &vector);

  /**
   * The nodes of one level that this process owns, the others that it reads,
   * and the matching partition of vectors with some entries a node. Local
   * indices count the owned nodes in the order of their global numbers, then
   * the ghosts in the order of theirs.
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
    n_components() const
    {
      return components;
    }

    /** Processes that share the nodes. By value, as deal.II gives it since 9.5.
     */
    MPI_Comm
    communicator() const;

    /** The global numbers of the owned nodes. */
    const IndexSet &
    owned() const;

    /** Return whether the node with this global number is owned or a ghost. */
    bool
    is_local(const types::global_dof_index node) const;

    /** Local index of a node given by its global number. It must be local. */
    unsigned int
    local_index(const types::global_dof_index node) const;

    /** Global number of a node given by its local index. */
    types::global_dof_index
    global_index(const unsigned int node) const;

    /** The process of each local node. */
    std::vector<unsigned int>
    owners() const;

    /** The partition of vectors of which only some ghosts are read, given by
     * their global numbers. Collective. */
    std::shared_ptr<const Utilities::MPI::Partitioner>
    partition_of_vectors(const IndexSet &some_ghosts) const;

    /** The partition of the nodes. */
    const std::shared_ptr<const Utilities::MPI::Partitioner> &
    nodes() const
    {
      return node_partitioner;
    }

    /** A zero vector. */
    template <typename Number = double>
    NodeValues<Number>
    make_vector() const;

  private:
    unsigned int                                       components = 0;
    std::shared_ptr<const Utilities::MPI::Partitioner> node_partitioner;
    std::shared_ptr<const Utilities::MPI::Partitioner> entry_partitioner;
  };
} // namespace StickSlip

#endif
