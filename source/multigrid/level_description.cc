// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/level_description.h>

namespace StickSlip
{
  namespace
  {
    /** A number for each node, since numbers are what can be exchanged. */
    NodalVector
    flag_vector(const NodePartition &nodes)
    {
      return NodalVector(nodes.nodes());
    }



    /** A flag for each entry that is not zero, after bringing ghosts up to
     * date. */
    std::vector<bool>
    flags(const NodalVector &vector)
    {
      update_ghosts(vector);
      const auto       &partitioner = *vector.get_partitioner();
      std::vector<bool> result(partitioner.locally_owned_size() +
                               partitioner.n_ghost_indices());
      for (unsigned int i = 0; i < result.size(); ++i)
        // Ghosts lie behind the owned entries.
        result[i] = vector.begin()[i] != 0.;
      return result;
    }



    /** Flag the rows coupled to nonsmooth nodes. */
    template <int n_components>
    void
    flag_coupled_rows(NodalVector                          &in_strip,
                      const LevelDescription<n_components> &level,
                      const BlockSparsity                  &sparsity)
    {
      NodalVector nonsmooth = flag_vector(level.nodes);
      for (const unsigned int i : level.nonsmooth_nodes)
        nonsmooth.local_element(i) = 1.;
      const std::vector<bool> is_nonsmooth = flags(nonsmooth);
      // The sparsity is symmetric.
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          if (is_nonsmooth[sparsity.column[k]])
            in_strip.local_element(i) = 1.;
    }
  } // namespace



  template <int n_components>
  std::vector<bool>
  find_strip(const LevelDescription<n_components> &level,
             const BlockSparsity                  &sparsity)
  {
    NodalVector in_strip = flag_vector(level.nodes);
    flag_coupled_rows(in_strip, level, sparsity);
    return flags(in_strip);
  }



  template <int n_components>
  std::vector<bool>
  find_strip(const LevelDescription<n_components> &level,
             const BlockSparsity                  &sparsity,
             const LevelDescription<n_components> &finer,
             const std::vector<bool>              &finer_strip)
  {
    NodalVector in_strip = flag_vector(level.nodes);
    const auto &Pt       = finer.to_coarser->prolongation().transpose();
    for (unsigned int I = 0; I + 1 < Pt.row_start.size(); ++I)
      for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
        if (finer_strip[Pt.column[k]])
          in_strip.local_element(I) = 1.;
    add_ghosts_to_owners(in_strip);
    flag_coupled_rows(in_strip, level, sparsity);
    return flags(in_strip);
  }



  template <int n_components>
  NodeMask
  coarsen_mask(const LevelDescription<n_components> &coarse,
               const LevelDescription<n_components> &fine,
               const NodeMask                       &fine_mask)
  {
    // The number of fine neighbours of the same kind that take part.
    NodalVector n_active = coarse.nodes.make_vector();
    const auto &P        = fine.to_coarser->prolongation().matrix();
    for (const unsigned int i : fine.nonsmooth_nodes)
      for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          n_active.local_element(P.column[k] * n_components + c) +=
            fine_mask.is_active(i, c);
    add_ghosts_to_owners(n_active);

    NodeMask mask = coarse.fixed;
    for (const unsigned int I : coarse.nonsmooth_nodes)
      for (unsigned int c = 0; c < n_components; ++c)
        if (n_active.local_element(I * n_components + c) == 0. &&
            mask.is_active(I, c))
          mask.mask(I, c);
    mask.update_ghosts(coarse.nodes);
    return mask;
  }



#define STICKSLIP_INSTANTIATE(n_components)                         \
  template struct LevelDescription<n_components>;                   \
  template std::vector<bool> find_strip<n_components>(              \
    const LevelDescription<n_components> &, const BlockSparsity &); \
  template std::vector<bool> find_strip<n_components>(              \
    const LevelDescription<n_components> &,                         \
    const BlockSparsity &,                                          \
    const LevelDescription<n_components> &,                         \
    const std::vector<bool> &);                                     \
  template NodeMask coarsen_mask<n_components>(                     \
    const LevelDescription<n_components> &,                         \
    const LevelDescription<n_components> &,                         \
    const NodeMask &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
