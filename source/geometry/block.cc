// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/block.h>
#include <stickslip/geometry/coarse_body.h>
#include <stickslip/geometry/smooth_outline.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Sides in the plane of the corners, in the order of the polylines. */
    enum Side
    {
      left,
      right,
      bottom,
      top
    };

    const std::array<const char *, 4> polyline_names = {
      {"Left polyline", "Right polyline", "Bottom polyline", "Top polyline"}};



    /** Sides in the plane of the corners, named as those of bricks. */
    template <int dim>
    std::map<std::string, Side>
    sides_by_name()
    {
      const auto                  names = brick_side_names<dim>();
      std::map<std::string, Side> sides;
      for (const Side side : {left, right, bottom, top})
        sides[names.at(side < bottom ? side : side + 2 * (dim - 2))] = side;
      return sides;
    }



    /** The points of a side, corners of the block included. */
    template <int dim>
    std::vector<Point<2>>
    outline(const Block<dim> &block, const Side side)
    {
      // Numbers of the corners at the ends of each side.
      constexpr unsigned int begin[] = {0, 1, 0, 3}, end[] = {3, 2, 1, 2};
      std::vector<Point<2>>  points = block.polylines[side];
      points.insert(points.begin(), block.corners[begin[side]]);
      points.push_back(block.corners[end[side]]);
      return points;
    }



    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /** The part of a full turn to the left by which b is off a, as a sine; zero
     * if one of them is zero. */
    double
    turn(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      const double product = a.norm() * b.norm();
      return product > 0. ? cross(a, b) / product : 0.;
    }



    // Cells with less than this, about half a degree, are as good as inverted.
    constexpr double least_sine = 0.01;



    template <int dim>
    class BlockGrid
    {
    public:
      explicit BlockGrid(const Block<dim> &block)
        : block(block)
        , n{{block.cells[0], block.cells[dim - 1]}}
      {
        check_corners();
        sides[left]   = divide(left, n[1]);
        sides[right]  = divide(right, n[1]);
        sides[bottom] = divide(bottom, n[0]);
        sides[top]    = divide(top, n[0]);
        check_cells();
      }

      /** The vertex i along the bottom and j along the left side. */
      Point<2>
      vertex(const unsigned int i, const unsigned int j) const
      {
        // Vertices on sides are exactly where both bodies at a fault have them.
        if (j == 0 || j == n[1])
          return sides[j == 0 ? bottom : top][i];
        if (i == 0 || i == n[0])
          return sides[i == 0 ? left : right][j];
        const double u = double(i) / n[0], v = double(j) / n[1];
        const auto  &c = block.corners;
        return Point<2>((1. - v) * sides[bottom][i] + v * sides[top][i] +
                        (1. - u) * sides[left][j] + u * sides[right][j] -
                        (1. - u) * (1. - v) * c[0] - u * (1. - v) * c[1] -
                        u * v * c[2] - (1. - u) * v * c[3]);
      }

    private:
      void
      refuse(const std::string &what) const
      {
        throw InputError("'" + block.section + "/Corners': " + what);
      }

      void
      check_corners() const
      {
        const auto &c    = block.corners;
        double      area = 0.;
        for (unsigned int k = 0; k < 4; ++k)
          {
            const Point<2> &next = c[(k + 1) % 4];
            if (c[k] == next)
              refuse("two corners are at " + position_text(next) +
                     "; a block has four, and bodies of other shapes are made "
                     "with a mesh file.");
            area += cross(c[k], next);
          }
        if (area < 0.)
          refuse("go round the body clockwise; they must go counter-clockwise "
                 "from the lower left one.");
      }

      /** The coarse vertices on a side. */
      std::vector<Point<2>>
      divide(const Side side, const unsigned int n_cells) const
      {
        const std::vector<Point<2>> corners  = outline(block, side);
        const unsigned int          n_pieces = corners.size() - 1;
        const std::string           entry =
          "'" + block.section + "/" + polyline_names[side] + "'";
        if (n_pieces > n_cells)
          throw InputError(
            entry + ": has " + std::to_string(n_pieces) +
            " pieces, and each is at least one cell; there are " +
            std::to_string(n_cells) + " 'Coarse cells' there.");

        // One cell a piece, then always one for that of the longest cells.
        std::vector<unsigned int> cells(n_pieces, 1);
        std::vector<double>       lengths;
        for (unsigned int k = 0; k < n_pieces; ++k)
          {
            lengths.push_back(corners[k].distance(corners[k + 1]));
            if (lengths[k] == 0.)
              throw InputError(entry + ": has two points at " +
                               position_text(corners[k]) +
                               ", corners of the block included.");
          }
        for (unsigned int more = n_pieces; more < n_cells; ++more)
          {
            unsigned int longest = 0;
            // Equal cells are told apart by their order, not by rounding.
            for (unsigned int k = 1; k < n_pieces; ++k)
              if (lengths[k] / cells[k] >
                  (1. + 1e-10) * lengths[longest] / cells[longest])
                longest = k;
            ++cells[longest];
          }

        std::vector<Point<2>> vertices = {corners.front()};
        for (unsigned int k = 0; k < n_pieces; ++k)
          for (unsigned int i = 1; i <= cells[k]; ++i)
            vertices.push_back(i == cells[k] ?
                                 corners[k + 1] :
                                 corners[k] + double(i) / cells[k] *
                                                (corners[k + 1] - corners[k]));
        if (block.is_smooth[side])
          {
            const SmoothOutline curve({corners});
            for (Point<2> &vertex : vertices)
              vertex = curve.place(vertex);
          }
        return vertices;
      }

      void
      check_cells() const
      {
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            {
              const std::array<Point<2>, 4> ring = {{vertex(i, j),
                                                     vertex(i + 1, j),
                                                     vertex(i + 1, j + 1),
                                                     vertex(i, j + 1)}};
              for (unsigned int k = 0; k < 4; ++k)
                if (turn(ring[(k + 1) % 4] - ring[k],
                         ring[(k + 3) % 4] - ring[k]) < least_sine)
                  refuse_cell(ring[k]);
            }
      }

      void
      refuse_cell(const Point<2> &place) const
      {
        if (std::find(block.corners.begin(), block.corners.end(), place) !=
            block.corners.end())
          refuse("the angle inside the body at " + position_text(place) +
                 " must be between 0 and 180 degrees.");
        refuse("cells are inverted at " + position_text(place) +
               ", since the body is not convex or its sides bend too much.");
      }

      const Block<dim>                    &block;
      const std::array<unsigned int, 2>    n;
      std::array<std::vector<Point<2>>, 4> sides;
    };



    /** Appends the points, cells and sides of blocks. */
    template <int dim>
    class BlockCells
    {
    public:
      explicit BlockCells(GroupedCells<dim> &mesh)
        : mesh(mesh)
      {
        for (const auto &side : brick_side_names<dim>())
          mesh.group_names.push_back(side.second);
      }

      void
      add(const Block<dim> &block)
      {
        const BlockGrid<dim> grid(block);
        body = mesh.body_names.size();
        mesh.body_names.push_back(block.name);
        first = mesh.points.size();
        n     = block.cells;
        std::array<unsigned int, dim> last;
        for (unsigned int d = 0; d < dim; ++d)
          last[d] = n[d] + 1;
        for_all(last, [&](const std::array<unsigned int, dim> &at) {
          const Point<2> flat = grid.vertex(at[0], at[dim - 1]);
          Point<dim>     point;
          point[0]       = flat[0];
          point[dim - 1] = flat[1];
          if constexpr (dim == 3)
            point[1] = block.along_y[0] +
                       (block.along_y[1] - block.along_y[0]) * at[1] / n[1];
          mesh.points.push_back(point);
        });
        for_all(n, [&](const std::array<unsigned int, dim> &at) {
          add_cell(at);
          for (unsigned int d = 0; d < dim; ++d)
            for (const unsigned int upper : {0, 1})
              if (at[d] == (upper ? n[d] - 1 : 0))
                add_face(at, d, upper);
        });
      }

    private:
      /** Call a function for all places of a lattice, the first index running
       * fastest. */
      template <typename Function>
      static void
      for_all(const std::array<unsigned int, dim> &size,
              const Function                      &function)
      {
        std::array<unsigned int, dim> at = {};
        while (at[dim - 1] < size[dim - 1])
          {
            function(at);
            for (unsigned int d = 0; d < dim; ++d)
              {
                if (++at[d] < size[d] || d + 1 == dim)
                  break;
                at[d] = 0;
              }
          }
      }

      unsigned int
      node(std::array<unsigned int, dim> at, const unsigned int corner) const
      {
        unsigned int result = 0;
        for (unsigned int d = dim; d-- > 0;)
          result = result * (n[d] + 1) + at[d] + ((corner >> d) & 1u);
        return first + result;
      }

      void
      add_cell(const std::array<unsigned int, dim> &at)
      {
        typename GroupedCells<dim>::Cell cell;
        cell.n_vertices = 1u << dim;
        cell.body       = body;
        for (unsigned int v = 0; v < cell.n_vertices; ++v)
          cell.vertices[v] = node(at, v);
        mesh.cells.push_back(cell);
      }

      void
      add_face(const std::array<unsigned int, dim> &at,
               const unsigned int                   axis,
               const unsigned int                   upper)
      {
        typename GroupedCells<dim>::Face face;
        face.n_vertices = 0;
        face.group      = 2 * axis + upper;
        for (unsigned int v = 0; v < (1u << dim); ++v)
          if (((v >> axis) & 1u) == upper)
            face.vertices[face.n_vertices++] = node(at, v);
        mesh.faces.push_back(face);
      }

      GroupedCells<dim>            &mesh;
      unsigned int                  body, first;
      std::array<unsigned int, dim> n;
    };
  } // namespace



  template <int dim>
  GroupedCells<dim>
  cells_of_blocks(const std::vector<Block<dim>> &blocks)
  {
    GroupedCells<dim> mesh;
    BlockCells<dim>   cells(mesh);
    for (const Block<dim> &block : blocks)
      cells.add(block);
    return mesh;
  }



  template <int dim>
  void
  smoothen(std::vector<Block<dim>> &blocks, const MeshFault &fault)
  {
    const std::map<std::string, Side> sides = sides_by_name<dim>();
    for (const auto &side : fault.between)
      for (const MeshFault::Side &part : side)
        for (Block<dim> &block : blocks)
          if (block.name == part.body && sides.count(part.group) > 0)
            block.is_smooth[sides.at(part.group)] = true;
  }



  template <int dim>
  void
  note_outlines(const std::vector<Block<dim>> &blocks, CutMesh<dim> &mesh)
  {
    const std::map<std::string, Side> sides = sides_by_name<dim>();
    for (unsigned int b = 0; b < blocks.size(); ++b)
      for (const auto &[number, name] : mesh.bodies[b].side_names)
        if (const auto side = sides.find(name); side != sides.end())
          mesh.bodies[b].outlines[number] = outline(blocks[b], side->second);
  }



#define STICKSLIP_INSTANTIATE(dim)                                             \
  template GroupedCells<dim> cells_of_blocks(const std::vector<Block<dim>> &); \
  template void smoothen(std::vector<Block<dim>> &, const MeshFault &);        \
  template void note_outlines(const std::vector<Block<dim>> &, CutMesh<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
