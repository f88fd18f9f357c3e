// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <stickslip/base/make_set.h>
#include <stickslip/geometry/place_finder.h>
#include <stickslip/mesh/cell_graph.h>
#include <stickslip/mesh/cell_lines.h>
#include <stickslip/mesh/cell_partition.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    // Weights of edges. A jump joins nodes of both sides, so that a patch of
    // fault is best kept whole. On meshes of more than 1,000 cells, up to 4 %
    // of the pairs across a fault were split with 1 in place of 4, and with 4
    // at most 1.4 %, for 8 % more cuts elsewhere; 16 cost another 7 %, and more
    // parts were in pieces.
    constexpr unsigned int within_bodies = 1;
    constexpr unsigned int across_faults = 4;

    /** A cut across a line, which goes on behind a fault, is dearer than one
     * along it. */
    constexpr unsigned int along_lines = 1000;

    /** Cells of the largest part over the mean that are allowed for whole
     * lines, on meshes with few cells a part and on others. A single line that
     * is cut takes up to twice as many iterations, several of them four times
     * as many. */
    constexpr double few_cells = 1000, largest_of_few = 1.5,
                     largest_of_many = 1.3;



    /** A cell on a fault: the extent of its face there, and its number in the
     * graph. */
    template <int dim>
    using FaultCell = std::pair<BoundingBox<dim>, unsigned int>;

    template <int dim>
    struct FaultCells
    {
      std::vector<FaultCell<dim>> all;
      /** Cells whose lines end at the fault, ascending. */
      std::vector<unsigned int> in_lines;
    };



    template <int dim>
    FaultCells<dim>
    fault_cells(const BodyMeshes<dim>           &bodies,
                const std::vector<BodySide>     &parts,
                const std::vector<unsigned int> &first_cell)
    {
      FaultCells<dim> result;
      for (const BodySide &part : parts)
        for (const auto &cell :
             bodies[part.body]->triangulation().active_cell_iterators())
          if (cell->at_boundary())
            for (const unsigned int f : cell->face_indices())
              if (cell->at_boundary(f) &&
                  cell->face(f)->boundary_id() == part.side)
                {
                  const unsigned int number =
                    first_cell[part.body] + cell->active_cell_index();
                  result.all.emplace_back(cell->face(f)->bounding_box(),
                                          number);
                  if (is_across_line<dim>(cell, f))
                    result.in_lines.push_back(number);
                }
      make_set(result.in_lines);
      return result;
    }



    /** Pairs of cells whose faces on a fault overlap: those that a line goes
     * through, and others. */
    template <int dim>
    void
    add_pairs_across(const FaultCells<dim> &first,
                     const FaultCells<dim> &second,
                     std::vector<CellPair> &through,
                     std::vector<CellPair> &others)
    {
      const auto in_line = [](const FaultCells<dim> &cells,
                              const unsigned int     number) {
        return std::binary_search(cells.in_lines.begin(),
                                  cells.in_lines.end(),
                                  number);
      };
      const auto                  tree = pack_rtree(second.all);
      std::vector<FaultCell<dim>> found;
      for (const auto &cell : first.all)
        {
          // Smaller by more than rounding along the face, lest faces that only
          // touch are found, and larger across it, lest none is.
          auto         corners = cell.first.get_boundary_points();
          const auto   extent  = corners.second - corners.first;
          const double margin  = 1e-6 * extent.norm();
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double by = extent[d] > margin ? margin : -margin;
              corners.first[d] += by;
              corners.second[d] -= by;
            }

          found.clear();
          tree.query(boost::geometry::index::intersects(
                       BoundingBox<dim>(corners)),
                     std::back_inserter(found));
          for (const auto &other : found)
            (in_line(first, cell.second) && in_line(second, other.second) ?
               through :
               others)
              .emplace_back(cell.second, other.second);
        }
    }



    /**
     * The cells of all bodies, counted from one body to the next, and the pairs
     * of them that are better owned by the same process.
     */
    template <int dim>
    class NeighbouringCells
    {
    public:
      NeighbouringCells(const BodyMeshes<dim>           &bodies,
                        const FaultTopology             &topology,
                        const std::vector<unsigned int> &first_cell,
                        const std::vector<std::vector<unsigned int>> &n_finest)
        : n_finer(first_cell.back(), 1)
      {
        for (unsigned int i = 0; i < bodies.size(); ++i)
          {
            const unsigned int first = first_cell[i];
            for (const auto &[a, b] : neighbouring_cells(*bodies[i], false))
              within.emplace_back(first + a, first + b);
            for (const auto &[a, b] : neighbouring_cells(*bodies[i], true))
              in_lines.emplace_back(first + a, first + b);
            if (!n_finest.empty())
              std::copy(n_finest[i].begin(),
                        n_finest[i].end(),
                        n_finer.begin() + first);
          }
        for (const unsigned int n : n_finer)
          n_finer_faces.push_back(std::lround(std::pow(n, (dim - 1.) / dim)));
        for (const Fault &fault : topology.faults())
          add_pairs_across(fault_cells(bodies, fault.sides[0], first_cell),
                           fault_cells(bodies, fault.sides[1], first_cell),
                           through_faults,
                           across);
      }

      /** The part of each cell. Lines are whole, or in as few pieces as it
       * takes for parts that are equal enough. */
      std::vector<unsigned int>
      parts(const unsigned int n_parts) const
      {
        const double mean =
          1. * std::accumulate(n_finer.begin(), n_finer.end(), 0ull) / n_parts;
        for (unsigned int longest = n_finer.size();;)
          {
            const std::vector<unsigned int> result =
              parts_of_pieces(longest, n_parts);
            if (in_lines.empty() || longest == 1)
              return result;
            const std::vector<unsigned int> sizes = count(result);
            if (*std::max_element(sizes.begin(), sizes.end()) <=
                (mean < few_cells ? largest_of_few : largest_of_many) * mean)
              return result;
            longest =
              std::max<unsigned int>(std::min<double>(longest, mean) / 2, 1);
          }
      }

    private:
      /** The number of finest cells in each group. */
      std::vector<unsigned int>
      count(const std::vector<unsigned int> &groups) const
      {
        std::vector<unsigned int> result(1 + *std::max_element(groups.begin(),
                                                               groups.end()),
                                         0);
        for (unsigned int cell = 0; cell < groups.size(); ++cell)
          result[groups[cell]] += n_finer[cell];
        return result;
      }

      /** The part of each cell, pieces of lines with at most @p longest cells
       * being whole. */
      std::vector<unsigned int>
      parts_of_pieces(const unsigned int longest,
                      const unsigned int n_parts) const
      {
        const std::vector<unsigned int> piece =
          pieces_of_lines(n_finer.size(), in_lines, longest);
        CellGraph  graph(count(piece));
        const auto add = [&](const std::vector<CellPair> &pairs,
                             const unsigned int           weight) {
          for (const auto &[a, b] : pairs)
            if (piece[a] != piece[b])
              graph.add_edge(piece[a],
                             piece[b],
                             weight *
                               std::min(n_finer_faces[a], n_finer_faces[b]));
        };
        add(within, within_bodies);
        add(in_lines, along_lines);
        add(through_faults, along_lines);
        add(across, across_faults);
        const std::vector<unsigned int> of_pieces = graph.parts(n_parts);
        std::vector<unsigned int>       result;
        for (const unsigned int p : piece)
          result.push_back(of_pieces[p]);
        return result;
      }

      /** Numbers of finest cells for which each stands, and, but for those that
       * are refined more at faults, of their faces on one of its own. */
      std::vector<unsigned int> n_finer, n_finer_faces;
      std::vector<CellPair>     within, in_lines, through_faults, across;
    };
  } // namespace



  template <int dim>
  std::vector<std::vector<unsigned int>>
  partition_cells(const BodyMeshes<dim>                        &bodies,
                  const FaultTopology                          &topology,
                  const unsigned int                            n_parts,
                  const std::vector<std::vector<unsigned int>> &n_finest)
  {
    AssertThrow(n_parts > 0, ExcMessage("There is no process to own cells."));

    std::vector<unsigned int> first_cell = {0};
    for (const auto &body : bodies)
      first_cell.push_back(first_cell.back() +
                           body->triangulation().n_active_cells());

    const std::vector<unsigned int> owners =
      n_parts == 1 ?
        std::vector<unsigned int>(first_cell.back(), 0) :
        NeighbouringCells<dim>(bodies, topology, first_cell, n_finest)
          .parts(n_parts);

    std::vector<std::vector<unsigned int>> of_body;
    for (unsigned int i = 0; i < bodies.size(); ++i)
      of_body.emplace_back(owners.begin() + first_cell[i],
                           owners.begin() + first_cell[i + 1]);
    return of_body;
  }



  template <int dim>
  std::vector<unsigned int>
  vertex_owners(const BodyMesh<dim>             &body,
                const std::vector<unsigned int> &cell_owners)
  {
    const Triangulation<dim> &mesh = body.triangulation();
    AssertDimension(cell_owners.size(), mesh.n_active_cells());

    // The invalid number is the largest.
    std::vector<unsigned int> owners(mesh.n_vertices(),
                                     numbers::invalid_unsigned_int);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        {
          unsigned int &owner = owners[cell->vertex_index(v)];
          owner = std::min(owner, cell_owners[cell->active_cell_index()]);
        }
    return owners;
  }



  namespace
  {
    template <int dim>
    using CellIterator = typename Triangulation<dim>::cell_iterator;



    template <int dim>
    void
    inherit_below(const CellIterator<dim>         &coarse,
                  const CellIterator<dim>         &fine,
                  const std::vector<unsigned int> &fine_owners,
                  std::vector<unsigned int>       &owners)
    {
      if (coarse->is_active())
        for (const auto v : coarse->vertex_indices())
          owners[coarse->vertex_index(v)] = fine_owners[fine->vertex_index(v)];
      else
        for (unsigned int child = 0; child < coarse->n_children(); ++child)
          inherit_below<dim>(coarse->child(child),
                             fine->child(child),
                             fine_owners,
                             owners);
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  inherited_vertex_owners(const BodyMesh<dim>             &coarse,
                          const BodyMesh<dim>             &fine,
                          const std::vector<unsigned int> &fine_owners)
  {
    std::vector<unsigned int> owners(coarse.triangulation().n_vertices(),
                                     numbers::invalid_unsigned_int);
    if (!coarse.is_nested_with(fine))
      {
        const PlaceFinder<dim> finder(fine.triangulation());
        for (unsigned int v = 0; v < owners.size(); ++v)
          {
            const auto place =
              finder.find(coarse.triangulation().get_vertices()[v]);
            owners[v] =
              fine_owners[std::max_element(place.values.begin(),
                                           place.values.end(),
                                           [](const auto &a, const auto &b) {
                                             return a.second < b.second;
                                           })
                            ->first];
          }
        return owners;
      }
    if (&coarse != &fine && !fine.vertex_parents().empty())
      {
        std::copy_n(fine_owners.begin(), owners.size(), owners.begin());
        return owners;
      }
    auto fine_cell = fine.triangulation().begin(0);
    for (auto cell = coarse.triangulation().begin(0);
         cell != coarse.triangulation().end(0);
         ++cell, ++fine_cell)
      inherit_below<dim>(cell, fine_cell, fine_owners, owners);
    return owners;
  }



  template std::vector<std::vector<unsigned int>>
  partition_cells<2>(const std::vector<std::shared_ptr<const BodyMesh<2>>> &,
                     const FaultTopology &,
                     const unsigned int,
                     const std::vector<std::vector<unsigned int>> &);
  template std::vector<std::vector<unsigned int>>
  partition_cells<3>(const std::vector<std::shared_ptr<const BodyMesh<3>>> &,
                     const FaultTopology &,
                     const unsigned int,
                     const std::vector<std::vector<unsigned int>> &);
  template std::vector<unsigned int>
  vertex_owners<2>(const BodyMesh<2> &, const std::vector<unsigned int> &);
  template std::vector<unsigned int>
  vertex_owners<3>(const BodyMesh<3> &, const std::vector<unsigned int> &);
  template std::vector<unsigned int>
  inherited_vertex_owners<2>(const BodyMesh<2> &,
                             const BodyMesh<2> &,
                             const std::vector<unsigned int> &);
  template std::vector<unsigned int>
  inherited_vertex_owners<3>(const BodyMesh<3> &,
                             const BodyMesh<3> &,
                             const std::vector<unsigned int> &);
} // namespace StickSlip
