// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/questions.h>
#include <stickslip/mesh/unit_numbers.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** Counts what is in the own units, and learns what is around them. */
    template <int dim>
    class ShareNumbering
    {
    public:
      ShareNumbering(const MeshShare<dim>  &share,
                     const DoFHandler<dim> &dofs,
                     const MPI_Comm        &communicator)
        : share(share)
        , dofs(dofs)
        , communicator(communicator)
        , me(Utilities::MPI::this_mpi_process(communicator))
        , first_of_unit(find_first_of_units())
        , by_name(share.names.size())
        , first_cell(dofs.n_dofs(), {none, 0})
      {
        std::iota(by_name.begin(), by_name.end(), 0);
        std::sort(by_name.begin(),
                  by_name.end(),
                  [&](const unsigned int k, const unsigned int l) {
                    return share.names[k] < share.names[l];
                  });
        result.nodes.n_owned.resize(
          Utilities::MPI::n_mpi_processes(communicator), 0);
        result.nodes.owner.resize(dofs.n_dofs(), none);
        result.nodes.serial.resize(dofs.n_dofs(), numbers::invalid_dof_index);
        result.nodes.place.resize(dofs.n_dofs(), numbers::invalid_dof_index);
        result.cells.resize(share.is_real.size(), none);
      }

      UnitNumbers
      make()
      {
        find_first_cells();
        number_own();
        // Nodes of own cells that others count, which these know; then all that
        // is around own cells.
        std::vector<CellName> asked_for;
        for (unsigned int k = 0; k < share.names.size(); ++k)
          if (owner(share.names[k]) == me)
            {
              const Cell its = cell(k);
              for (const auto v : its->vertex_indices())
                if (const CellName &first =
                      first_cell[its->vertex_dof_index(v, 0)];
                    owner(first) != me)
                  asked_for.push_back(first);
            }
        learn(asked_for);
        asked_for.clear();
        for (const CellName &name : share.names)
          if (owner(name) != me)
            asked_for.push_back(name);
        learn(asked_for);
        return std::move(result);
      }

    private:
      using Cell = typename DoFHandler<dim>::cell_iterator;

      unsigned int
      owner(const CellName &name) const
      {
        return share.owners[name.first];
      }

      /** One of the real cells. */
      Cell
      cell(const unsigned int k) const
      {
        return Cell(&dofs.get_triangulation(),
                    share.cells[k].first,
                    share.cells[k].second,
                    &dofs);
      }

      Cell
      find(const CellName &name) const
      {
        const auto place =
          std::lower_bound(by_name.begin(),
                           by_name.end(),
                           name,
                           [&](const unsigned int k, const CellName &other) {
                             return share.names[k] < other;
                           });
        AssertThrow(place != by_name.end() && share.names[*place] == name,
                    ExcInternalError());
        return cell(*place);
      }

      void
      find_first_cells()
      {
        for (unsigned int k = 0; k < share.names.size(); ++k)
          {
            const Cell its = cell(k);
            for (const auto v : its->vertex_indices())
              {
                const auto dof = its->vertex_dof_index(v, 0);
                if (first_cell[dof].first == none)
                  first_cell[dof] = share.names[k];
                unsigned int &its_owner = result.nodes.owner[dof];
                its_owner = std::min(its_owner, owner(share.names[k]));
              }
          }
      }

      std::vector<unsigned int>
      find_first_of_units() const
      {
        std::vector<unsigned int> first;
        for (unsigned int k = 0; k < share.names.size(); ++k)
          first.resize(share.names[k].first + 1, k);
        first.resize(share.owners.size() + 1, share.names.size());
        return first;
      }

      /** For each process its units, one after the other: the number of their
       * cells, of the owners of the nodes that are counted with them, and these
       * with so many nodes each. */
      std::vector<std::vector<unsigned int>>
      counts_of_units() const
      {
        std::vector<unsigned int> of_mine;
        for (unsigned int unit = 0; unit < share.owners.size(); ++unit)
          if (share.owners[unit] == me)
            {
              unsigned int                         n_cells = 0;
              std::map<unsigned int, unsigned int> n_nodes;
              for_each_new_node(
                unit,
                [&](const unsigned int node) {
                  ++n_nodes[result.nodes.owner[node]];
                },
                [&](const unsigned int) { ++n_cells; });
              of_mine.push_back(n_cells);
              of_mine.push_back(n_nodes.size());
              for (const auto &[owner, n] : n_nodes)
                of_mine.insert(of_mine.end(), {owner, n});
            }
        return Utilities::MPI::all_gather(communicator, of_mine);
      }

      /** Call one function for each node that is counted with an own unit, and
       * another one for each of its cells, in their order. */
      template <typename NodeVisitor, typename CellVisitor>
      void
      for_each_new_node(const unsigned int unit,
                        const NodeVisitor &visit_node,
                        const CellVisitor &visit_cell) const
      {
        for (unsigned int k = first_of_unit[unit]; k < first_of_unit[unit + 1];
             ++k)
          {
            const Cell its = cell(k);
            visit_cell(its->active_cell_index());
            for (const auto v : its->vertex_indices())
              if (const auto dof = its->vertex_dof_index(v, 0);
                  first_cell[dof] == share.names[k])
                visit_node(dof);
          }
      }

      void
      number_own()
      {
        const auto               counts = counts_of_units();
        std::vector<std::size_t> next(counts.size(), 0);
        NodeNumbers             &nodes = result.nodes;
        for (unsigned int unit = 0; unit < share.owners.size(); ++unit)
          {
            const unsigned int               its_owner = share.owners[unit];
            const std::vector<unsigned int> &of_owner  = counts[its_owner];
            std::size_t                     &k         = next[its_owner];
            if (its_owner == me)
              {
                types::global_dof_index serial = nodes.n_nodes;
                unsigned int            number = result.n_cells;
                auto                    place  = nodes.n_owned;
                for_each_new_node(
                  unit,
                  [&](const unsigned int node) {
                    nodes.serial[node] = serial++;
                    nodes.place[node]  = place[nodes.owner[node]]++;
                  },
                  [&](const unsigned int cell) {
                    result.cells[cell] = number++;
                  });
              }
            result.n_cells += of_owner[k++];
            for (unsigned int n_owners = of_owner[k++]; n_owners > 0;
                 --n_owners, k += 2)
              {
                nodes.n_owned[of_owner[k]] += of_owner[k + 1];
                nodes.n_nodes += of_owner[k + 1];
              }
          }
      }

      /** Learn what the owners of cells know of these and their nodes. */
      void
      learn(const std::vector<CellName> &names)
      {
        using Message = std::vector<std::uint64_t>;
        std::map<unsigned int, Message> questions;
        for (const CellName &name : names)
          {
            Message &question = questions[owner(name)];
            question.insert(question.end(), {name.first, name.second});
          }
        const auto numbers_of = [&](const Message &question) {
          Message answer;
          for_each_named(question, [&](const Cell &cell) {
            answer.push_back(result.cells[cell->active_cell_index()]);
            for (const auto v : cell->vertex_indices())
              {
                const auto dof = cell->vertex_dof_index(v, 0);
                answer.insert(answer.end(),
                              {result.nodes.owner[dof],
                               result.nodes.serial[dof],
                               result.nodes.place[dof]});
              }
          });
          return answer;
        };
        for (const auto &[process, answer] :
             ask(questions, numbers_of, communicator))
          {
            auto next = answer.begin();
            for_each_named(questions[process], [&](const Cell &cell) {
              result.cells[cell->active_cell_index()] = *next++;
              for (const auto v : cell->vertex_indices())
                {
                  const auto         dof    = cell->vertex_dof_index(v, 0);
                  const unsigned int owner  = *next++;
                  const auto         serial = *next++, place = *next++;
                  if (serial == numbers::invalid_dof_index)
                    continue;
                  result.nodes.owner[dof]  = owner;
                  result.nodes.serial[dof] = serial;
                  result.nodes.place[dof]  = place;
                }
            });
          }
      }

      template <typename Visitor>
      void
      for_each_named(const std::vector<std::uint64_t> &names,
                     const Visitor                    &visit) const
      {
        for (std::size_t k = 0; k < names.size(); k += 2)
          visit(find(CellName(names[k], names[k + 1])));
      }

      const MeshShare<dim>  &share;
      const DoFHandler<dim> &dofs;
      const MPI_Comm        &communicator;
      const unsigned int     me;

      /** The real cells below each unit: the first of them, and their number at
       * the end. */
      const std::vector<unsigned int> first_of_unit;

      /** The real cells in the order of their names, in which those of
       * different levels are not tree by tree. */
      std::vector<unsigned int> by_name;

      /** The first real cell with a node. For nodes of own cells it is that of
       * the whole mesh. */
      std::vector<CellName> first_cell;

      UnitNumbers result;
    };
  } // namespace



  template <int dim>
  UnitNumbers
  number_share(const MeshShare<dim>  &share,
               const DoFHandler<dim> &dofs,
               const MPI_Comm        &communicator)
  {
    return ShareNumbering<dim>(share, dofs, communicator).make();
  }



  template decltype(number_share<2>) number_share<2>;
  template decltype(number_share<3>) number_share<3>;
} // namespace StickSlip
