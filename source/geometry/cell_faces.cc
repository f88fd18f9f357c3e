// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/reference_cell.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/cell_faces.h>

#include <tuple>
#include <utility>

namespace StickSlip
{
  template <int dim>
  CellFaces<dim>::CellFaces(const GroupedCells<dim> &mesh)
    : of_cell(mesh.cells.size())
  {
    // Every face once for each of its cells, then those of equal keys joined.
    std::vector<Face> found;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto         &cell = mesh.cells[c];
        const ReferenceCell shape =
          ReferenceCell::n_vertices_to_type(dim, cell.n_vertices);
        for (const unsigned int f : shape.face_indices())
          {
            Face face       = {};
            face.n_vertices = shape.face_reference_cell(f).n_vertices();
            for (unsigned int v = 0; v < face.n_vertices; ++v)
              face.ring[v] =
                cell.vertices[shape.face_to_cell_vertices(f, v, 1)];
            if constexpr (dim == 3)
              if (face.n_vertices == 4)
                std::swap(face.ring[2], face.ring[3]);
            face.key   = make_key(face.ring, face.n_vertices);
            face.cells = {{c, none}};
            found.push_back(face);
          }
      }
    std::sort(found.begin(), found.end(), [](const Face &a, const Face &b) {
      return std::tie(a.key, a.cells) < std::tie(b.key, b.cells);
    });

    for (const Face &face : found)
      {
        if (all_faces.empty() || all_faces.back().key != face.key)
          all_faces.push_back(face);
        else if (!all_faces.back().is_interior())
          all_faces.back().cells[1] = face.cells[0];
        else
          {
            typename GroupedCells<dim>::Face shown = {};
            shown.n_vertices                       = face.n_vertices;
            std::copy(face.ring.begin(),
                      face.ring.end(),
                      shown.vertices.begin());
            throw InputError(
              "The body '" + mesh.body_names[mesh.cells[face.cells[0]].body] +
              "' has a face at " + position_text(mesh.centre(shown)) +
              " that belongs to more than two cells.");
          }
        of_cell[face.cells[0]].push_back(all_faces.size() - 1);
      }
  }



  template <int dim>
  unsigned int
  CellFaces<dim>::find(const Key &key) const
  {
    const auto place =
      std::lower_bound(all_faces.begin(),
                       all_faces.end(),
                       key,
                       [](const Face &face, const Key &wanted) {
                         return face.key < wanted;
                       });
    return place != all_faces.end() && place->key == key ?
             place - all_faces.begin() :
             none;
  }



  template class CellFaces<2>;
  template class CellFaces<3>;
} // namespace StickSlip
