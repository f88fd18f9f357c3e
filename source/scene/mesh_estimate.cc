// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/face_area.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/scene/mesh_estimate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace StickSlip
{
  namespace
  {
    // More coarse cells, or faces, than this are not made for a count.
    constexpr double most_coarse_cells = 1e6;



    /** Vertices of a line, triangle or quadrilateral. */
    template <int dim>
    using FaceVertices = std::vector<Point<dim>>;



    /** The parts of a face that is refined once. */
    template <int dim>
    std::vector<FaceVertices<dim>>
    children_of(const FaceVertices<dim> &f)
    {
      const auto middle = [&](const unsigned int i, const unsigned int j) {
        return 0.5 * (f[i] + f[j]);
      };
      if (f.size() == 2)
        return {{f[0], middle(0, 1)}, {middle(0, 1), f[1]}};
      const Point<dim> m01 = middle(0, 1), m02 = middle(0, 2),
                       m12 = middle(1, 2);
      if (f.size() == 3)
        return {{f[0], m01, m02},
                {f[1], m01, m12},
                {f[2], m02, m12},
                {m01, m12, m02}};
      const Point<dim> m13 = middle(1, 3), m23 = middle(2, 3),
                       centre = 0.5 * (m01 + m23);
      return {{f[0], m01, m02, centre},
              {m01, f[1], centre, m13},
              {m02, centre, f[2], m23},
              {centre, m13, m23, f[3]}};
    }



    template <int dim>
    bool
    is_refined(const std::function<double(const Point<dim> &)> &refine_where,
               const FaceVertices<dim>                         &face)
    {
      Point<dim> centre;
      for (const Point<dim> &vertex : face)
        {
          if (refine_where(vertex) > 0.)
            return true;
          centre += vertex / double(face.size());
        }
      return refine_where(centre) > 0.;
    }



    /** Nodes of meshes that are divided between processes, at least: they are
     * as coarse as leaves so many, up to 2^d times as many. */
    template <int dim>
    constexpr double least_divided_nodes =
      MeshHierarchy<dim>::usual_nodes_per_process
        *MeshHierarchy<dim>::least_units;



    /** Coarse faces at faults on one side of a body. */
    struct SideCount
    {
      double faces = 0., size = 0., largest_edge = 0.,
             smallest_edge = std::numeric_limits<double>::max();
    };



    /** Counts of a body before any refinement. */
    template <int dim>
    struct CoarseCount
    {
      /** With the edges and, in three dimensions, the faces of cells. */
      double cells = 0., nodes = 0., edges = 0., faces_of_cells = 0.;

      /** Cells with a vertex at a fault where passes refine. */
      double at_faults = 0.;

      double aspect_ratio = 1.;
      bool   is_simplex   = false;

      std::map<types::boundary_id, SideCount> sides;

      /** Faces at faults, where passes do not refine all of them. */
      std::map<types::boundary_id, std::vector<FaceVertices<dim>>> faces;
    };



    /** Number of cells of a brick or block; zero in a mesh file, whose cells
     * are there. */
    template <int dim>
    double
    given_cells(const SceneParameters<dim> &scene, const unsigned int b)
    {
      if (!scene.mesh_entries.files.empty())
        return 0.;
      double product = 1.;
      for (const unsigned int n : scene.bodies[b].geometry.coarse_cells)
        product *= n;
      return product;
    }



    /** Greatest distance of centres of opposite faces of a cell over the
     * second one. */
    template <int dim>
    double
    aspect_ratio(const typename Triangulation<dim>::cell_iterator &cell)
    {
      std::array<double, dim> lengths;
      for (unsigned int axis = 0; axis < dim; ++axis)
        lengths[axis] = cell->face(2 * axis)->center().distance(
          cell->face(2 * axis + 1)->center());
      std::sort(lengths.begin(), lengths.end());
      return lengths[dim - 1] / lengths[dim - 2];
    }



    template <int dim>
    FaceVertices<dim>
    vertices_of(const typename Triangulation<dim>::face_iterator &face)
    {
      FaceVertices<dim> vertices;
      for (const auto v : face->vertex_indices())
        vertices.push_back(face->vertex(v));
      return vertices;
    }



    template <int dim>
    void
    note_edges(SideCount &side, const FaceVertices<dim> &face)
    {
      for (unsigned int i = 0; i < face.size(); ++i)
        {
          const double edge =
            face[i].distance(face[face.size() == 4 ? (i ^ (i < 2 ? 1 : 2)) :
                                                     (i + 1) % face.size()]);
          side.largest_edge  = std::max(side.largest_edge, edge);
          side.smallest_edge = std::min(side.smallest_edge, edge);
        }
    }



    template <int dim>
    void
    add_face(SideCount &side, const FaceVertices<dim> &face)
    {
      side.faces += 1.;
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_face> vertices;
      std::copy(face.begin(), face.end(), vertices.begin());
      side.size += face_area<dim>(vertices, face.size()).norm();
      note_edges(side, face);
    }



    template <int dim>
    CoarseCount<dim>
    count_cells(const Triangulation<dim> &mesh,
                const CoarseBody<dim>    &body,
                const FaultTopology      &topology,
                const unsigned int        number)
    {
      CoarseCount<dim> count;
      count.cells = mesh.n_active_cells();
      count.nodes = mesh.n_used_vertices();
      count.edges = mesh.n_active_lines();
      if constexpr (dim == 3)
        count.faces_of_cells = mesh.n_active_faces();
      count.is_simplex = mesh.all_reference_cells_are_simplex();
      std::set<unsigned int> refined_vertices;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          if (!count.is_simplex)
            count.aspect_ratio =
              std::max(count.aspect_ratio, aspect_ratio<dim>(cell));
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                topology.is_at_fault(number, face->boundary_id()))
              {
                const FaceVertices<dim> vertices = vertices_of<dim>(face);
                add_face(count.sides[face->boundary_id()], vertices);
                if (body.refine_where)
                  count.faces[face->boundary_id()].push_back(vertices);
                for (unsigned int v = 0; v < face->n_vertices(); ++v)
                  if (!body.refine_where ||
                      body.refine_where(face->vertex(v)) > 0. ||
                      body.refine_where(face->center()) > 0.)
                    refined_vertices.insert(face->vertex_index(v));
              }
        }
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto v : cell->vertex_indices())
          if (refined_vertices.count(cell->vertex_index(v)) > 0)
            {
              count.at_faults += 1.;
              break;
            }
      return count;
    }



    /** Refine faces of a side all over, then in passes where it is said, and
     * count them; adds to the number that each pass refines. */
    template <int dim>
    void
    refine_side(SideCount                                       &side,
                std::vector<FaceVertices<dim>>                   faces,
                const std::function<double(const Point<dim> &)> &refine_where,
                const unsigned int                               uniform,
                std::vector<double>                             &refined)
    {
      const double       n_children = std::exp2(dim - 1.);
      const unsigned int n          = uniform + refined.size();
      // Each of the faces stands for so many.
      double multiple = 1.;
      side            = {0., side.size};
      for (unsigned int pass = 0; pass < n; ++pass)
        {
          std::vector<FaceVertices<dim>> next;
          const bool                     is_too_many =
            faces.size() * n_children > most_coarse_cells;
          for (const FaceVertices<dim> &face : faces)
            {
              if (pass >= uniform && !is_refined(refine_where, face))
                {
                  side.faces += multiple;
                  continue;
                }
              if (pass >= uniform)
                refined[pass - uniform] += multiple;
              if (is_too_many)
                next.push_back(face);
              else
                for (FaceVertices<dim> &child : children_of(face))
                  next.push_back(std::move(child));
            }
          if (next.empty())
            break;
          if (is_too_many)
            multiple *= n_children;
          faces = std::move(next);
        }
      side.faces += multiple * faces.size();
      for (const FaceVertices<dim> &face : faces)
        note_edges(side, face);
      const double halves = std::pow(multiple, 1. / (dim - 1));
      side.largest_edge /= halves;
      side.smallest_edge /= halves;
    }



    /** Halve all cells: edges and faces have a new node in the middle, and so
     * have quadrilaterals and hexahedra; tetrahedra have a new edge inside. */
    template <int dim>
    void
    halve(CoarseCount<dim> &count)
    {
      double &nodes = count.nodes, &edges = count.edges,
             &faces = count.faces_of_cells, &cells = count.cells;
      const bool is_simplex = count.is_simplex;
      nodes += is_simplex ? edges : edges + faces + cells;
      edges *= 2.;
      if (dim == 2)
        edges += (is_simplex ? 3. : 4.) * cells;
      else
        {
          edges += is_simplex ? 3. * faces + cells : 4. * faces + 6. * cells;
          faces = 4. * faces + (is_simplex ? 8. : 12.) * cells;
        }
      cells *= std::exp2(dim);
    }



    /** Refine what has been counted. */
    template <int dim>
    void
    refine(CoarseCount<dim>                                &count,
           const std::function<double(const Point<dim> &)> &refine_where,
           const unsigned int                               uniform,
           const unsigned int                               passes,
           const unsigned int                               rows)
    {
      // Cells at a fault for each of its faces.
      double coarse_faces = 0.;
      for (const auto &[indicator, faces] : count.faces)
        for (const FaceVertices<dim> &face : faces)
          if (is_refined(refine_where, face))
            coarse_faces += 1.;
      const double cells_per_face =
        coarse_faces > 0. ? count.at_faults / coarse_faces : 1.;

      const double halves = std::exp2(uniform), faces = std::exp2(dim - 1.);
      for (unsigned int i = 0; i < uniform; ++i)
        halve(count);
      double       at_faults = count.at_faults * std::pow(halves, dim - 1);
      const double new_nodes = count.is_simplex ? dim : dim == 2 ? 4. : 10.;
      std::vector<double> refined(passes, 0.);
      for (const auto &[indicator, faces] : count.faces)
        refine_side(
          count.sides[indicator], faces, refine_where, uniform, refined);
      for (unsigned int pass = 0; pass < passes; ++pass)
        {
          if (!count.faces.empty())
            at_faults = cells_per_face * refined[pass];
          count.cells += (2. * faces - 1.) * rows * at_faults;
          count.nodes += new_nodes * rows * at_faults;
          at_faults *= faces;
        }
      const double all_halves = std::exp2(uniform + passes);
      for (auto &[indicator, side] : count.sides)
        {
          if (count.faces.count(indicator) > 0)
            continue;
          side.faces *= std::pow(all_halves, dim - 1);
          side.largest_edge /= all_halves;
          side.smallest_edge /= all_halves;
        }
    }
  } // namespace



  double
  MeshEstimate::memory(const unsigned int dim,
                       const unsigned int n_processes) const
  {
    const double of_meshes = dim == 2 ? 0.7e3 : 1.1e3,
                 of_rest   = dim == 2 ? 2.8e3 : 9e3;
    return n_processes * (175. * 1048576. +
                          (n_processes > 1 ? of_meshes * whole_nodes : 0.)) +
           (of_meshes + of_rest) * nodes;
  }



  template <int dim>
  MeshEstimate
  estimate_meshes(const SceneParameters<dim> &scene)
  {
    MeshEstimate estimate;
    double       given = 0.;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      given += given_cells(scene, b);
    std::vector<CoarseBody<dim>> bodies;
    if (given < most_coarse_cells)
      bodies = scene.coarse_bodies();

    std::vector<CoarseCount<dim>> counts(scene.bodies.size());
    double                        undivided = 0., divided = 0., coarse = 0.;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const BodyGeometry<dim> &geometry      = scene.bodies[b].geometry;
        unsigned int             n_refinements = geometry.uniform_refinements;
        if (bodies.empty())
          {
            CoarseCount<dim> &count = counts[b];
            count.cells = count.nodes = given_cells(scene, b);
            count.edges               = dim * count.cells;
            count.faces_of_cells      = dim == 3 ? 3. * count.cells : 0.;
          }
        else if (bodies[b].refined_cells.empty())
          counts[b] =
            count_cells(*bodies[b].cells, bodies[b], scene.topology, b);
        if (geometry.rigid)
          continue;
        const double coarse_nodes = counts[b].nodes;
        if (!bodies.empty() && !bodies[b].refined_cells.empty())
          {
            const BodyMesh<dim> mesh(bodies[b],
                                     scene.topology.sides_at_faults(b));
            counts[b] =
              count_cells(mesh.triangulation(), bodies[b], scene.topology, b);
            n_refinements = mesh.triangulation().n_levels() - 1;
          }
        else
          {
            refine<dim>(counts[b],
                        bodies.empty() ?
                          std::function<double(const Point<dim> &)>() :
                          bodies[b].refine_where,
                        geometry.uniform_refinements,
                        geometry.refinement_passes,
                        geometry.refinement_rows);
            if (counts[b].at_faults > 0.)
              n_refinements += geometry.refinement_passes;
          }
        estimate.cells += counts[b].cells;
        estimate.nodes += counts[b].nodes;
        if (!bodies.empty() && BodyMesh<dim>::can_have_units(bodies[b]))
          {
            divided += counts[b].nodes;
            coarse += coarse_nodes;
          }
        else
          undivided += counts[b].nodes;
        estimate.levels =
          std::max(estimate.levels,
                   1 + n_refinements +
                     static_cast<unsigned int>(scene.coarser_meshes.size()));
        if (counts[b].aspect_ratio > estimate.aspect_ratio)
          {
            estimate.aspect_ratio   = counts[b].aspect_ratio;
            estimate.stretched_body = b;
          }
      }

    estimate.whole_nodes =
      undivided +
      std::max(coarse,
               std::min(divided, least_divided_nodes<dim> * std::exp2(dim)));

    for (const Fault &fault : scene.topology.faults())
      {
        std::array<MeshEstimate::OfFault, 2> sides;
        for (const unsigned int s : {0, 1})
          for (const BodySide &part : fault.sides[s])
            {
              const auto found = counts[part.body].sides.find(part.side);
              if (found == counts[part.body].sides.end() ||
                  scene.bodies[part.body].geometry.rigid)
                continue;
              const SideCount       &side = found->second;
              MeshEstimate::OfFault &sum  = sides[s];
              sum.smallest_edge =
                sum.faces == 0. ?
                  side.smallest_edge :
                  std::min(sum.smallest_edge, side.smallest_edge);
              sum.largest_edge = std::max(sum.largest_edge, side.largest_edge);
              sum.faces += side.faces;
              sum.is_refined_in_part |=
                counts[part.body].faces.count(part.side) > 0;
              sum.size += side.size;
            }
        const bool second =
          sides[0].faces == 0. ||
          (sides[1].faces > 0. &&
           sides[1].size * sides[0].faces < sides[0].size * sides[1].faces);
        estimate.faults.push_back(sides[second]);
      }
    return estimate;
  }



  template <int dim>
  void
  refuse_too_large_meshes(const SceneParameters<dim> &scene,
                          const unsigned int          n_processes,
                          const double                available_memory)
  {
    refuse_too_large(estimate_meshes(scene),
                     dim,
                     n_processes,
                     available_memory);
  }



  void
  refuse_too_large(const MeshEstimate &estimate,
                   const unsigned int  dim,
                   const unsigned int  n_processes,
                   const double        available_memory)
  {
    const double memory = estimate.memory(dim, n_processes);
    if (memory <= available_memory)
      return;
    std::ostringstream message;
    message.precision(3);
    message << "The meshes would have about " << rounded_count(estimate.cells)
            << " cells and " << rounded_count(estimate.unknowns(dim))
            << " unknowns, which take about "
            << rounded_count(memory / 1073741824.)
            << " GiB of memory, and this machine has "
            << available_memory / 1073741824.
            << " GiB; 'Coarse cells', 'Uniform refinements' and 'Refinement "
               "passes' of the bodies must be smaller.";
    throw InputError(message.str());
  }



  std::string
  rounded_count(const double n)
  {
    std::ostringstream text;
    text.precision(3);
    if (!(n < 1e10))
      {
        text << n;
        return text.str();
      }
    const double unit =
      n < 1000. ? 1. : std::pow(10., std::floor(std::log10(n)) - 2.);
    std::string digits =
      std::to_string(std::llround(std::round(n / unit) * unit));
    for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
      digits.insert(i, ",");
    return digits;
  }



  template MeshEstimate
  estimate_meshes(const SceneParameters<2> &);
  template MeshEstimate
  estimate_meshes(const SceneParameters<3> &);
  template void
  refuse_too_large_meshes(const SceneParameters<2> &,
                          const unsigned int,
                          const double);
  template void
  refuse_too_large_meshes(const SceneParameters<3> &,
                          const unsigned int,
                          const double);
} // namespace StickSlip
