// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_cell_faces_h
#define stickslip_geometry_cell_faces_h

#include <stickslip/geometry/grouped_cells.h>

#include <algorithm>
#include <array>
#include <vector>

namespace StickSlip
{
  /** The faces of cells: which cells have them, and which faces a cell has. */
  template <int dim>
  class CellFaces
  {
  public:
    static constexpr unsigned int none = numbers::invalid_unsigned_int;

    /** The vertices of a face in rising order, then the invalid number. */
    using Key = std::array<unsigned int, (1u << (dim - 1))>;

    struct Face
    {
      Key key;

      /** One or two cells; the second may be none. */
      std::array<unsigned int, 2> cells;

      /** Vertices in an order that goes round, as the first cell has them. */
      std::array<unsigned int, (1u << (dim - 1))> ring;
      unsigned int                                n_vertices;

      bool
      is_interior() const
      {
        return cells[1] != none;
      }
    };

    CellFaces() = default;

    /** Throws InputError if more than two cells have a face. */
    explicit CellFaces(const GroupedCells<dim> &mesh);

    const std::vector<Face> &
    faces() const
    {
      return all_faces;
    }

    /** Numbers of the faces of a cell. */
    const std::vector<unsigned int> &
    faces_of_cell(const unsigned int cell) const
    {
      return of_cell[cell];
    }

    /** The number of a face with these vertices, or none. */
    unsigned int
    find(const Key &key) const;

    template <typename Vertices>
    static Key
    make_key(const Vertices &vertices, const unsigned int n_vertices);

  private:
    std::vector<Face>                      all_faces;
    std::vector<std::vector<unsigned int>> of_cell;
  };



  template <int dim>
  template <typename Vertices>
  typename CellFaces<dim>::Key
  CellFaces<dim>::make_key(const Vertices    &vertices,
                           const unsigned int n_vertices)
  {
    Key key;
    key.fill(none);
    std::copy(vertices.begin(), vertices.begin() + n_vertices, key.begin());
    std::sort(key.begin(), key.end());
    return key;
  }
} // namespace StickSlip

#endif
