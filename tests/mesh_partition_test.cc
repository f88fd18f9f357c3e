// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>
#include <stickslip/mesh/cell_partition.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  /** A cell by its body and its active cell index. */
  using Cell      = std::pair<unsigned int, unsigned int>;
  using CellPairs = std::vector<std::pair<Cell, Cell>>;

  constexpr std::array<unsigned int, 5> numbers_of_parts = {{2, 3, 4, 8, 16}};



  template <int dim>
  BodyMeshes<dim>
  meshes(const std::vector<BodyGeometry<dim>> &bodies)
  {
    return MeshHierarchy<dim>(bodies, MPI_COMM_WORLD).finest().bodies;
  }



  /** The parts of the cells of a stack. */
  template <int dim>
  std::vector<std::vector<unsigned int>>
  parts_of(const BodyMeshes<dim> &bodies, const unsigned int n_parts)
  {
    return partition_cells<dim>(bodies,
                                numbered_stack<dim>(bodies.size()),
                                n_parts);
  }



  template <int dim>
  unsigned int
  n_cells(const BodyMeshes<dim> &bodies)
  {
    unsigned int n = 0;
    for (const auto &body : bodies)
      n += body->triangulation().n_active_cells();
    return n;
  }



  /** The scenes with more than 1,000 cells: up to 15,000. */
  template <int dim>
  std::vector<BodyMeshes<dim>>
  large_meshes()
  {
    std::vector<BodyMeshes<dim>> result;
    for (const auto &bodies : scenes<dim>())
      for (const unsigned int times : {1, 2})
        {
          result.push_back(meshes<dim>(halved(bodies, times)));
          if (n_cells<dim>(result.back()) <= 1000)
            result.pop_back();
        }
    return result;
  }



  /** Each two cells of a body that share a face or part of one. */
  template <int dim>
  CellPairs
  face_neighbours(const BodyMeshes<dim> &bodies)
  {
    CellPairs pairs;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const auto &cell :
           bodies[b]->triangulation().active_cell_iterators())
        {
          std::vector<typename Triangulation<dim>::active_cell_iterator>
            neighbours;
          GridTools::get_active_neighbors<Triangulation<dim>>(cell, neighbours);
          for (const auto &neighbour : neighbours)
            if (cell->active_cell_index() < neighbour->active_cell_index())
              pairs.push_back({{b, cell->active_cell_index()},
                               {b, neighbour->active_cell_index()}});
        }
    return pairs;
  }



  /** The cells at a height, and the least and largest lateral coordinates. */
  template <int dim>
  std::vector<std::pair<Cell, std::pair<Point<dim>, Point<dim>>>>
  cells_at_height(const BodyMeshes<dim> &bodies,
                  const unsigned int     b,
                  const double           height)
  {
    std::vector<std::pair<Cell, std::pair<Point<dim>, Point<dim>>>> result;
    for (const auto &cell : bodies[b]->triangulation().active_cell_iterators())
      for (const unsigned int v :
           {0u, GeometryInfo<dim>::vertices_per_cell - 1})
        if (std::abs(cell->vertex(v)[dim - 1] - height) < 1e-9)
          result.push_back(
            {{b, cell->active_cell_index()},
             {cell->vertex(0),
              cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1)}});
    return result;
  }



  /** Each two cells that face each other across a fault. */
  template <int dim>
  CellPairs
  opposing_cells(const BodyMeshes<dim> &bodies)
  {
    CellPairs pairs;
    for (unsigned int b = 1; b < bodies.size(); ++b)
      {
        const double height =
          bodies[b]->surface(BodyMesh<dim>::lower_side).points[0][dim - 1];
        const auto below = cells_at_height(bodies, b - 1, height);
        const auto above = cells_at_height(bodies, b, height);
        for (const auto &one : below)
          for (const auto &other : above)
            {
              bool overlap = true;
              for (unsigned int d = 0; d + 1 < dim; ++d)
                overlap =
                  overlap &&
                  std::min(one.second.second[d], other.second.second[d]) -
                      std::max(one.second.first[d], other.second.first[d]) >
                    1e-9;
              if (overlap)
                pairs.push_back({one.first, other.first});
            }
      }
    return pairs;
  }



  unsigned int
  n_split(const std::vector<std::vector<unsigned int>> &owners,
          const CellPairs                              &pairs)
  {
    return std::count_if(pairs.begin(), pairs.end(), [&](const auto &pair) {
      return owners[pair.first.first][pair.first.second] !=
             owners[pair.second.first][pair.second.second];
    });
  }



  std::vector<unsigned int>
  cells_of_parts(const std::vector<std::vector<unsigned int>> &owners,
                 const unsigned int                            n_parts)
  {
    std::vector<unsigned int> n(n_parts, 0);
    for (const auto &of_body : owners)
      for (const unsigned int owner : of_body)
        ++n.at(owner);
    return n;
  }



  /** The number of pieces of all parts together. Cells hang together if they
   * are @p neighbours and belong to the same part. */
  unsigned int
  n_pieces(const std::vector<std::vector<unsigned int>> &owners,
           const CellPairs                              &neighbours)
  {
    std::map<Cell, std::vector<Cell>> joined;
    for (const auto &pair : neighbours)
      if (n_split(owners, {pair}) == 0)
        {
          joined[pair.first].push_back(pair.second);
          joined[pair.second].push_back(pair.first);
        }
    unsigned int   n = 0;
    std::set<Cell> seen;
    for (unsigned int b = 0; b < owners.size(); ++b)
      for (unsigned int c = 0; c < owners[b].size(); ++c)
        if (seen.insert({b, c}).second)
          {
            ++n;
            std::vector<Cell> reached = {{b, c}};
            while (!reached.empty())
              {
                const Cell cell = reached.back();
                reached.pop_back();
                for (const Cell &other : joined[cell])
                  if (seen.insert(other).second)
                    reached.push_back(other);
              }
          }
    return n;
  }



  template <int dim>
  void
  expect_equal_parts()
  {
    for (const BodyMeshes<dim> &bodies : large_meshes<dim>())
      for (const unsigned int n_parts : numbers_of_parts)
        {
          const auto owners = parts_of<dim>(bodies, n_parts);
          ASSERT_EQ(owners.size(), bodies.size());
          for (unsigned int b = 0; b < bodies.size(); ++b)
            ASSERT_EQ(owners[b].size(),
                      bodies[b]->triangulation().n_active_cells());
          const double mean = 1. * n_cells<dim>(bodies) / n_parts;
          for (const unsigned int n : cells_of_parts(owners, n_parts))
            EXPECT_NEAR(n / mean, 1., 0.05) << "with " << n_parts << " parts";
        }
  }



  template <int dim>
  void
  expect_opposing_cells_together()
  {
    for (const BodyMeshes<dim> &bodies : large_meshes<dim>())
      {
        const CellPairs pairs = opposing_cells<dim>(bodies);
        ASSERT_GT(pairs.size(), 100u);
        for (const unsigned int n_parts : numbers_of_parts)
          EXPECT_LT(n_split(parts_of<dim>(bodies, n_parts), pairs),
                    0.03 * pairs.size())
            << "with " << n_parts << " parts";
      }
  }



  /** The parts are not scattered: less is cut than if they were separate
   * squares or cubes, of whose 2 dim sides each is shared by two, and few of
   * them consist of several pieces. So are the parts of twice the size that are
   * made of each two of neighbouring numbers, and so on. */
  template <int dim>
  void
  expect_compact_parts()
  {
    for (const BodyMeshes<dim> &bodies : large_meshes<dim>())
      {
        const CellPairs in_bodies  = face_neighbours<dim>(bodies);
        CellPairs       neighbours = opposing_cells<dim>(bodies);
        neighbours.insert(neighbours.end(), in_bodies.begin(), in_bodies.end());
        for (const unsigned int n_parts : numbers_of_parts)
          {
            auto         owners = parts_of<dim>(bodies, n_parts);
            unsigned int n      = n_parts;
            while (true)
              {
                const double n_sides =
                  dim * n *
                  std::pow(1. * n_cells<dim>(bodies) / n, (dim - 1.) / dim);
                EXPECT_LT(n_split(owners, in_bodies), n_sides)
                  << n_parts << " parts merged to " << n;
                EXPECT_LE(n_pieces(owners, neighbours), n + n / 4)
                  << n_parts << " parts merged to " << n;
                if (n % 2 == 1)
                  break;
                n /= 2;
                for (auto &of_body : owners)
                  for (unsigned int &owner : of_body)
                    owner /= 2;
              }
          }
      }
  }



  /** All that follows from the meshes alone is the same on all processes. */
  template <int dim>
  void
  expect_the_same_again()
  {
    for (const auto &bodies : scenes<dim>())
      for (const unsigned int n_parts : numbers_of_parts)
        EXPECT_EQ(parts_of<dim>(meshes<dim>(bodies), n_parts),
                  parts_of<dim>(meshes<dim>(bodies), n_parts));
  }



  template <int dim>
  void
  expect_least_owners_at_vertices()
  {
    for (const auto &geometries : scenes<dim>())
      {
        const MeshHierarchy<dim> hierarchy(geometries, MPI_COMM_WORLD);
        for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
          {
            const BodyMeshes<dim> &bodies = hierarchy.level(l).bodies;
            const auto             owners = parts_of<dim>(bodies, 5);
            for (unsigned int b = 0; b < bodies.size(); ++b)
              {
                const Triangulation<dim> &mesh = bodies[b]->triangulation();
                const auto                of_vertices =
                  vertex_owners<dim>(*bodies[b], owners[b]);
                const auto cells_at = GridTools::vertex_to_cell_map(mesh);
                ASSERT_EQ(of_vertices.size(), mesh.n_vertices());
                for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
                  {
                    unsigned int least = numbers::invalid_unsigned_int;
                    for (const auto &cell : cells_at[v])
                      for (const auto w : cell->vertex_indices())
                        // The map has the coarse cell at a hanging node too.
                        if (cell->vertex_index(w) == v)
                          least =
                            std::min(least,
                                     owners[b][cell->active_cell_index()]);
                    EXPECT_EQ(of_vertices[v], least);
                    EXPECT_EQ(least != numbers::invalid_unsigned_int,
                              mesh.vertex_used(v));
                  }
              }
          }
      }
  }



  /** On coarser levels the owner of a node is that of the node of the finest
   * level at the same place. */
  template <int dim>
  void
  expect_inherited_owners(const std::vector<BodyGeometry<dim>> &geometries)
  {
    const MeshHierarchy<dim> hierarchy(geometries, MPI_COMM_WORLD);
    const auto cell_owners = parts_of<dim>(hierarchy.finest().bodies, 5);
    for (unsigned int b = 0; b < geometries.size(); ++b)
      {
        const auto               &finest = *hierarchy.finest().bodies[b];
        std::vector<unsigned int> owners =
          vertex_owners<dim>(finest, cell_owners[b]);
        const auto less = [](const Point<dim> &p, const Point<dim> &q) {
          return std::lexicographical_compare(&p[0],
                                              &p[0] + dim,
                                              &q[0],
                                              &q[0] + dim);
        };
        std::map<Point<dim>, unsigned int, decltype(less)> owner_at(less);
        for (unsigned int v = 0; v < owners.size(); ++v)
          owner_at[finest.triangulation().get_vertices()[v]] = owners[v];
        for (unsigned int l = hierarchy.n_levels() - 1; l > 0; --l)
          {
            const auto &coarse = *hierarchy.level(l - 1).bodies[b];
            owners             = inherited_vertex_owners<dim>(coarse,
                                                  *hierarchy.level(l).bodies[b],
                                                  owners);
            for (const auto &cell :
                 coarse.triangulation().active_cell_iterators())
              for (const auto v : cell->vertex_indices())
                {
                  const auto found = owner_at.find(cell->vertex(v));
                  ASSERT_NE(found, owner_at.end());
                  EXPECT_EQ(owners[cell->vertex_index(v)], found->second);
                }
          }
      }
  }
} // namespace



TEST(MeshPartition, PartsHaveTheSameNumberOfCells)
{
  expect_equal_parts<2>();
  expect_equal_parts<3>();
}



TEST(MeshPartition, OpposingCellsBelongTogether)
{
  expect_opposing_cells_together<2>();
  expect_opposing_cells_together<3>();
}



TEST(MeshPartition, PartsAreCompact)
{
  expect_compact_parts<2>();
  expect_compact_parts<3>();
}



TEST(MeshPartition, IsAFunctionOfTheMeshes)
{
  expect_the_same_again<2>();
  expect_the_same_again<3>();
}



TEST(MeshPartition, OnePartHasAllCells)
{
  for (const auto &of_body :
       parts_of<2>(meshes<2>(layered_bodies()), /*n_parts=*/1))
    for (const unsigned int owner : of_body)
      EXPECT_EQ(owner, 0u);
}



TEST(MeshPartition, SomePartsMayBeEmpty)
{
  // Eight cells.
  const auto bodies = meshes<2>(
    stack<2>({make_body<2>(1., {{3, 1}}, 0), make_body<2>(1., {{5, 1}}, 0)}));
  for (unsigned int n_parts = 1; n_parts < 40; ++n_parts)
    {
      const auto         owners  = parts_of<2>(bodies, n_parts);
      const auto         n       = cells_of_parts(owners, n_parts);
      const unsigned int n_empty = std::count(n.begin(), n.end(), 0u);
      EXPECT_LE(n_empty, n_parts < 8 ? n_parts / 2 : n_parts - 8);
      EXPECT_EQ(std::accumulate(n.begin(), n.end(), 0u), 8u);
    }
}



TEST(MeshPartition, VerticesBelongToTheLeastOwner)
{
  expect_least_owners_at_vertices<2>();
  expect_least_owners_at_vertices<3>();
}



TEST(MeshPartition, CoarserNodesHaveTheOwnerOfTheFineOneThere)
{
  for (const unsigned int times : {0, 1, 2})
    {
      for (const auto &bodies : scenes<2>())
        expect_inherited_owners<2>(halved(bodies, times));
      for (const auto &bodies : scenes<3>())
        expect_inherited_owners<3>(halved(bodies, times));
    }
}
