// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/ghost_numbers.h>
#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/first_free_turns.h>
#include <stickslip/multigrid/sweep_turns.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int inside = numbers::invalid_unsigned_int;

    /** Pieces of one process, counted from 0, each with pieces of others that
     * it couples to, as pairs of their process and their number there. */
    using Couplings =
      std::vector<std::vector<std::pair<unsigned int, unsigned int>>>;



    /** The pieces of the owned units: a number for each unit, and how many
     * there are. */
    std::pair<std::vector<unsigned int>, unsigned int>
    find_pieces(const NodePartition                          &nodes,
                const BlockSparsity                          &sparsity,
                const std::vector<unsigned int>              &owners,
                const std::vector<std::vector<unsigned int>> &units,
                const bool                                    is_one_piece)
    {
      std::map<std::vector<unsigned int>, unsigned int> numbers;
      std::vector<unsigned int>                         others, result;
      const auto add_others = [&](const unsigned int i) {
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          if (sparsity.column[k] >= nodes.n_owned())
            others.push_back(owners[sparsity.column[k]]);
      };
      const unsigned int n = units.empty() ? nodes.n_owned() : units.size();
      for (unsigned int u = 0; u < n; ++u)
        {
          others.clear();
          if (units.empty())
            add_others(u);
          else
            for (const unsigned int i : units[u])
              add_others(i);
          if (others.empty())
            result.push_back(inside);
          else
            {
              make_set(others);
              if (is_one_piece)
                others.clear();
              result.push_back(
                numbers.emplace(others, numbers.size()).first->second);
            }
        }
      return {result, numbers.size()};
    }



    /** The turn of each piece of this process: the first that none of the
     * pieces that it couples to has, for those that couple to most first. */
    std::vector<unsigned int>
    find_turns_of_pieces(const Couplings &couplings,
                         const MPI_Comm  &communicator)
    {
      const auto of_all = Utilities::MPI::all_gather(communicator, couplings);
      std::vector<unsigned int> first = {0};
      for (const Couplings &pieces : of_all)
        first.push_back(first.back() + pieces.size());
      std::vector<std::vector<unsigned int>> coupled;
      for (const Couplings &pieces : of_all)
        for (const auto &others : pieces)
          {
            coupled.emplace_back();
            for (const auto &[rank, piece] : others)
              coupled.back().push_back(first[rank] + piece);
          }
      std::vector<unsigned int> order(coupled.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const unsigned int a, const unsigned int b) {
                         return coupled[a].size() > coupled[b].size();
                       });
      const std::vector<unsigned int> turns = first_free_turns(coupled, order);
      const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
      return std::vector<unsigned int>(turns.begin() + first[me],
                                       turns.begin() + first[me + 1]);
    }
  } // namespace



  SweepTurns::SweepTurns(const NodePartition                          &nodes,
                         const BlockSparsity                          &sparsity,
                         const std::vector<std::vector<unsigned int>> &units,
                         const bool may_overlap)
  {
    const unsigned int n_units =
      units.empty() ? sparsity.n_rows() : units.size();
    const bool is_shared =
      nodes.nodes() != nullptr &&
      Utilities::MPI::n_mpi_processes(nodes.communicator()) > 1;
    if (!is_shared)
      {
        turns.front().units = {{0, n_units}};
        return;
      }

    const std::vector<unsigned int> owners = nodes.owners();
    const auto [piece_of_unit, n_pieces] =
      find_pieces(nodes, sparsity, owners, units, may_overlap);
    const auto for_nodes_of_unit = [&](const unsigned int u,
                                       const auto        &action) {
      if (units.empty())
        action(u);
      else
        for (const unsigned int i : units[u])
          action(i);
    };

    // Nodes inside have 0, others their piece + 1.
    std::vector<unsigned int> piece_of_node(nodes.n_owned(), 0);
    for (unsigned int u = 0; u < n_units; ++u)
      if (piece_of_unit[u] != inside)
        for_nodes_of_unit(u, [&](const unsigned int i) {
          piece_of_node[i] = piece_of_unit[u] + 1;
        });
    piece_of_node = with_ghosts(piece_of_node, nodes);

    Couplings         couplings(n_pieces);
    std::vector<bool> is_read(nodes.n_local(), false);
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          const unsigned int j = sparsity.column[k];
          if (j < nodes.n_owned())
            continue;
          AssertThrow(piece_of_node[j] > 0,
                      ExcMessage("Processes do not agree which nodes couple."));
          is_read[j] = true;
          couplings[piece_of_node[i] - 1].emplace_back(owners[j],
                                                       piece_of_node[j] - 1);
        }
    for (auto &others : couplings)
      make_set(others);
    const std::vector<unsigned int> turn_of_piece =
      find_turns_of_pieces(couplings, nodes.communicator());

    unsigned int n_turns = 1;
    for (const unsigned int turn : turn_of_piece)
      n_turns = std::max(n_turns, turn + 1);
    n_turns = Utilities::MPI::max(n_turns, nodes.communicator());
    AssertThrow(n_turns <= std::numeric_limits<std::uint8_t>::max(),
                ExcMessage("Too many processes border on each other."));
    turns.resize(n_turns);
    for (unsigned int u = 0; u < n_units; ++u)
      {
        const unsigned int turn =
          piece_of_unit[u] == inside ? 0 : turn_of_piece[piece_of_unit[u]];
        std::vector<Range> &ranges = turns[turn].units;
        if (!ranges.empty() && ranges.back().second == u)
          ++ranges.back().second;
        else
          ranges.emplace_back(u, u + 1);
      }
    if (n_turns == 1)
      return;

    std::vector<unsigned int> turn_of_node(nodes.n_owned(), 0);
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      if (piece_of_node[i] > 0)
        turn_of_node[i] = turn_of_piece[piece_of_node[i] - 1];
    turn_of_node = with_ghosts(turn_of_node, nodes);
    of_node.assign(turn_of_node.begin(), turn_of_node.end());

    std::vector<std::vector<unsigned int>> read(n_turns);
    for (unsigned int j = nodes.n_owned(); j < nodes.n_local(); ++j)
      if (is_read[j])
        read[of_node[j]].push_back(j);
    for (unsigned int turn = 0; turn < n_turns; ++turn)
      turns[turn].read = SomeGhosts(nodes, read[turn]);
  }



  std::size_t
  SweepTurns::memory_consumption() const
  {
    std::size_t bytes = of_node.capacity();
    for (const Turn &turn : turns)
      bytes +=
        sizeof(Range) * turn.units.capacity() + turn.read.memory_consumption();
    return bytes;
  }
} // namespace StickSlip
