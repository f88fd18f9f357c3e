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
  FaultSurface<dim>
  BodySides<dim>::surface(const types::boundary_id side) const
  {
    constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_face;

    struct Face
    {
      // Degrees of freedom, then positions in the surface.
      std::array<types::global_dof_index, n_vertices>  dofs;
      std::array<std::array<int, dim - 1>, n_vertices> wraps;
      Tensor<1, dim>                                   outward;
    };

    std::map<types::global_dof_index, Point<dim>> nodes;
    std::vector<Face>                             faces;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
            {
              faces.emplace_back();
              faces.back().outward = outward_area<dim>(face, cell->center());
              faces.back().dofs.fill(numbers::invalid_dof_index);
              for (unsigned int v = 0; v < face->n_vertices(); ++v)
                {
                  const auto [dof, wraps] =
                    node_of_vertex(face->vertex_dof_index(v, 0),
                                   face->vertex(v));
                  Point<dim> position = face->vertex(v);
                  for (unsigned int d = 0; d + 1 < dim; ++d)
                    if (wraps[d] != 0)
                      position[d] = lateral_lower[d];
                  faces.back().dofs[v]  = dof;
                  faces.back().wraps[v] = wraps;
                  nodes[dof]            = position;
                }
            }

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
    for (Face &face : faces)
      for (auto &dof : face.dofs)
        if (dof != numbers::invalid_dof_index)
          dof = position[dof];
    std::sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) {
      return std::tie(a.dofs, a.wraps) < std::tie(b.dofs, b.wraps);
    });
    for (const Face &face : faces)
      {
        surface.faces.emplace_back();
        // The invalid numbers of both types have all bits.
        std::copy(face.dofs.begin(),
                  face.dofs.end(),
                  surface.faces.back().begin());
        if (period.norm() > 0)
          surface.wraps.push_back(face.wraps);
      }
    surface.period = period;
    std::vector<Tensor<1, dim>> areas;
    for (const Face &face : faces)
      areas.push_back(face.outward);
    surface.set_normals(areas);
    return surface;
  }



  template struct BodySides<2>;
  template struct BodySides<3>;
} // namespace StickSlip
