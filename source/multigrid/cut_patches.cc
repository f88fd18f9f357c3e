// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/ghost_numbers.h>
#include <stickslip/base/make_set.h>
#include <stickslip/base/questions.h>
#include <stickslip/multigrid/cut_patches.h>
#include <stickslip/multigrid/first_free_turns.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** The couplings of all local nodes with local nodes: those of ghosts are
     * fetched. Ghosts that no owned node couples to have none. */
    std::vector<std::vector<unsigned int>>
    couplings_of_local_nodes(const NodePartition             &nodes,
                             const BlockSparsity             &sparsity,
                             const std::vector<unsigned int> &owners)
    {
      using Numbers = std::vector<types::global_dof_index>;
      std::vector<std::vector<unsigned int>> rows(nodes.n_local());
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        rows[i].assign(sparsity.column.begin() + sparsity.row_start[i],
                       sparsity.column.begin() + sparsity.row_start[i + 1]);
      std::vector<unsigned int> ghosts;
      for (const unsigned int j : sparsity.column)
        if (j >= nodes.n_owned())
          ghosts.push_back(j);
      make_set(ghosts);
      std::map<unsigned int, Numbers> wanted;
      for (const unsigned int j : ghosts)
        wanted[owners[j]].push_back(nodes.global_index(j));
      // The number of a node, and of those that it couples to.
      const auto rows_of = [&](const Numbers &numbers) {
        std::vector<Numbers> answer;
        for (const types::global_dof_index number : numbers)
          {
            answer.push_back({number});
            for (const unsigned int j : rows[nodes.local_index(number)])
              answer.back().push_back(nodes.global_index(j));
          }
        return answer;
      };
      for (const auto &[rank, received] :
           ask(wanted, rows_of, nodes.communicator()))
        for (const Numbers &row : received)
          for (unsigned int k = 1; k < row.size(); ++k)
            if (nodes.is_local(row[k]))
              rows[nodes.local_index(row[0])].push_back(
                nodes.local_index(row[k]));
      return rows;
    }



    /** Return if a patch has nodes of several processes, of which @p me is the
     * last one. */
    bool
    is_cut_and_belongs_to(const unsigned int               me,
                          const NodePatch                 &patch,
                          const std::vector<unsigned int> &owners)
    {
      unsigned int first = me, last = 0;
      for (const unsigned int i : patch)
        {
          first = std::min(first, owners[i]);
          last  = std::max(last, owners[i]);
        }
      return last == me && first != me;
    }
  } // namespace



  template <int n_components, typename Number>
  CutPatches<n_components, Number>::CutPatches(
    const NodePartition &nodes,
    const BlockSparsity &level_sparsity,
    const NodeMask      &fixed,
    const StiffVolumes  &stiff_volumes)
  {
    const unsigned int me =
      Utilities::MPI::this_mpi_process(nodes.communicator());
    const std::vector<unsigned int> owners = nodes.owners();
    const BlockSparsity             local(
      couplings_of_local_nodes(nodes, level_sparsity, owners));
    const StiffVolumes volumes =
      stiff_volumes.empty() ?
        StiffVolumes(nodes.n_owned(), numbers::invalid_unsigned_int) :
        stiff_volumes;
    std::vector<NodePatch> patches;
    for (const NodePatch &patch :
         find_stiff_cells(local, fixed, with_ghosts(volumes, nodes)))
      if (is_cut_and_belongs_to(me, patch, owners))
        {
          patches.push_back(patch);
          members.insert(members.end(), patch.begin(), patch.end());
        }
    if (Utilities::MPI::max(int(!patches.empty()), nodes.communicator()) == 0)
      return;
    make_set(members);
    std::vector<unsigned int> place(nodes.n_local(),
                                    numbers::invalid_unsigned_int);
    for (unsigned int k = 0; k < members.size(); ++k)
      place[members[k]] = k;
    for (NodePatch &patch : patches)
      for (unsigned int &i : patch)
        i = place[i];

    // Couplings between ghosts are fetched.
    const unsigned int                     n_owned = nodes.n_owned();
    std::vector<std::vector<unsigned int>> rows(members.size());
    BlockSparsity                          ghost_rows;
    for (unsigned int g = n_owned; g < nodes.n_local(); ++g)
      {
        if (place[g] != numbers::invalid_unsigned_int)
          for (unsigned int k = local.row_start[g]; k < local.row_start[g + 1];
               ++k)
            if (local.column[k] >= n_owned &&
                place[local.column[k]] != numbers::invalid_unsigned_int)
              ghost_rows.column.push_back(local.column[k]);
        ghost_rows.row_start.push_back(ghost_rows.column.size());
      }
    exchange = RowExchange(nodes,
                           level_sparsity,
                           ghost_rows,
                           std::vector<bool>(nodes.n_local() - n_owned, true));
    fetched.resize(ghost_rows.column.size() * n_components * n_components);

    for (unsigned int k = 0; k < members.size(); ++k)
      for (unsigned int m = local.row_start[members[k]];
           m < local.row_start[members[k] + 1];
           ++m)
        if (place[local.column[m]] != numbers::invalid_unsigned_int)
          rows[k].push_back(place[local.column[m]]);
    sparsity = std::make_shared<const BlockSparsity>(std::move(rows));
    for (unsigned int k = 0; k < members.size(); ++k)
      for (unsigned int m = sparsity->row_start[k];
           m < sparsity->row_start[k + 1];
           ++m)
        {
          const unsigned int i = members[k], j = members[sparsity->column[m]];
          if (i < n_owned)
            sources.push_back({level_sparsity.position(i, j), false, false});
          else if (j < n_owned)
            sources.push_back({level_sparsity.position(j, i), false, true});
          else
            {
              const auto begin = ghost_rows.column.begin();
              const auto found =
                std::lower_bound(begin + ghost_rows.row_start[i - n_owned],
                                 begin + ghost_rows.row_start[i - n_owned + 1],
                                 j);
              sources.push_back(
                {static_cast<unsigned int>(found - begin), true, false});
            }
        }

    smoother = BlockGaussSeidel<n_components, Number>(sparsity, {}, patches);
    rhs      = NodePartition(complete_index_set(members.size()),
                        IndexSet(members.size()),
                        n_components,
                        MPI_COMM_SELF)
            .template make_vector<Number>();
    solution = rhs;
    change   = nodes.template make_vector<Number>();
    find_turns(nodes, level_sparsity);
  }



  template <int n_components, typename Number>
  void
  CutPatches<n_components, Number>::find_turns(
    const NodePartition &nodes,
    const BlockSparsity &level_sparsity)
  {
    const MPI_Comm                       communicator = nodes.communicator();
    std::vector<types::global_dof_index> own;
    for (const unsigned int i : members)
      own.push_back(nodes.global_index(i));
    std::map<types::global_dof_index, std::vector<unsigned int>> processes;
    const auto of_all = Utilities::MPI::all_gather(communicator, own);
    for (unsigned int p = 0; p < of_all.size(); ++p)
      for (const types::global_dof_index node : of_all[p])
        processes[node].push_back(p);

    // Pairs of processes that cannot act at the same time.
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int i = 0; i < level_sparsity.n_rows(); ++i)
      {
        const auto here = processes.find(nodes.global_index(i));
        if (here == processes.end())
          continue;
        members_anywhere.push_back(i);
        for (unsigned int k = level_sparsity.row_start[i];
             k < level_sparsity.row_start[i + 1];
             ++k)
          {
            const auto there =
              processes.find(nodes.global_index(level_sparsity.column[k]));
            if (there != processes.end())
              for (const unsigned int p : here->second)
                for (const unsigned int q : there->second)
                  if (p != q)
                    pairs.emplace_back(std::min(p, q), std::max(p, q));
          }
      }
    make_set(pairs);
    std::vector<std::vector<unsigned int>> before(of_all.size());
    for (const auto &some : Utilities::MPI::all_gather(communicator, pairs))
      for (const auto &[p, q] : some)
        before[q].push_back(p);
    std::vector<unsigned int> order(of_all.size());
    std::iota(order.begin(), order.end(), 0);
    const std::vector<unsigned int> turns = first_free_turns(before, order);
    n_turns  = 1 + *std::max_element(turns.begin(), turns.end());
    own_turn = turns[Utilities::MPI::this_mpi_process(communicator)];
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  CutPatches<n_components, Number>::set_matrix(
    const BlockMatrix<n_components, OtherNumber> &matrix,
    const NodeMask                               &active)
  {
    if (are_empty())
      return;
    constexpr unsigned int block_size = n_components * n_components;
    exchange.fetch_from_owners(fetched, matrix.values(), block_size);
    BlockMatrix<n_components> part(sparsity);
    for (unsigned int m = 0; m < sources.size(); ++m)
      {
        const Source &source = sources[m];
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            {
              const std::size_t entry =
                std::size_t(source.position) * block_size +
                (source.is_transposed ? d * n_components + c :
                                        c * n_components + d);
              part.block(m)[c * n_components + d] =
                source.is_fetched ? fetched[entry] : matrix.values()[entry];
            }
      }
    NodeMask its_active(members.size(), n_components);
    for (unsigned int k = 0; k < members.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        if (!active.is_active(members[k], c))
          its_active.mask(k, c);
    for (unsigned int k = 0; k < members.size(); ++k)
      {
        smoother.set_row(k, part);
        smoother.set_diagonal(k, part.diagonal_block(k), its_active);
      }
    smoother.factorise();
  }



  template <int n_components, typename Number>
  void
  CutPatches<n_components, Number>::take_turn(const unsigned int  turn,
                                              const bool          is_forward,
                                              NodeValues<Number> &x,
                                              const NodeValues<Number> &r) const
  {
    update_ghosts(r);
    change = Number(0.);
    if (turn == own_turn)
      {
        for (unsigned int k = 0; k < members.size(); ++k)
          std::copy_n(r.begin() + std::size_t(members[k]) * n_components,
                      n_components,
                      rhs.begin() + std::size_t(k) * n_components);
        if (is_forward)
          smoother.sweep_from_zero(solution, rhs);
        else
          {
            solution = Number(0.);
            smoother.sweep_backward(solution, rhs);
          }
        for (unsigned int k = 0; k < members.size(); ++k)
          std::copy_n(solution.begin() + std::size_t(k) * n_components,
                      n_components,
                      change.begin() + std::size_t(members[k]) * n_components);
      }
    add_ghosts_to_owners(change);
    x.add(Number(1.), change);
  }



  template <int n_components, typename Number>
  void
  CutPatches<n_components, Number>::find_residual(
    const NodeValues<Number>                     &x,
    NodeValues<Number>                           &r,
    const NodeValues<Number>                     &b,
    const BlockGaussSeidel<n_components, Number> &of_level) const
  {
    update_ghosts(x);
    of_level.residual_in_rows(members_anywhere, r, x, b);
  }



  template <int n_components, typename Number>
  void
  CutPatches<n_components, Number>::relax_from_zero(
    NodeValues<Number>                           &x,
    NodeValues<Number>                           &r,
    const NodeValues<Number>                     &b,
    const BlockGaussSeidel<n_components, Number> &of_level) const
  {
    x = Number(0.);
    take_turn(0, true, x, b);
    for (unsigned int turn = 1; turn < n_turns; ++turn)
      {
        find_residual(x, r, b, of_level);
        take_turn(turn, true, x, r);
      }
  }



  template <int n_components, typename Number>
  void
  CutPatches<n_components, Number>::relax(
    const bool                                    is_forward,
    NodeValues<Number>                           &x,
    NodeValues<Number>                           &r,
    const NodeValues<Number>                     &b,
    const BlockGaussSeidel<n_components, Number> &of_level) const
  {
    for (unsigned int k = 0; k < n_turns; ++k)
      {
        find_residual(x, r, b, of_level);
        take_turn(is_forward ? k : n_turns - 1 - k, is_forward, x, r);
      }
  }



  template <int n_components, typename Number>
  std::size_t
  CutPatches<n_components, Number>::memory_consumption() const
  {
    return sizeof(unsigned int) * members.capacity() +
           sizeof(Source) * sources.capacity() +
           sizeof(double) * fetched.capacity() + smoother.memory_consumption();
  }



#define STICKSLIP_INSTANTIATE(n, Number)               \
  template class CutPatches<n, Number>;                \
  template void CutPatches<n, Number>::set_matrix(     \
    const BlockMatrix<n, double> &, const NodeMask &); \
  template void CutPatches<n, Number>::set_matrix(     \
    const BlockMatrix<n, float> &, const NodeMask &);

  STICKSLIP_INSTANTIATE(1, float)
  STICKSLIP_INSTANTIATE(2, float)
  STICKSLIP_INSTANTIATE(3, float)
  STICKSLIP_INSTANTIATE(1, double)
  STICKSLIP_INSTANTIATE(2, double)
  STICKSLIP_INSTANTIATE(3, double)
} // namespace StickSlip
