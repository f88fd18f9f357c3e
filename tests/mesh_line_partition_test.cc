// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/cell_lines.h>
#include <stickslip/mesh/cell_partition.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  template <int dim>
  BodyMeshes<dim>
  meshes(const std::vector<BodyGeometry<dim>> &bodies)
  {
    return MeshHierarchy<dim>(stack<dim>(bodies), MPI_COMM_WORLD)
      .finest()
      .bodies;
  }



  /** Cells ten times as tall as wide, and seven times above the fault, halved
   * so many times: 1,870, 4,420 and 11,560 cells in 8, 12 and 20 rows. */
  BodyMeshes<2>
  tall_cells(const unsigned int times)
  {
    return meshes<2>(halved<2>({make_body<2>(1., {{100, 2}}, 2),
                                make_body<2>(1., {{70, 2}}, 2)},
                               times));
  }



  /** The parts of a stack of bodies and how they are. */
  template <int dim>
  struct Parts
  {
    const BodyMeshes<dim>                 &bodies;
    unsigned int                           n_parts;
    std::vector<std::vector<unsigned int>> owners;

    Parts(const BodyMeshes<dim> &bodies, const unsigned int n_parts)
      : bodies(bodies)
      , n_parts(n_parts)
      , owners(partition_cells<dim>(bodies,
                                    numbered_stack<dim>(bodies.size()),
                                    n_parts))
    {}

    /** Cells of the largest part over the mean. */
    double
    excess() const
    {
      std::vector<unsigned int> n(n_parts, 0);
      unsigned int              n_all = 0;
      for (const auto &of_body : owners)
        for (const unsigned int owner : of_body)
          {
            ++n[owner];
            ++n_all;
          }
      return 1. * *std::max_element(n.begin(), n.end()) * n_parts / n_all;
    }

    /** The number of parts in each set of cells with the same @p key(centre).
     */
    template <typename Key>
    std::vector<unsigned int>
    parts_of(const Key &key) const
    {
      std::map<std::pair<unsigned int, long>, std::set<unsigned int>> found;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        for (const auto &cell :
             bodies[b]->triangulation().active_cell_iterators())
          found[{b, std::lround(1e6 * key(cell->center()))}].insert(
            owners[b][cell->active_cell_index()]);
      std::vector<unsigned int> result;
      for (const auto &one : found)
        result.push_back(one.second.size());
      return result;
    }

    /** The share of the length of the fault between the first two bodies whose
     * sides have different owners. */
    double
    split_share() const
    {
      static_assert(dim == 2, "Only in the plane.");
      std::array<std::map<double, unsigned int>, 2> owner_up_to;
      for (const unsigned int b : {0, 1})
        for (const auto &cell :
             bodies[b]->triangulation().active_cell_iterators())
          for (const unsigned int v : {0, 1})
            if (const auto up = cell->vertex(2 * (1 - b) + v);
                std::abs(up[1] - 1.) < 1e-9 && v == 1)
              owner_up_to[b][up[0]] = owners[b][cell->active_cell_index()];
      constexpr unsigned int n       = 10000;
      unsigned int           n_split = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double x = -2.5 + 5. * (k + 0.5) / n;
          n_split += owner_up_to[0].upper_bound(x)->second !=
                     owner_up_to[1].upper_bound(x)->second;
        }
      return 1. * n_split / n;
    }
  };
} // namespace



TEST(MeshLinePartition, RowsOfTallCellsAreWhole)
{
  for (const unsigned int times : {0, 1, 2})
    {
      const BodyMeshes<2> bodies = tall_cells(times);
      for (const unsigned int n_parts : {2, 3, 4})
        {
          const Parts<2> parts(bodies, n_parts);
          for (const unsigned int n :
               parts.parts_of([](const Point<2> &x) { return x[1]; }))
            EXPECT_EQ(n, 1u) << times << ' ' << n_parts;
          // Few cells a part in the first of them.
          EXPECT_LE(parts.excess(), times == 0 ? 1.5 : 1.3)
            << times << ' ' << n_parts;
          EXPECT_EQ(parts.split_share(), 0.) << times << ' ' << n_parts;
        }
    }
}



TEST(MeshLinePartition, RowsThatAreTooFewAreCutIntoFewPieces)
{
  // Two rows of 2,000 cells each.
  const BodyMeshes<2> bodies = meshes<2>(
    {make_body<2>(1., {{2000, 1}}, 0), make_body<2>(1., {{2000, 1}}, 0)});
  for (const unsigned int n_parts : {3, 4, 8})
    {
      const Parts<2> parts(bodies, n_parts);
      EXPECT_LE(parts.excess(), 1.5);
      unsigned int n_pieces = 0;
      for (const unsigned int n :
           parts.parts_of([](const Point<2> &x) { return x[1]; }))
        n_pieces += n;
      EXPECT_LE(n_pieces, 2 * n_parts);
    }
}



TEST(MeshLinePartition, StacksOfFlatCellsAreWhole)
{
  const BodyMeshes<3> bodies = meshes<3>(
    {make_body<3>(1., {{5, 5, 10}}, 1), make_body<3>(1., {{6, 6, 10}}, 0)});
  for (const unsigned int n_parts : {2, 3, 4})
    {
      const Parts<3> parts(bodies, n_parts);
      EXPECT_LE(parts.excess(), 1.25);
      for (const unsigned int n : parts.parts_of(
             [](const Point<3> &x) { return x[0] + 1000. * x[1]; }))
        EXPECT_EQ(n, 1u) << n_parts;
    }
}



TEST(MeshLinePartition, StacksGoOnBehindFaults)
{
  // 100 stacks of 32 cells through both bodies.
  const BodyMeshes<3> bodies = meshes<3>(
    {make_body<3>(1., {{10, 10, 16}}, 0), make_body<3>(1., {{10, 10, 16}}, 0)});
  for (const unsigned int n_parts : {2, 3, 8, 16})
    {
      const Parts<3> parts(bodies, n_parts);
      EXPECT_LE(parts.excess(), 1.3);
      std::map<std::pair<long, long>, std::set<unsigned int>> owners;
      for (unsigned int b : {0, 1})
        for (const auto &cell :
             bodies[b]->triangulation().active_cell_iterators())
          owners[{std::lround(1e6 * cell->center()[0]),
                  std::lround(1e6 * cell->center()[1])}]
            .insert(parts.owners[b][cell->active_cell_index()]);
      EXPECT_EQ(owners.size(), 100u);
      for (const auto &of_stack : owners)
        EXPECT_EQ(of_stack.second.size(), 1u) << n_parts;
    }
}



TEST(MeshLinePartition, LinesAreWhereCellsAreFlatAlongOneAxis)
{
  const auto n_pairs = [](const auto &bodies) {
    std::vector<std::size_t> n;
    for (const auto &body : bodies)
      n.push_back(neighbouring_cells(*body, true).size());
    return n;
  };
  // Aspects of 1, 2.8 and 3; of graded meshes as of others.
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(n_pairs(meshes<2>({make_body<2>(1., {{10, 2}}, 3),
                               make_body<2>(1., {{14, 1}}, 2)})),
            (Numbers{0, 0}));
  EXPECT_EQ(n_pairs(meshes<2>({make_body<2>(1., {{15, 1}}, 0),
                               make_body<2>(1., {{1, 15}}, 0)})),
            (Numbers{14, 14}));
  // In space cells that are long along one axis couple in planes.
  EXPECT_EQ(n_pairs(meshes<3>({make_body<3>(1., {{1, 25, 5}}, 0),
                               make_body<3>(1., {{3, 3, 6}}, 0)})),
            (Numbers{0, 3 * 3 * 5}));
  // Finer cells next to coarser ones of the same row.
  std::vector<BodyGeometry<2>> graded = {make_body<2>(1., {{100, 2}}, 1),
                                         make_body<2>(1., {{100, 2}}, 0)};
  graded[0].refine_where.set("0.01 - x");
  const BodyMeshes<2>                  bodies = meshes<2>(graded);
  std::map<unsigned int, unsigned int> sizes;
  const auto pairs = neighbouring_cells(*bodies[0], /*in_lines=*/true);
  for (const unsigned int piece : pieces_of_lines(
         bodies[0]->triangulation().n_active_cells(), pairs, 10000))
    ++sizes[piece];
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[0] + sizes[1], bodies[0]->triangulation().n_active_cells());
  EXPECT_EQ(std::min(sizes[0], sizes[1]), 100u);
}



TEST(MeshLinePartition, PiecesAreConsecutiveAndOfAboutEqualLength)
{
  // A line from 4 over 0 to 2, a ring, and one that is alone.
  const std::vector<CellPair> pairs = {
    {4, 1}, {1, 0}, {0, 3}, {3, 2}, {5, 6}, {6, 7}, {7, 8}, {8, 5}};
  EXPECT_EQ(pieces_of_lines(10, pairs, 10),
            (std::vector<unsigned int>{0, 0, 0, 0, 0, 1, 1, 1, 1, 2}));
  const auto halves = pieces_of_lines(10, pairs, 3);
  EXPECT_EQ(halves[4], halves[1]);
  EXPECT_EQ(halves[3], halves[2]);
  EXPECT_NE(halves[1], halves[3]);
  EXPECT_EQ(std::set<unsigned int>(halves.begin(), halves.end()).size(), 5u);
  EXPECT_EQ(pieces_of_lines(3, {}, 1), (std::vector<unsigned int>{0, 1, 2}));
}
