// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/multigrid/volume_cells.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace StickSlip
{
  namespace
  {
    /** More neighbours than bits of a set, or nodes in a cell, there are only
     * where faults couple rows of both sides. */
    constexpr unsigned int most_neighbours = 64, most_nodes = 16;

    /**
     * The largest sets of nodes that all couple to each other (Bron and
     * Kerbosch 1973), among a part of the nodes.
     */
    class CellFinder
    {
    public:
      CellFinder(const BlockSparsity     &sparsity,
                 const std::vector<bool> &is_part)
        : sparsity(sparsity)
        , is_part(is_part)
        , place(is_part.size(), numbers::invalid_unsigned_int)
      {}

      /** Call @p action(cell) for all cells of which a node is the first one.
       */
      template <typename Action>
      void
      for_each_cell(const unsigned int node, const Action &action)
      {
        near.clear();
        for (unsigned int k = sparsity.row_start[node];
             k < sparsity.row_start[node + 1];
             ++k)
          {
            const unsigned int j = sparsity.column[k];
            if (j != node && j < is_part.size() && is_part[j])
              near.push_back(j);
          }
        if (near.size() > most_neighbours)
          return;
        for (unsigned int a = 0; a < near.size(); ++a)
          place[near[a]] = a;
        std::uint64_t candidates = 0, earlier = 0;
        for (unsigned int a = 0; a < near.size(); ++a)
          {
            coupled[a] = 0;
            for (unsigned int k = sparsity.row_start[near[a]];
                 k < sparsity.row_start[near[a] + 1];
                 ++k)
              {
                const unsigned int j = sparsity.column[k];
                if (j < is_part.size() && j != near[a] &&
                    place[j] != numbers::invalid_unsigned_int)
                  coupled[a] |= bit(place[j]);
              }
            (near[a] < node ? earlier : candidates) |= bit(a);
          }
        for (const unsigned int j : near)
          place[j] = numbers::invalid_unsigned_int;
        extend(node, 0, candidates, earlier, action);
      }

    private:
      static std::uint64_t
      bit(const unsigned int a)
      {
        return std::uint64_t(1) << a;
      }

      /** The cells that have the node and the @p members, any of the @p
       * candidates and none of the nodes @p without. */
      template <typename Action>
      void
      extend(const unsigned int  node,
             const std::uint64_t members,
             std::uint64_t       candidates,
             std::uint64_t       without,
             const Action       &action) const
      {
        if (candidates == 0)
          {
            if (without == 0)
              {
                NodePatch cell = {node};
                for (unsigned int a = 0; a < near.size(); ++a)
                  if (members & bit(a))
                    cell.push_back(near[a]);
                std::sort(cell.begin(), cell.end());
                action(cell);
              }
            return;
          }
        // Neighbours of the node with the most of them come with it.
        unsigned int  most  = 0;
        std::uint64_t pivot = 0;
        for (unsigned int a = 0; a < near.size(); ++a)
          if ((candidates | without) & bit(a))
            {
              const unsigned int n =
                1 + __builtin_popcountll(candidates & coupled[a]);
              if (n > most)
                {
                  most  = n;
                  pivot = coupled[a];
                }
            }
        for (unsigned int a = 0; a < near.size(); ++a)
          if (candidates & ~pivot & bit(a))
            {
              extend(node,
                     members | bit(a),
                     candidates & coupled[a],
                     without & coupled[a],
                     action);
              candidates &= ~bit(a);
              without |= bit(a);
            }
      }

      const BlockSparsity                       &sparsity;
      const std::vector<bool>                   &is_part;
      std::vector<unsigned int>                  place;
      std::vector<unsigned int>                  near;
      std::array<std::uint64_t, most_neighbours> coupled;
    };
  } // namespace



  StiffVolumes
  coarsen_stiff_volumes(const StiffVolumes   &fine,
                        const TransferMatrix &prolongation,
                        const NodePartition  &coarse_nodes,
                        const unsigned int    n_terms)
  {
    StiffVolumes result(coarse_nodes.n_owned(), numbers::invalid_unsigned_int);
    const TransferMatrix::Compressed &P = prolongation.matrix();
    for (unsigned int term = n_terms; term-- > 0;)
      {
        NodalVector n_fine(coarse_nodes.nodes());
        for (unsigned int i = 0; i < fine.size(); ++i)
          if (fine[i] == term)
            for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
              n_fine.local_element(P.column[k]) += 1.;
        add_ghosts_to_owners(n_fine);
        for (unsigned int I = 0; I < result.size(); ++I)
          if (n_fine.local_element(I) > 0.)
            result[I] = term;
      }
    return result;
  }



  std::vector<NodePatch>
  find_stiff_cells(const BlockSparsity &sparsity,
                   const NodeMask      &fixed,
                   const StiffVolumes  &stiff_volumes)
  {
    std::vector<NodePatch> result;
    if (stiff_volumes.empty())
      return result;
    std::vector<bool> is_free(stiff_volumes.size(), false);
    for (unsigned int i = 0; i < is_free.size(); ++i)
      for (unsigned int c = 0; c < fixed.n_components(); ++c)
        if (fixed.is_active(i, c))
          is_free[i] = true;
    CellFinder finder(sparsity, is_free);
    for (unsigned int i = 0; i < is_free.size(); ++i)
      if (is_free[i])
        finder.for_each_cell(i, [&](const NodePatch &cell) {
          if (cell.size() <= most_nodes &&
              std::any_of(cell.begin(), cell.end(), [&](const unsigned int j) {
                return stiff_volumes[j] != numbers::invalid_unsigned_int;
              }))
            result.push_back(cell);
        });
    return result;
  }

} // namespace StickSlip
