// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>
#include <stickslip/geometry/fault_shape.h>
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

  struct Kind
  {
    bool has_simplices = false, bends = false, couples_patches = false;
  };

  template <int dim>
  class UnitSphere : public FaultShape<dim>
  {
  public:
    virtual Point<dim>
    place(const Point<dim> &point) const override
    {
      return Point<dim>(point / point.norm());
    }
  };



  /** Sectors around a centre, whose cells have different axes. The fault is a
   * part of their boundary, and ends in the middle of it. */
  template <int dim>
  CoarseBody<dim>
  sectors(const RefinementSteps &steps, const Kind &kind)
  {
    Triangulation<dim> cubes;
    GridGenerator::hyper_ball(cubes);
    cubes.set_all_manifold_ids(numbers::flat_manifold_id);
    const auto mesh = std::make_shared<Triangulation<dim>>();
    if (kind.has_simplices)
      GridGenerator::convert_hypercube_to_simplex_mesh(cubes, *mesh);
    else
      mesh->copy_triangulation(cubes);
    for (const auto &face : mesh->active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(
          face->center()[0] + face->center()[1] > 0.1 ? fault_side : 0);
    if (kind.bends)
      set_shapes<dim>(*mesh,
                      {{fault_side, std::make_shared<UnitSphere<dim>>()}});
    CoarseBody<dim> body;
    body.couples_patches     = kind.couples_patches;
    body.cells               = mesh;
    body.uniform_refinements = steps.uniform;
    body.refinement_passes   = steps.at_faults;
    return body;
  }



  template <int dim>
  Mesh<dim>
  whole_mesh(const RefinementSteps &steps, const Kind &kind)
  {
    return std::make_shared<BodyMesh<dim>>(
      sectors<dim>(steps, kind), std::set<types::boundary_id>{fault_side});
  }



  /** For each cell of a mesh, tree by tree, the owner of its unit. */
  template <int dim>
  std::vector<unsigned int>
  owners_of_leaves(const BodyMesh<dim>             &whole,
                   const BodyMesh<dim>             &units,
                   const std::vector<unsigned int> &owners)
  {
    std::vector<unsigned int> result;
    if (dim == 3 && whole.triangulation().all_reference_cells_are_simplex())
      {
        const unsigned int n_parts = whole.n_cells() / units.n_cells();
        for (unsigned int cell = 0; cell < whole.n_cells(); ++cell)
          result.push_back(owners[cell / n_parts]);
        return result;
      }
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
    whole.patches().for_each(whole_dofs, [&](const auto &patch) {
      bool couples = false;
      for (const auto &cell : patch)
        for (const auto v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            couples |= (owner[dof] == me);
            for (const auto &master : masters(whole.bound_nodes(), dof, same))
              couples |= (owner[master.first] == me);
          }
      if (!couples)
        return;
      for (const auto &cell : patch)
        {
          const bool its_here =
            is_here[whole.whole_cell(cell->active_cell_index())];
          EXPECT_TRUE(its_here);
          if (!its_here)
            continue;
          for (const auto v : cell->vertex_indices())
            {
              const auto dof = cell->vertex_dof_index(v, 0);
              EXPECT_EQ(masters(share.bound_nodes(),
                                dof_here.at(dof),
                                numbers.serial),
                        masters(whole.bound_nodes(), dof, same));
            }
        }
    });
    // Patches are as real as their first cells.
    share.patches().for_each(share.dof_handler(), [&](const auto &patch) {
      for (const auto &cell : patch)
        EXPECT_EQ(share.is_real(cell), share.is_real(patch.front()));
    });
    return 1. * n_here / whole.n_cells();
  }



  /** A mesh with units of so many steps less, and those in between. Owners are
   * without any order, or far from each other. */
  template <int dim>
  void
  expect_shares_of_whole(const RefinementSteps &steps,
                         const unsigned int     depth,
                         const Kind            &kind = {})
  {
    const Mesh<dim>    units   = whole_mesh<dim>(steps.coarser(depth), kind);
    const unsigned int n_units = units->n_cells();
    for (const bool are_scattered : {true, false})
      {
        const auto owners = std::make_shared<std::vector<unsigned int>>();
        for (unsigned int u = 0; u < n_units; ++u)
          owners->push_back(are_scattered ?
                              (7 * u + u * u / 5) % n_processes() :
                              u * n_processes() / n_units);

        Mesh<dim> whole = whole_mesh<dim>(steps, kind);
        Mesh<dim> share = std::make_shared<BodyMesh<dim>>(
          units, owners, steps, depth, MPI_COMM_WORLD);
        if (dim == 2 || !kind.has_simplices)
          {
            const auto n_finest =
              count_finest_cells<dim>(units->triangulation(),
                                      {fault_side},
                                      steps);
            EXPECT_EQ(std::accumulate(n_finest.begin(), n_finest.end(), 0u),
                      whole->n_cells());
          }
        for (bool is_finest = true; share != units; is_finest = false)
          {
            SCOPED_TRACE(std::to_string(steps.uniform) + " steps, " +
                         std::to_string(steps.at_faults) + " at faults, " +
                         std::to_string(share->n_cells()) + " cells");
            EXPECT_EQ(share->n_coarsenings(), whole->n_coarsenings());
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



TEST(ParallelUnits, SharesOfSimplicesAreThoseOfTheWhole)
{
  for (const bool bends : {false, true})
    {
      expect_shares_of_whole<2>({3, 0}, 2, {true, bends, false});
      expect_shares_of_whole<3>({1, 0}, 1, {true, bends, false});
    }
  expect_shares_of_whole<3>({2, 0}, 2, {true, true, false});
}



TEST(ParallelUnits, SharesHaveWholePatches)
{
  for (const bool has_simplices : {false, true})
    {
      expect_shares_of_whole<2>({3, 0}, 2, {has_simplices, false, true});
      expect_shares_of_whole<3>({2, 0}, 1, {has_simplices, false, true});
    }
}



TEST(ParallelUnits, SharesOfBentCellsAreThoseOfTheWhole)
{
  expect_shares_of_whole<2>({3, 0}, 2, {false, true, false});
  expect_shares_of_whole<3>({2, 0}, 1, {false, true, false});
}
