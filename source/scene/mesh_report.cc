// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/grid/grid_out.h>
#include <deal.II/grid/grid_tools.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/mesh_report.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** Number of a side in the pictures, where zero is for cells. */
    types::boundary_id
    number(const types::boundary_id side)
    {
      return side + 1;
    }



    template <int dim>
    std::string
    name_of_cells(const Triangulation<dim> &mesh)
    {
      if (mesh.all_reference_cells_are_simplex())
        return dim == 2 ? "triangles" : "tetrahedra";
      return dim == 2 ? "quadrilaterals" : "hexahedra";
    }



    /** Number of parts of a mesh that share no face. */
    template <int dim>
    unsigned int
    n_parts(const Triangulation<dim> &mesh)
    {
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>
        neighbours(mesh.n_active_cells());
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f))
            boost::add_edge(cell->active_cell_index(),
                            cell->neighbor(f)->active_cell_index(),
                            neighbours);
      std::vector<unsigned int> part(mesh.n_active_cells());
      return boost::connected_components(neighbours, part.data());
    }



    /** Number and sizes of the faces on one side. */
    template <int dim>
    struct SideSize
    {
      unsigned int n_faces = 0;
      double       size    = 0.;

      void
      add(const SideSize &other)
      {
        n_faces += other.n_faces;
        size += other.size;
      }

      std::string
      text() const
      {
        std::ostringstream out;
        out << n_faces << (n_faces == 1 ? " face, " : " faces, ") << size
            << (dim == 2 ? " m" : " m^2");
        return out.str();
      }
    };



    /** The size of a face of straight edges, m^(dim-1). */
    template <int dim>
    double
    face_size(const typename Triangulation<dim>::face_iterator &face)
    {
      if constexpr (dim == 2)
        return face->vertex(0).distance(face->vertex(1));
      else if (face->n_vertices() == 3)
        return 0.5 * cross_product_3d(face->vertex(1) - face->vertex(0),
                                      face->vertex(2) - face->vertex(0))
                       .norm();
      else
        return 0.5 * cross_product_3d(face->vertex(3) - face->vertex(0),
                                      face->vertex(2) - face->vertex(1))
                       .norm();
    }



    template <int dim>
    std::map<types::boundary_id, SideSize<dim>>
    side_sizes(const Triangulation<dim> &mesh)
    {
      std::map<types::boundary_id, SideSize<dim>> result;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            result[face->boundary_id()].add({1, face_size<dim>(face)});
      return result;
    }



    /** The first of some positions, and how many more there are. */
    template <int dim>
    std::string
    some_of(const std::vector<Point<dim>> &positions)
    {
      constexpr unsigned int most = 8;
      std::string            text;
      for (unsigned int i = 0; i < positions.size() && i < most; ++i)
        text += (i > 0 ? ", " : "") + position_text(positions[i]);
      if (positions.size() > most)
        text +=
          " and " + std::to_string(positions.size() - most) + " more places";
      return text;
    }
  } // namespace



  template <int dim>
  void
  report_meshes(const SceneParameters<dim> &scene, std::ostream &out)
  {
    const std::vector<CoarseBody<dim>> bodies = scene.coarse_bodies();
    std::vector<std::map<types::boundary_id, SideSize<dim>>> sizes;
    out << "Bodies, before any refinement:\n";
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Triangulation<dim> &mesh   = *bodies[b].cells;
        double                    volume = 0.;
        for (const auto &cell : mesh.active_cell_iterators())
          volume += cell->measure();
        out << "  " << scene.bodies[b].name << ": " << mesh.n_active_cells()
            << ' ' << name_of_cells(mesh) << " of "
            << GridTools::minimal_cell_diameter(mesh) << " to "
            << GridTools::maximal_cell_diameter(mesh) << " m, "
            << mesh.n_vertices() << " vertices, " << volume
            << (dim == 2 ? " m^2" : " m^3");
        if (const unsigned int n = n_parts(mesh); n > 1)
          out << ", in " << n << " parts that share no face";
        out << '\n';
        sizes.push_back(side_sizes(mesh));
        for (const auto &side : bodies[b].side_names)
          if (!scene.topology.is_at_fault(b, side.first))
            out << "    side " << side.second << " (" << number(side.first)
                << "): " << sizes[b][side.first].text() << '\n';
      }

    out << "Faults:" << (scene.faults.empty() ? " none" : "") << '\n';
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const Fault &fault = scene.topology.faults()[f];
        out << "  " << fault.name << '\n';
        for (const unsigned int side : {0, 1})
          for (const BodySide &part : fault.sides[side])
            out << "    " << (side == 0 ? "first" : "second") << " side on "
                << scene.bodies[part.body].name << " (" << number(part.side)
                << "): " << sizes[part.body][part.side].text() << '\n';
        if (scene.mesh == nullptr)
          continue;
        std::vector<Point<dim>> tips;
        for (const auto &tip : scene.mesh->tips)
          if (tip.fault == f)
            tips.push_back(tip.position);
        if (!tips.empty())
          out << "    ends inside a body at " << some_of(tips) << '\n';
      }
    if (scene.mesh == nullptr)
      return;

    for (const auto &junction : scene.mesh->junctions)
      {
        std::vector<std::string> names;
        for (const unsigned int f : junction.faults)
          names.push_back(scene.faults[f].name);
        out << "Junction of " << junction.n_parts << " parts at "
            << position_text(junction.position) << ": " << join_names(names)
            << '\n';
      }
    if (scene.mesh->n_closed_faces > 0)
      out << scene.mesh->n_closed_faces
          << " faces in the groups of faults cannot slip, since all their "
             "vertices are at the edge of the fault.\n";
  }



  template <int dim>
  void
  write_mesh_pictures(const SceneParameters<dim> &scene,
                      const std::string          &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    const std::vector<CoarseBody<dim>> bodies = scene.coarse_bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const std::string name =
          directory + "/mesh_" + scene.bodies[b].name + ".vtk";
        std::ofstream file(name);
        if (!file)
          throw InputError("The file '" + name + "' cannot be written.");
        GridOut grid_out;
        grid_out.set_flags(GridOutFlags::Vtk(/*output_cells=*/true,
                                             /*output_faces=*/true,
                                             /*output_edges=*/false,
                                             /*output_only_relevant=*/true));
        Triangulation<dim> numbered;
        numbered.copy_triangulation(*bodies[b].cells);
        for (const auto &face : numbered.active_face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(number(face->boundary_id()));
        grid_out.write_vtk(numbered, file);
        if (!file)
          throw InputError("The file '" + name + "' cannot be written.");
      }
  }



  template void
  report_meshes(const SceneParameters<2> &, std::ostream &);
  template void
  report_meshes(const SceneParameters<3> &, std::ostream &);
  template void
  write_mesh_pictures(const SceneParameters<2> &, const std::string &);
  template void
  write_mesh_pictures(const SceneParameters<3> &, const std::string &);
} // namespace StickSlip
