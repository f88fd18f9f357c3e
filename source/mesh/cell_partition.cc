// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <metis.h>
#include <stickslip/geometry/place_finder.h>
#include <stickslip/mesh/cell_partition.h>

#include <algorithm>
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
    constexpr idx_t within_bodies = 1;
    constexpr idx_t across_faults = 4;



    /** The cells of all bodies, one body after the other; an edge joins two
     * that are better owned by the same process. */
    class CellGraph
    {
    public:
      explicit CellGraph(const unsigned int n_cells)
        : neighbours(n_cells)
      {}

      /** Once for each pair of cells. */
      void
      add_edge(const unsigned int a, const unsigned int b, const idx_t weight)
      {
        neighbours[a].emplace_back(b, weight);
        neighbours[b].emplace_back(a, weight);
      }

      /** The part of each cell. */
      std::vector<unsigned int>
      parts(const unsigned int n_parts) const
      {
        std::vector<unsigned int> result(neighbours.size(), 0);
        if (n_parts >= result.size())
          // METIS would complain on the screen and waste parts.
          std::iota(result.begin(), result.end(), 0);
        else if (n_parts > 1)
          {
            const std::vector<idx_t> found = parts_by_metis(n_parts);
            std::copy(found.begin(), found.end(), result.begin());
          }
        return result;
      }

    private:
      std::vector<idx_t>
      parts_by_metis(const unsigned int n_parts) const
      {
        std::vector<idx_t> row_start = {0}, columns, weights;
        for (const auto &row : neighbours)
          {
            for (const auto &neighbour : row)
              {
                columns.push_back(neighbour.first);
                weights.push_back(neighbour.second);
              }
            AssertThrow(columns.size() <= static_cast<std::size_t>(
                                            std::numeric_limits<idx_t>::max()),
                        ExcMessage("The meshes have more cells than this "
                                   "machine's METIS can count."));
            row_start.push_back(columns.size());
          }

        idx_t options[METIS_NOPTIONS];
        METIS_SetDefaultOptions(options);
        options[METIS_OPTION_NUMBERING] = 0;
        // A fixed seed gives equal results on all processes.
        options[METIS_OPTION_SEED] = 1;

        // By bisection, for the order of the parts in space.
        idx_t              n_cells     = neighbours.size();
        idx_t              n_weights   = 1;
        idx_t              n           = n_parts;
        idx_t              cut_weights = 0;
        std::vector<idx_t> result(n_cells);
        const int          status = METIS_PartGraphRecursive(&n_cells,
                                                    &n_weights,
                                                    row_start.data(),
                                                    columns.data(),
                                                    /*vwgt=*/nullptr,
                                                    /*vsize=*/nullptr,
                                                    weights.data(),
                                                    &n,
                                                    /*tpwgts=*/nullptr,
                                                    /*ubvec=*/nullptr,
                                                    options,
                                                    &cut_weights,
                                                    result.data());
        AssertThrow(status == METIS_OK,
                    ExcMessage("METIS could not distribute " +
                               std::to_string(n_cells) + " cells onto " +
                               std::to_string(n_parts) +
                               " processes and returned " +
                               std::to_string(status) + "."));
        return result;
      }

      std::vector<std::vector<std::pair<unsigned int, idx_t>>> neighbours;
    };



    /** Edges between the cells of one body that share a face or part of one. */
    template <int dim>
    void
    add_edges_within(const BodyMesh<dim> &body,
                     const unsigned int   first_cell,
                     CellGraph           &graph)
    {
      for (const auto &cell : body.triangulation().active_cell_iterators())
        for (const auto face : cell->face_indices())
          if (!cell->at_boundary(face))
            {
              // Each pair once: from the finer cell if there is one. Behind a
              // face of finer cells, the neighbour is not active.
              const auto neighbour = cell->neighbor(face);
              if (neighbour->is_active() &&
                  (cell->neighbor_is_coarser(face) ||
                   cell->active_cell_index() < neighbour->active_cell_index()))
                graph.add_edge(first_cell + cell->active_cell_index(),
                               first_cell + neighbour->active_cell_index(),
                               within_bodies);
            }
    }



    /** A cell on a fault: the extent of its face there, and its number in the
     * graph. */
    template <int dim>
    using FaultCell = std::pair<BoundingBox<dim>, unsigned int>;



    template <int dim>
    std::vector<FaultCell<dim>>
    fault_cells(const std::vector<std::shared_ptr<const BodyMesh<dim>>> &bodies,
                const std::vector<BodySide>                             &parts,
                const std::vector<unsigned int> &first_cell)
    {
      std::vector<FaultCell<dim>> result;
      for (const BodySide &part : parts)
        for (const auto &cell :
             bodies[part.body]->triangulation().active_cell_iterators())
          if (cell->at_boundary())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && face->boundary_id() == part.side)
                result.emplace_back(face->bounding_box(),
                                    first_cell[part.body] +
                                      cell->active_cell_index());
      return result;
    }



    /** Edges between cells whose faces on a fault overlap. */
    template <int dim>
    void
    add_edges_across(const std::vector<FaultCell<dim>> &first,
                     const std::vector<FaultCell<dim>> &second,
                     CellGraph                         &graph)
    {
      const auto                  tree = pack_rtree(second);
      std::vector<FaultCell<dim>> found;
      for (const auto &cell : first)
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
            graph.add_edge(cell.second, other.second, across_faults);
        }
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<unsigned int>>
  partition_cells(
    const std::vector<std::shared_ptr<const BodyMesh<dim>>> &bodies,
    const FaultTopology                                     &topology,
    const unsigned int                                       n_parts)
  {
    AssertThrow(n_parts > 0, ExcMessage("There is no process to own cells."));

    std::vector<unsigned int> first_cell = {0};
    for (const auto &body : bodies)
      first_cell.push_back(first_cell.back() +
                           body->triangulation().n_active_cells());

    std::vector<unsigned int> owners(first_cell.back(), 0);
    if (n_parts > 1)
      {
        CellGraph graph(first_cell.back());
        for (unsigned int i = 0; i < bodies.size(); ++i)
          add_edges_within(*bodies[i], first_cell[i], graph);
        for (const Fault &fault : topology.faults())
          add_edges_across(fault_cells(bodies, fault.sides[0], first_cell),
                           fault_cells(bodies, fault.sides[1], first_cell),
                           graph);
        owners = graph.parts(n_parts);
      }

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
                     const unsigned int);
  template std::vector<std::vector<unsigned int>>
  partition_cells<3>(const std::vector<std::shared_ptr<const BodyMesh<3>>> &,
                     const FaultTopology &,
                     const unsigned int);
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
