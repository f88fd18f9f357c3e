// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/questions.h>
#include <stickslip/mesh/leaf_cells.h>
#include <stickslip/mesh/unit_numbers.h>

#include <algorithm>
#include <map>
#include <utility>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** A cell of the whole mesh: its unit, tree by tree, and its path below it,
     * see for_each_leaf_below(). */
    struct CellName
    {
      std::uint64_t unit = none, path = 0;
    };



    /** Counts what is in the own units, and learns what is around them. */
    template <int dim>
    class ShareNumbering
    {
    public:
      ShareNumbering(const UnitRefinement<dim> &share,
                     const DoFHandler<dim>     &dofs,
                     const std::vector<bool>   &is_real)
        : share(share)
        , dofs(dofs)
        , is_real(is_real)
        , me(Utilities::MPI::this_mpi_process(share.communicator))
        , first_cell(dofs.n_dofs())
      {
        for_each_leaf(*share.units, [&](const auto &unit) {
          units.emplace_back(unit->level(), unit->index());
          owners.push_back(share.owner(unit));
        });
        result.nodes.n_owned.resize(
          Utilities::MPI::n_mpi_processes(share.communicator), 0);
        result.nodes.owner.resize(dofs.n_dofs(), none);
        result.nodes.serial.resize(dofs.n_dofs(), numbers::invalid_dof_index);
        result.nodes.place.resize(dofs.n_dofs(), numbers::invalid_dof_index);
        result.cells.resize(is_real.size(), none);
      }

      UnitNumbers
      make()
      {
        find_first_cells();
        number_own();
        // Nodes of own cells that others count, which these know; then all that
        // is around own cells.
        std::vector<CellName> asked_for;
        for_each_real_cell([&](const Cell &cell, const CellName &name) {
          if (owners[name.unit] == me)
            for (const auto v : cell->vertex_indices())
              if (const CellName &first =
                    first_cell[cell->vertex_dof_index(v, 0)];
                  owners[first.unit] != me)
                asked_for.push_back(first);
        });
        learn(asked_for);
        asked_for.clear();
        for_each_real_cell([&](const Cell &, const CellName &name) {
          if (owners[name.unit] != me)
            asked_for.push_back(name);
        });
        learn(asked_for);
        return std::move(result);
      }

    private:
      using Cell = typename DoFHandler<dim>::cell_iterator;

      Cell
      unit_cell(const unsigned int unit) const
      {
        return Cell(&dofs.get_triangulation(),
                    units[unit].first,
                    units[unit].second,
                    &dofs);
      }

      template <typename Visitor>
      void
      for_each_real_cell(const Visitor &visit) const
      {
        for (unsigned int unit = 0; unit < units.size(); ++unit)
          for_each_leaf_below(unit_cell(unit),
                              [&](const Cell &cell, const std::uint64_t path) {
                                if (is_real[cell->active_cell_index()])
                                  visit(cell, CellName{unit, path});
                              });
      }

      Cell
      find(const CellName &name) const
      {
        unsigned int n_levels = 0;
        while ((name.path >> (dim * (n_levels + 1))) > 0)
          ++n_levels;
        Cell cell = unit_cell(name.unit);
        while (n_levels-- > 0)
          {
            AssertThrow(cell->has_children(), ExcInternalError());
            cell =
              cell->child((name.path >> (dim * n_levels)) & ((1u << dim) - 1));
          }
        AssertThrow(cell->is_active(), ExcInternalError());
        return cell;
      }

      void
      find_first_cells()
      {
        for_each_real_cell([&](const Cell &cell, const CellName &name) {
          for (const auto v : cell->vertex_indices())
            {
              const auto dof = cell->vertex_dof_index(v, 0);
              if (first_cell[dof].unit == none)
                first_cell[dof] = name;
              unsigned int &owner = result.nodes.owner[dof];
              owner               = std::min(owner, owners[name.unit]);
            }
        });
      }

      /** For each process its units, one after the other: the number of their
       * cells, of the owners of the nodes that are counted with them, and these
       * with so many nodes each. */
      std::vector<std::vector<unsigned int>>
      counts_of_units() const
      {
        std::vector<unsigned int> of_mine;
        for (unsigned int unit = 0; unit < units.size(); ++unit)
          if (owners[unit] == me)
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
        return Utilities::MPI::all_gather(share.communicator, of_mine);
      }

      /** Call one function for each node that is counted with an own unit, and
       * another one for each of its cells, in their order. */
      template <typename NodeVisitor, typename CellVisitor>
      void
      for_each_new_node(const unsigned int unit,
                        const NodeVisitor &visit_node,
                        const CellVisitor &visit_cell) const
      {
        for_each_leaf_below(unit_cell(unit),
                            [&](const Cell &cell, const std::uint64_t path) {
                              visit_cell(cell->active_cell_index());
                              for (const auto v : cell->vertex_indices())
                                {
                                  const auto dof = cell->vertex_dof_index(v, 0);
                                  const CellName &first = first_cell[dof];
                                  if (first.unit == unit && first.path == path)
                                    visit_node(dof);
                                }
                            });
      }

      void
      number_own()
      {
        const auto               counts = counts_of_units();
        std::vector<std::size_t> next(counts.size(), 0);
        NodeNumbers             &nodes = result.nodes;
        for (unsigned int unit = 0; unit < units.size(); ++unit)
          {
            const std::vector<unsigned int> &of_owner = counts[owners[unit]];
            std::size_t                     &k        = next[owners[unit]];
            if (owners[unit] == me)
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
            Message &question = questions[owners[name.unit]];
            question.insert(question.end(), {name.unit, name.path});
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
             ask(questions, numbers_of, share.communicator))
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
          visit(find({names[k], names[k + 1]}));
      }

      const UnitRefinement<dim> &share;
      const DoFHandler<dim>     &dofs;
      const std::vector<bool>   &is_real;
      const unsigned int         me;

      /** Level and index of the units, tree by tree, and their processes. */
      std::vector<std::pair<int, int>> units;
      std::vector<unsigned int>        owners;

      /** The first real cell with a node. For nodes of own cells it is that of
       * the whole mesh. */
      std::vector<CellName> first_cell;

      UnitNumbers result;
    };
  } // namespace



  template <int dim>
  UnitNumbers
  number_share(const UnitRefinement<dim> &share,
               const DoFHandler<dim>     &dofs,
               const std::vector<bool>   &is_real)
  {
    return ShareNumbering<dim>(share, dofs, is_real).make();
  }



  template decltype(number_share<2>) number_share<2>;
  template decltype(number_share<3>) number_share<3>;
} // namespace StickSlip
