// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/leaf_cells.h>

#include <map>
#include <numeric>

#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * Meshes that are refined only where a process needs them, against the whole.
 */

namespace
{
  constexpr unsigned int       none       = numbers::invalid_unsigned_int;
  constexpr types::boundary_id fault_side = 7;

  template <int dim>
  using Mesh = std::shared_ptr<const BodyMesh<dim>>;

  /** Sectors around a centre, whose cells have different axes. The fault is a
   * part of their boundary, and ends in the middle of it. */
  template <int dim>
  CoarseBody<dim>
  sectors(const RefinementSteps &steps)
  {
    const auto mesh = std::make_shared<Triangulation<dim>>();
    GridGenerator::hyper_ball(*mesh);
    mesh->set_all_manifold_ids(numbers::flat_manifold_id);
    for (const auto &face : mesh->active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(
          face->center()[0] + face->center()[1] > 0.1 ? fault_side : 0);
    CoarseBody<dim> body;
    body.cells               = mesh;
    body.uniform_refinements = steps.uniform;
    body.refinement_passes   = steps.at_faults;
    return body;
  }



  template <int dim>
  Mesh<dim>
  whole_mesh(const RefinementSteps &steps)
  {
    return std::make_shared<BodyMesh<dim>>(
      sectors<dim>(steps), std::set<types::boundary_id>{fault_side});
  }



  /** For each cell of a mesh, tree by tree, the owner of its unit. */
  template <int dim>
  std::vector<unsigned int>
  owners_of_leaves(const BodyMesh<dim>             &whole,
                   const BodyMesh<dim>             &units,
                   const std::vector<unsigned int> &owners)
  {
    std::vector<unsigned int> result;
    for (const auto &unit : units.triangulation().active_cell_iterators())
      {
        // Units and what is below them have the same name in both meshes.
        const auto cell =
          whole.triangulation().create_cell_iterator(unit->id());
        for_each_leaf_below(typename Triangulation<dim>::cell_iterator(cell),
                            [&](const auto &leaf, const std::uint64_t) {
                              const unsigned int number =
                                whole.whole_cell(leaf->active_cell_index());
                              if (result.size() <= number)
                                result.resize(number + 1, none);
                              result[number] =
                                owners[unit->active_cell_index()];
                            });
      }
    return result;
  }



  std::map<types::global_dof_index, double>
  masters(const AffineConstraints<double>            &constraints,
          const types::global_dof_index               dof,
          const std::vector<types::global_dof_index> &number)
  {
    std::map<types::global_dof_index, double> result;
    if (const auto *entries = constraints.get_constraint_entries(dof))
      for (const auto &[master, weight] : *entries)
        result[number[master]] += weight;
    return result;
  }



  /** Numbers, owners and hanging nodes are those of the whole mesh, and no cell
   * is missing that couples with an owned node. Returns the part of the whole
   * mesh that is here. */
  template <int dim>
  double
  expect_share(const BodyMesh<dim>             &share,
               const BodyMesh<dim>             &whole,
               const std::vector<unsigned int> &owner_of_cell)
  {
    EXPECT_EQ(share.n_cells(), whole.n_cells());
    EXPECT_EQ(share.n_vertices(), whole.n_vertices());
    EXPECT_EQ(owner_of_cell.size(), whole.n_cells());

    const auto &whole_dofs = whole.dof_handler();
    using Cell             = typename DoFHandler<dim>::active_cell_iterator;
    std::vector<Cell>         whole_cells(whole.n_cells());
    std::vector<unsigned int> owner(whole_dofs.n_dofs(), none);
    for (const auto &cell : whole_dofs.active_cell_iterators())
      {
        const unsigned int number = whole.whole_cell(cell->active_cell_index());
        whole_cells[number]       = cell;
        for (const auto v : cell->vertex_indices())
          {
            unsigned int &its = owner[cell->vertex_dof_index(v, 0)];
            its               = std::min(its, owner_of_cell[number]);
          }
      }
    std::vector<types::global_dof_index> same(whole_dofs.n_dofs());
    for (unsigned int i = 0; i < same.size(); ++i)
      same[i] = i;
    std::vector<unsigned int> place, n_owned(n_processes(), 0);
    for (const unsigned int process : owner)
      place.push_back(n_owned[process]++);

    const NodeNumbers &numbers = *share.numbers_in_units();
    EXPECT_EQ(numbers.n_nodes, whole_dofs.n_dofs());
    EXPECT_EQ(numbers.n_owned.size(), n_owned.size());
    for (unsigned int p = 0; p < n_owned.size(); ++p)
      EXPECT_EQ(numbers.n_owned[p], n_owned[p]);

    const unsigned int me = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    std::vector<bool>  is_here(whole.n_cells(), false);
    unsigned int       n_here = 0;
    for (const auto &cell : share.dof_handler().active_cell_iterators())
      if (share.is_real(cell))
        {
          ++n_here;
          const unsigned int number =
            share.whole_cell(cell->active_cell_index());
          is_here.at(number) = true;
          for (const auto v : cell->vertex_indices())
            {
              const auto dof = cell->vertex_dof_index(v, 0);
              EXPECT_EQ(cell->vertex(v), whole_cells[number]->vertex(v));
              EXPECT_EQ(share.whole_dof(dof),
                        whole_cells[number]->vertex_dof_index(v, 0));
              EXPECT_EQ(numbers.owner[dof], owner[share.whole_dof(dof)]);
              EXPECT_EQ(numbers.place[dof], place[share.whole_dof(dof)]);
            }
        }

    // Cells that couple with an owned node, of which it may be no vertex.
    std::map<types::global_dof_index, types::global_dof_index> dof_here;
    for (types::global_dof_index i = 0; i < numbers.serial.size(); ++i)
      if (numbers.serial[i] != numbers::invalid_dof_index)
        dof_here[numbers.serial[i]] = i;
    for (unsigned int number = 0; number < whole_cells.size(); ++number)
      {
        bool couples = false;
        for (const auto v : whole_cells[number]->vertex_indices())
          {
            const auto dof = whole_cells[number]->vertex_dof_index(v, 0);
            couples |= (owner[dof] == me);
            for (const auto &master : masters(whole.bound_nodes(), dof, same))
              couples |= (owner[master.first] == me);
          }
        if (!couples)
          continue;
        EXPECT_TRUE(is_here[number]);
        if (!is_here[number])
          continue;
        for (const auto v : whole_cells[number]->vertex_indices())
          {
            const auto dof = whole_cells[number]->vertex_dof_index(v, 0);
            EXPECT_EQ(masters(share.bound_nodes(),
                              dof_here.at(dof),
                              numbers.serial),
                      masters(whole.bound_nodes(), dof, same));
          }
      }
    return 1. * n_here / whole.n_cells();
  }



  /** A mesh with units of so many steps less, and those in between. Owners are
   * without any order, or far from each other. */
  template <int dim>
  void
  expect_shares_of_whole(const RefinementSteps &steps, const unsigned int depth)
  {
    const Mesh<dim>    units   = whole_mesh<dim>(steps.coarser(depth));
    const unsigned int n_units = units->n_cells();
    for (const bool are_scattered : {true, false})
      {
        const auto owners = std::make_shared<std::vector<unsigned int>>();
        for (unsigned int u = 0; u < n_units; ++u)
          owners->push_back(are_scattered ?
                              (7 * u + u * u / 5) % n_processes() :
                              u * n_processes() / n_units);

        Mesh<dim> whole = whole_mesh<dim>(steps);
        Mesh<dim> share = std::make_shared<BodyMesh<dim>>(
          units, owners, steps, depth, MPI_COMM_WORLD);
        const auto n_finest =
          count_finest_cells<dim>(units->triangulation(), {fault_side}, steps);
        EXPECT_EQ(std::accumulate(n_finest.begin(), n_finest.end(), 0u),
                  whole->n_cells());
        for (bool is_finest = true; share != units; is_finest = false)
          {
            SCOPED_TRACE(std::to_string(steps.uniform) + " steps, " +
                         std::to_string(steps.at_faults) + " at faults, " +
                         std::to_string(share->n_cells()) + " cells");
            const double part =
              expect_share<dim>(*share,
                                *whole,
                                owners_of_leaves<dim>(*whole, *units, *owners));
            if (is_finest && !are_scattered && n_processes() > 2 &&
                n_units > 200)
              {
                EXPECT_LT(part, 0.9);
              }
            share = BodyMesh<dim>::coarsened(*share);
            whole = BodyMesh<dim>::coarsened(*whole);
          }
        EXPECT_EQ(units->n_cells(), whole->n_cells());
      }
  }
} // namespace



TEST(ParallelUnits, SharesOfEqualCellsAreThoseOfTheWhole)
{
  for (const unsigned int depth : {1, 3})
    expect_shares_of_whole<2>({1 + depth, 0}, depth);
  for (const unsigned int depth : {1, 2})
    expect_shares_of_whole<3>({1 + depth, 0}, depth);
}



TEST(ParallelUnits, SharesOfGradedCellsAreThoseOfTheWhole)
{
  // Steps at faults alone, and together with those of all cells.
  expect_shares_of_whole<2>({0, 6}, 3);
  expect_shares_of_whole<2>({0, 8}, 2);
  expect_shares_of_whole<2>({3, 3}, 2);
  expect_shares_of_whole<2>({2, 4}, 5);
  expect_shares_of_whole<3>({1, 3}, 2);
  expect_shares_of_whole<3>({1, 2}, 2);
}
