// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/geometry/node_welding.h>

#include <iterator>
#include <limits>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** For each vertex of a face with one cell, the least number of one at the
     * same place; for others their own. */
    template <int dim>
    std::vector<unsigned int>
    first_at_place(const GroupedCells<dim> &mesh, const CellFaces<dim> &faces)
    {
      std::vector<unsigned int> boundary;
      double                    shortest = std::numeric_limits<double>::max();
      for (const auto &face : faces.faces())
        if (!face.is_interior())
          for (unsigned int v = 0; v < face.n_vertices; ++v)
            {
              const unsigned int next = face.ring[(v + 1) % face.n_vertices];
              boundary.push_back(face.ring[v]);
              shortest =
                std::min(shortest,
                         mesh.points[face.ring[v]].distance(mesh.points[next]));
            }
      std::sort(boundary.begin(), boundary.end());
      boundary.erase(std::unique(boundary.begin(), boundary.end()),
                     boundary.end());

      using Place = std::pair<Point<dim>, unsigned int>;
      std::vector<Place> places;
      for (const unsigned int v : boundary)
        places.emplace_back(mesh.points[v], v);
      const auto   tree      = pack_rtree(places);
      const double tolerance = 1e-6 * shortest;

      std::vector<unsigned int> first(mesh.points.size());
      std::iota(first.begin(), first.end(), 0);
      std::vector<Place> found;
      for (const Place &place : places)
        {
          Point<dim> lower = place.first, upper = place.first;
          for (unsigned int d = 0; d < dim; ++d)
            {
              lower[d] -= tolerance;
              upper[d] += tolerance;
            }
          found.clear();
          tree.query(boost::geometry::index::intersects(
                       BoundingBox<dim>({lower, upper})),
                     std::back_inserter(found));
          for (const Place &other : found)
            first[place.second] = std::min(first[place.second], other.second);
        }
      return first;
    }
  } // namespace



  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  touching_faces(const GroupedCells<dim> &mesh, const CellFaces<dim> &faces)
  {
    const std::vector<unsigned int> first = first_at_place(mesh, faces);

    using Key = typename CellFaces<dim>::Key;
    std::vector<std::pair<Key, unsigned int>> by_place;
    for (unsigned int f = 0; f < faces.faces().size(); ++f)
      {
        const auto &face = faces.faces()[f];
        if (face.is_interior())
          continue;
        auto ring = face.ring;
        for (unsigned int v = 0; v < face.n_vertices; ++v)
          ring[v] = first[ring[v]];
        by_place.emplace_back(CellFaces<dim>::make_key(ring, face.n_vertices),
                              f);
      }
    std::sort(by_place.begin(), by_place.end());

    std::vector<std::pair<unsigned int, unsigned int>> result;
    for (unsigned int i = 0; i + 1 < by_place.size(); ++i)
      for (unsigned int j = i + 1;
           j < by_place.size() && by_place[j].first == by_place[i].first;
           ++j)
        result.emplace_back(by_place[i].second, by_place[j].second);
    return result;
  }



  template <int dim>
  void
  weld_nodes(GroupedCells<dim> &mesh, const std::vector<bool> &is_welded)
  {
    const CellFaces<dim> faces(mesh);
    std::vector<bool>    is_open(faces.faces().size(), false);
    bool                 any = false;
    for (const auto &face : mesh.faces)
      if (is_welded[face.group])
        {
          const unsigned int f = faces.find(
            CellFaces<dim>::make_key(face.vertices, face.n_vertices));
          if (f != CellFaces<dim>::none && !faces.faces()[f].is_interior())
            any = is_open[f] = true;
        }
    if (!any)
      return;

    const std::vector<unsigned int> first = first_at_place(mesh, faces);
    std::vector<unsigned int>       node(mesh.points.size());
    std::iota(node.begin(), node.end(), 0);
    for (const auto &pair : touching_faces(mesh, faces))
      if (is_open[pair.first] || is_open[pair.second])
        for (const unsigned int f : {pair.first, pair.second})
          for (unsigned int v = 0; v < faces.faces()[f].n_vertices; ++v)
            {
              const unsigned int vertex = faces.faces()[f].ring[v];
              node[vertex]              = first[vertex];
            }
    for (auto &cell : mesh.cells)
      for (unsigned int v = 0; v < cell.n_vertices; ++v)
        cell.vertices[v] = node[cell.vertices[v]];
    for (auto &face : mesh.faces)
      for (unsigned int v = 0; v < face.n_vertices; ++v)
        face.vertices[v] = node[face.vertices[v]];
  }



  template void
  weld_nodes(GroupedCells<2> &, const std::vector<bool> &);
  template void
  weld_nodes(GroupedCells<3> &, const std::vector<bool> &);
  template std::vector<std::pair<unsigned int, unsigned int>>
  touching_faces(const GroupedCells<2> &, const CellFaces<2> &);
  template std::vector<std::pair<unsigned int, unsigned int>>
  touching_faces(const GroupedCells<3> &, const CellFaces<3> &);
} // namespace StickSlip
