// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/index_set.h>
#include <stickslip/algebra/some_ghosts.h>

namespace StickSlip
{
  SomeGhosts::SomeGhosts(const NodePartition             &nodes,
                         const std::vector<unsigned int> &ghosts)
  {
    std::vector<types::global_dof_index> numbers;
    for (const unsigned int ghost : ghosts)
      numbers.push_back(nodes.global_index(ghost));
    entries =
      nodes.partition_of_vectors(make_index_set(nodes.n_global(), numbers));
  }



  bool
  SomeGhosts::is_exchanged() const
  {
    return entries &&
           (entries->n_import_indices() > 0 || entries->n_ghost_indices() > 0);
  }



  template <typename Action>
  void
  SomeGhosts::for_each_entry(const Action &action) const
  {
    unsigned int next = 0;
    for (const auto &[first, last] :
         entries->ghost_indices_within_larger_ghost_set())
      for (unsigned int i = first; i < last; ++i)
        action(i, next++);
  }



  template <typename Number>
  void
  SomeGhosts::update(const NodeValues<Number> &vector) const
  {
    if (!is_exchanged())
      return;
    std::vector<Number> sent(entries->n_import_indices()),
      received(entries->n_ghost_indices());
    std::vector<MPI_Request> requests;
    entries->export_to_ghosted_array_start<Number, MemorySpace::Host>(
      0,
      ArrayView<const Number>(vector.begin(), vector.locally_owned_size()),
      make_array_view(sent),
      make_array_view(received),
      requests);
    entries->export_to_ghosted_array_finish<Number, MemorySpace::Host>(
      make_array_view(received), requests);
    // As for the library, ghosts are no part of what is constant in a vector.
    Number *ghosts =
      const_cast<Number *>(vector.begin()) + vector.locally_owned_size();
    for_each_entry([&](const unsigned int i, const unsigned int k) {
      ghosts[i] = received[k];
    });
  }



  template <typename Number>
  void
  SomeGhosts::add_to_owners(NodeValues<Number> &vector) const
  {
    if (!is_exchanged())
      return;
    std::vector<Number> sent(entries->n_ghost_indices()),
      received(entries->n_import_indices());
    Number *ghosts = vector.begin() + vector.locally_owned_size();
    for_each_entry([&](const unsigned int i, const unsigned int k) {
      sent[k]   = ghosts[i];
      ghosts[i] = Number(0.);
    });
    std::vector<MPI_Request> requests;
    entries->import_from_ghosted_array_start<Number, MemorySpace::Host>(
      VectorOperation::add,
      0,
      make_array_view(sent),
      make_array_view(received),
      requests);
    entries->import_from_ghosted_array_finish<Number, MemorySpace::Host>(
      VectorOperation::add,
      ArrayView<const Number>(received.data(), received.size()),
      ArrayView<Number>(vector.begin(), vector.locally_owned_size()),
      make_array_view(sent),
      requests);
  }



  std::size_t
  SomeGhosts::memory_consumption() const
  {
    return entries ? entries->memory_consumption() : 0;
  }



  template void
  SomeGhosts::update(const NodeValues<float> &) const;
  template void
  SomeGhosts::update(const NodeValues<double> &) const;
  template void
  SomeGhosts::add_to_owners(NodeValues<double> &) const;
} // namespace StickSlip
