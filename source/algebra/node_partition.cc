// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/node_partition.h>

namespace StickSlip
{
  namespace
  {
    IndexSet
    entries_of(const IndexSet &nodes, const unsigned int components)
    {
      IndexSet entries(nodes.size() * components);
      for (auto interval = nodes.begin_intervals();
           interval != nodes.end_intervals();
           ++interval)
        entries.add_range(*interval->begin() * components,
                          (interval->last() + 1) * components);
      entries.compress();
      return entries;
    }
  } // namespace



  template <typename Number>
  void
  update_ghosts(const NodeValues<Number> &vector)
  {
    vector.update_ghost_values();
    vector.set_ghost_state(false);
  }



  template <typename Number>
  void
  add_ghosts_to_owners(NodeValues<Number> &vector)
  {
    vector.compress(VectorOperation::add);
  }



  std::vector<double>
  gather_on_first(const NodalVector &vector)
  {
    const MPI_Comm      communicator = vector.get_mpi_communicator();
    std::vector<double> all(vector.begin(),
                            vector.begin() + vector.locally_owned_size());
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return all;
    // Owned ranges follow each other in the order of the processes.
    const auto parts = Utilities::MPI::gather(communicator, all);
    all.clear();
    for (const std::vector<double> &part : parts)
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }



  NodePartition::NodePartition(const IndexSet    &owned,
                               const IndexSet    &ghosts,
                               const unsigned int components,
                               const MPI_Comm    &communicator)
    : components(components)
    , node_partitioner(
        std::make_shared<Utilities::MPI::Partitioner>(owned,
                                                      ghosts,
                                                      communicator))
    , entry_partitioner(std::make_shared<Utilities::MPI::Partitioner>(
        entries_of(owned, components),
        entries_of(ghosts, components),
        communicator))
  {}



  unsigned int
  NodePartition::n_owned() const
  {
    return node_partitioner->locally_owned_size();
  }



  unsigned int
  NodePartition::n_local() const
  {
    return node_partitioner->locally_owned_size() +
           node_partitioner->n_ghost_indices();
  }



  types::global_dof_index
  NodePartition::n_global() const
  {
    return node_partitioner->size();
  }



  MPI_Comm
  NodePartition::communicator() const
  {
    return node_partitioner->get_mpi_communicator();
  }



  const IndexSet &
  NodePartition::owned() const
  {
    return node_partitioner->locally_owned_range();
  }



  bool
  NodePartition::is_local(const types::global_dof_index node) const
  {
    return node_partitioner->in_local_range(node) ||
           node_partitioner->is_ghost_entry(node);
  }



  unsigned int
  NodePartition::local_index(const types::global_dof_index node) const
  {
    return node_partitioner->global_to_local(node);
  }



  types::global_dof_index
  NodePartition::global_index(const unsigned int node) const
  {
    return node_partitioner->local_to_global(node);
  }



  std::vector<unsigned int>
  NodePartition::owners() const
  {
    std::vector<unsigned int> result(
      n_owned(), Utilities::MPI::this_mpi_process(communicator()));
    for (const auto &[rank, n_ghosts] : node_partitioner->ghost_targets())
      result.insert(result.end(), n_ghosts, rank);
    return result;
  }



  std::shared_ptr<const Utilities::MPI::Partitioner>
  NodePartition::partition_of_vectors(const IndexSet &some_ghosts) const
  {
    const auto result = std::make_shared<Utilities::MPI::Partitioner>(
      entry_partitioner->locally_owned_range(), communicator());
    result->set_ghost_indices(entries_of(some_ghosts, components),
                              entry_partitioner->ghost_indices());
    return result;
  }



  template <typename Number>
  NodeValues<Number>
  NodePartition::make_vector() const
  {
    return NodeValues<Number>(entry_partitioner);
  }



  template void
  update_ghosts<double>(const NodalVector &);
  template void
  update_ghosts<float>(const NodeValues<float> &);
  template void
  add_ghosts_to_owners<double>(NodalVector &);
  template void
  add_ghosts_to_owners<float>(NodeValues<float> &);
  template NodalVector
  NodePartition::make_vector<double>() const;
  template NodeValues<float>
  NodePartition::make_vector<float>() const;
} // namespace StickSlip
