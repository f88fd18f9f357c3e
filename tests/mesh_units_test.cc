// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>
#include <stickslip/mesh/unit_refinement.h>

#include <cmath>
#include <map>

using namespace StickSlip;

/*
 * Meshes that are refined only where a process needs them, against the whole.
 */

namespace
{
  constexpr unsigned int none = numbers::invalid_unsigned_int;

  /** Sectors around a centre, whose cells have different axes; refined once. */
  template <int dim>
  std::shared_ptr<Triangulation<dim>>
  sectors()
  {
    const auto mesh = std::make_shared<Triangulation<dim>>();
    GridGenerator::hyper_ball(*mesh);
    mesh->reset_all_manifolds();
    mesh->refine_global(1);
    return mesh;
  }



  template <int dim>
  std::vector<Point<dim>>
  positions(const DoFHandler<dim> &dofs)
  {
    std::vector<Point<dim>> result(dofs.n_dofs());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        result[cell->vertex_dof_index(v, 0)] = cell->vertex(v);
    return result;
  }



  /** The least owner of the units around each node of the whole mesh. */
  template <int dim>
  std::vector<unsigned int>
  least_owners(const DoFHandler<dim>           &whole,
               const std::vector<unsigned int> &unit_owners,
               const unsigned int               depth)
  {
    std::vector<unsigned int> result(whole.n_dofs(), none);
    for (const auto &cell : whole.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        {
          unsigned int &owner = result[cell->vertex_dof_index(v, 0)];
          owner =
            std::min(owner,
                     unit_owners[cell->active_cell_index() >> (dim * depth)]);
        }
    return result;
  }



  template <int dim>
  void
  expect_shares_of_whole(const unsigned int depth, const unsigned int n)
  {
    const auto units = sectors<dim>();
    // Owners without any order.
    const auto owners = std::make_shared<std::vector<unsigned int>>();
    for (unsigned int u = 0; u < units->n_active_cells(); ++u)
      owners->push_back((7 * u + u * u / 5) % n);

    Triangulation<dim> whole;
    whole.copy_triangulation(*units);
    whole.refine_global(depth);
    DoFHandler<dim> whole_dofs(whole);
    whole_dofs.distribute_dofs(FE_Q<dim>(1));
    const auto where       = positions(whole_dofs);
    const auto whole_owner = least_owners(whole_dofs, *owners, depth);

    std::vector<unsigned int> n_own(n, 0), n_cells(n, 0);
    for (const unsigned int owner : whole_owner)
      ++n_own[owner];
    for (unsigned int process = 0; process < n; ++process)
      {
        const UnitRefinement<dim> share(units, owners, depth, process, {0});
        const auto                mesh = share.make_mesh();
        DoFHandler<dim>           dofs(*mesh);
        dofs.distribute_dofs(FE_Q<dim>(1));
        const auto        here    = positions(dofs);
        const auto        cells   = share.cell_numbers(*mesh);
        const NodeNumbers numbers = share.node_numbers(dofs);
        EXPECT_EQ(share.n_cells(), whole.n_active_cells());
        EXPECT_EQ(numbers.n_nodes, whole_dofs.n_dofs());
        ASSERT_EQ(numbers.n_owned.size(), n);

        unsigned int n_found = 0;
        for (unsigned int i = 0; i < here.size(); ++i)
          if (numbers.owner[i] != none)
            {
              const auto serial = numbers.serial[i];
              ASSERT_LT(serial, where.size());
              EXPECT_EQ(here[i].distance(where[serial]), 0.);
              EXPECT_EQ(numbers.owner[i], whole_owner[serial]);
              EXPECT_EQ(numbers.place[i],
                        std::count(whole_owner.begin(),
                                   whole_owner.begin() + serial,
                                   whole_owner[serial]));
              n_found += (numbers.owner[i] == process);
            }
        EXPECT_EQ(n_found, n_own[process]);
        EXPECT_EQ(numbers.n_owned[process], n_own[process]);

        // Cells with an owned node, or on the side, have all numbers.
        for (const auto &cell : dofs.active_cell_iterators())
          {
            const unsigned int number = cells[cell->active_cell_index()];
            EXPECT_EQ(number != none, share.is_real(cell));
            if (number == none)
              continue;
            ++n_cells[process];
            bool is_needed = cell->at_boundary();
            for (const auto v : cell->vertex_indices())
              is_needed |=
                numbers.owner[cell->vertex_dof_index(v, 0)] == process;
            auto there = whole.begin_active();
            std::advance(there, number);
            for (const auto v : cell->vertex_indices())
              {
                EXPECT_EQ(cell->vertex(v).distance(there->vertex(v)), 0.);
                if (is_needed)
                  {
                    EXPECT_NE(numbers.owner[cell->vertex_dof_index(v, 0)],
                              none);
                  }
              }
          }
      }
    if (n > 1 && depth > 1)
      EXPECT_LT(*std::min_element(n_cells.begin(), n_cells.end()),
                whole.n_active_cells());
  }
} // namespace



TEST(UnitRefinement, SharesHaveTheNumbersOfTheWholeInTwoDimensions)
{
  for (const unsigned int depth : {1, 2, 3, 4})
    for (const unsigned int n : {1, 2, 5})
      expect_shares_of_whole<2>(depth, n);
}



TEST(UnitRefinement, SharesHaveTheNumbersOfTheWholeInThreeDimensions)
{
  for (const unsigned int depth : {1, 2})
    for (const unsigned int n : {1, 3})
      expect_shares_of_whole<3>(depth, n);
}
