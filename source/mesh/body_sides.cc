// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/geometry/face_area.h>
#include <stickslip/mesh/body_sides.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace StickSlip
{
  namespace
  {
    /** The normal of a face away from the centre of its cell, as long as the
     * face is large, m^(dim-1). */
    template <int dim>
    Tensor<1, dim>
    outward_area(const typename Triangulation<dim>::face_iterator &face,
                 const Point<dim>                                 &cell_centre)
    {
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_face> vertices;
      for (const auto v : face->vertex_indices())
        vertices[v] = face->vertex(v);
      const Tensor<1, dim> area = face_area<dim>(vertices, face->n_vertices());
      return area * (face->center() - cell_centre) > 0. ? area : -area;
    }
  } // namespace



  template <int dim>
  std::pair<types::global_dof_index, std::array<int, dim - 1>>
  BodySides<dim>::node_of_vertex(const types::global_dof_index dof,
                                 const Point<dim>             &vertex) const
  {
    std::array<int, dim - 1> wraps    = {};
    bool                     is_image = false;
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      if (period[axis] > 0 &&
          vertex[axis] > lateral_lower[axis] + (1. - 1e-10) * period[axis])
        {
          wraps[axis] = 1;
          is_image    = true;
        }
    if (!is_image)
      return {dof, wraps};
    const auto *entries = constraints.get_constraint_entries(dof);
    AssertThrow(entries != nullptr, ExcInternalError());
    // A hanging node's image: only its place on the other side is asked for
    // here, and that has no node of its own.
    if (entries->size() != 1)
      return {dof, {}};
    return {entries->front().first, wraps};
  }



  template <int dim>
  std::vector<SideFace<dim>>
  BodySides<dim>::faces(
    const types::boundary_id                                side,
    const std::function<bool(
      const typename Triangulation<dim>::cell_iterator &)> &is_wanted) const
  {
    std::vector<SideFace<dim>> result;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->at_boundary() && is_wanted(cell))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
            {
              result.emplace_back();
              SideFace<dim> &its = result.back();
              its.outward        = outward_area<dim>(face, cell->center());
              its.nodes.fill(numbers::invalid_dof_index);
              its.wraps = {};
              for (unsigned int v = 0; v < face->n_vertices(); ++v)
                {
                  std::tie(its.nodes[v], its.wraps[v]) =
                    node_of_vertex(face->vertex_dof_index(v, 0),
                                   face->vertex(v));
                  its.positions[v] = face->vertex(v);
                  for (unsigned int d = 0; d + 1 < dim; ++d)
                    if (its.wraps[v][d] != 0)
                      its.positions[v][d] = lateral_lower[d];
                }
            }
    return result;
  }



  template <int dim>
  FaultSurface<dim>
  surface_of_faces(const std::vector<SideFace<dim>> &faces,
                   const Tensor<1, dim - 1>         &period)
  {
    std::map<types::global_dof_index, Point<dim>> nodes;
    for (const SideFace<dim> &face : faces)
      for (unsigned int v = 0; v < face.nodes.size(); ++v)
        if (face.nodes[v] != numbers::invalid_dof_index)
          nodes[face.nodes[v]] = face.positions[v];

    std::vector<std::pair<Point<dim>, types::global_dof_index>> sorted;
    for (const auto &node : nodes)
      sorted.emplace_back(node.second, node.first);
    std::sort(sorted.begin(), sorted.end(), [](const auto &a, const auto &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.first[d] != b.first[d])
          return a.first[d] < b.first[d];
      return a.second < b.second;
    });

    FaultSurface<dim>                               surface;
    std::map<types::global_dof_index, unsigned int> position;
    for (const auto &node : sorted)
      {
        position[node.second] = surface.nodes.size();
        surface.nodes.push_back(node.second);
        surface.points.push_back(node.first);
      }

    // Faces by the places of their nodes.
    struct Face
    {
      std::array<unsigned int, SideFace<dim>::n_vertices> places;
      decltype(SideFace<dim>::wraps)                      wraps;
      Tensor<1, dim>                                      outward;
    };
    std::vector<Face> placed;
    for (const SideFace<dim> &face : faces)
      {
        placed.push_back({{}, face.wraps, face.outward});
        for (unsigned int v = 0; v < face.nodes.size(); ++v)
          placed.back().places[v] =
            face.nodes[v] == numbers::invalid_dof_index ?
              numbers::invalid_unsigned_int :
              position[face.nodes[v]];
      }
    const auto key = [](const Face &face) {
      return std::tie(face.places, face.wraps);
    };
    std::sort(placed.begin(), placed.end(), [&](const Face &a, const Face &b) {
      return key(a) < key(b);
    });
    placed.erase(std::unique(placed.begin(),
                             placed.end(),
                             [&](const Face &a, const Face &b) {
                               return key(a) == key(b);
                             }),
                 placed.end());

    std::vector<Tensor<1, dim>> areas;
    for (const Face &face : placed)
      {
        surface.faces.push_back(face.places);
        if (period.norm() > 0)
          surface.wraps.push_back(face.wraps);
        areas.push_back(face.outward);
      }
    surface.period = period;
    surface.set_normals(areas);
    return surface;
  }



  template struct SideFace<2>;
  template struct SideFace<3>;
  template FaultSurface<2>
  surface_of_faces<2>(const std::vector<SideFace<2>> &, const Tensor<1, 1> &);
  template FaultSurface<3>
  surface_of_faces<3>(const std::vector<SideFace<3>> &, const Tensor<1, 2> &);
  template struct BodySides<2>;
  template struct BodySides<3>;
} // namespace StickSlip
