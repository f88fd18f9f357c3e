// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_shape.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** The nodes of a piece of a fault in the order of the way along it, and
     * how far they are from the first one, m. */
    struct Piece
    {
      std::vector<unsigned int> nodes;
      std::vector<double>       distances;
      double                    length   = 0.;
      bool                      is_close = false;
    };



    /** Steps from node to node along the faces, in the direction of the
     * tangents. */
    class Ways
    {
    public:
      explicit Ways(const FaultShape<2> &fault)
        : next(fault.surface.points.size(), none)
        , previous(next)
        , lengths(next.size())
      {
        for (unsigned int f = 0; f < fault.surface.faces.size(); ++f)
          {
            auto       nodes = fault.surface.faces[f];
            const auto ends =
              fault.surface.face_vertices(fault.surface.points, f);
            const Tensor<1, 2> way = ends[1] - ends[0];
            Tensor<1, 2>       tangent;
            for (const unsigned int node : nodes)
              for (unsigned int d = 0; d < 2; ++d)
                tangent[d] += fault.axes[node][d][0];
            if (way * tangent < 0.)
              std::swap(nodes[0], nodes[1]);
            next[nodes[0]]     = nodes[1];
            previous[nodes[1]] = nodes[0];
            lengths[nodes[0]]  = way.norm();
          }
      }

      bool
      is_first(const unsigned int node) const
      {
        return previous[node] == none;
      }

      /** The piece that begins at a node. */
      Piece
      piece(const unsigned int first) const
      {
        Piece        piece;
        unsigned int node = first;
        do
          {
            piece.nodes.push_back(node);
            piece.distances.push_back(piece.length);
            if (next[node] != none)
              piece.length += lengths[node];
            node = next[node];
          }
        while (node != none && node != first);
        piece.is_close = (node == first);
        return piece;
      }

    private:
      static constexpr unsigned int none = numbers::invalid_unsigned_int;

      std::vector<unsigned int> next, previous;
      std::vector<double>       lengths;
    };



    /** The pieces of a fault: those with ends, then those without. */
    std::vector<Piece>
    pieces(const FaultShape<2> &fault)
    {
      const std::vector<Point<2>> &points = fault.surface.points;
      const Ways                   ways(fault);
      std::vector<Piece>           result;
      std::vector<bool>            done(points.size(), false);
      const auto                   add = [&](const unsigned int first) {
        result.push_back(ways.piece(first));
        for (const unsigned int node : result.back().nodes)
          done[node] = true;
      };
      for (unsigned int k = 0; k < points.size(); ++k)
        if (ways.is_first(k))
          add(k);

      std::vector<unsigned int> order(points.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const unsigned int a, const unsigned int b) {
                         return std::make_pair(points[a][0], points[a][1]) <
                                std::make_pair(points[b][0], points[b][1]);
                       });
      for (const unsigned int k : order)
        if (!done[k])
          add(k);
      return result;
    }



    /** The pieces with ends as they follow each other: each is the one that
     * begins next to where the last one has ended. The first one is that whose
     * beginning is the farthest from all ends. */
    std::vector<Piece>
    in_order(std::vector<Piece> pieces, const std::vector<Point<2>> &points)
    {
      const auto gap = [&](const Piece &before, const Piece &after) {
        return points[before.nodes.back()].distance(
          points[after.nodes.front()]);
      };
      const auto gap_before = [&](const Piece &piece) {
        double least = std::numeric_limits<double>::max();
        for (const Piece &other : pieces)
          if (&other != &piece)
            least = std::min(least, gap(other, piece));
        return least;
      };
      std::size_t first = 0;
      for (std::size_t k = 1; k < pieces.size(); ++k)
        if (gap_before(pieces[k]) > gap_before(pieces[first]))
          first = k;
      std::swap(pieces.front(), pieces[first]);
      for (auto next = pieces.begin() + 1; next < pieces.end(); ++next)
        std::iter_swap(next,
                       std::min_element(next,
                                        pieces.end(),
                                        [&](const Piece &a, const Piece &b) {
                                          return gap(*(next - 1), a) <
                                                 gap(*(next - 1), b);
                                        }));
      return pieces;
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  vertices_around(const FaultSurface<dim> &surface, const unsigned int face)
  {
    std::vector<unsigned int> result(surface.n_vertices_of(face));
    std::iota(result.begin(), result.end(), 0);
    // Vertices of a quadrilateral are kept row by row.
    if constexpr (dim == 3)
      if (result.size() == 4)
        std::swap(result[2], result[3]);
    return result;
  }



  std::vector<double>
  arc_lengths(const FaultShape<2> &fault)
  {
    const std::vector<Point<2>> &points = fault.surface.points;
    AssertDimension(fault.axes.size(), points.size());
    std::vector<Piece> all = pieces(fault);
    const auto         first_close =
      std::find_if(all.begin(), all.end(), [](const Piece &piece) {
        return piece.is_close;
      });
    std::vector<Piece> ordered(all.begin(), first_close);
    if (!ordered.empty())
      ordered = in_order(ordered, points);
    ordered.insert(ordered.end(), first_close, all.end());

    std::vector<double> result(points.size());
    double              length = 0.;
    for (unsigned int k = 0; k < ordered.size(); ++k)
      {
        const Piece &piece = ordered[k];
        if (k > 0)
          length += points[ordered[k - 1].nodes.back()].distance(
            points[piece.nodes.front()]);
        for (unsigned int i = 0; i < piece.nodes.size(); ++i)
          result[piece.nodes[i]] = length + piece.distances[i];
        length += piece.length;
      }
    return result;
  }



  template decltype(vertices_around<2>) vertices_around<2>;
  template decltype(vertices_around<3>) vertices_around<3>;
} // namespace StickSlip
