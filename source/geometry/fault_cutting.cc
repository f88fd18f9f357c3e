// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/cell_overlap.h>
#include <stickslip/geometry/fault_cutting.h>
#include <stickslip/geometry/fault_faces.h>
#include <stickslip/geometry/fault_orientation.h>
#include <stickslip/geometry/node_welding.h>
#include <stickslip/geometry/touching_sides.h>
#include <stickslip/geometry/vertex_fans.h>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** Boundary indicators of the sides of each body. */
    class SideNumbers
    {
    public:
      /** A group, or one side of a fault. */
      using Key = std::pair<unsigned int, unsigned int>;

      explicit SideNumbers(const unsigned int n_bodies)
        : numbers(n_bodies)
        , names(n_bodies)
      {}

      /** The indicator of a side; a new one if it has none. */
      types::boundary_id
      number(const unsigned int body, const Key &key, const std::string &name)
      {
        const auto [place, is_new] =
          numbers[body].emplace(key, numbers[body].size());
        if (is_new)
          names[body][place->second] = name;
        return place->second;
      }

      const std::map<types::boundary_id, std::string> &
      side_names(const unsigned int body) const
      {
        return names[body];
      }

    private:
      std::vector<std::map<Key, types::boundary_id>>         numbers;
      std::vector<std::map<types::boundary_id, std::string>> names;
    };



    template <int dim>
    class FaultCutter
    {
    public:
      FaultCutter(const GroupedCells<dim>      &mesh,
                  const std::vector<MeshFault> &faults)
        : mesh(mesh)
        , fault_list(faults)
        , cell_faces(mesh)
        , named(mesh, cell_faces, faults)
        , fans(mesh, cell_faces, named.is_cut())
        , sides(mesh.body_names.size())
        , topology_of_faults(faults.size())
      {}

      CutMesh<dim>
      cut()
      {
        check_overlap(mesh, cell_faces);
        make_bodies();
        for (unsigned int f = 0; f < fault_list.size(); ++f)
          {
            topology_of_faults[f].name         = fault_list[f].name;
            topology_of_faults[f].may_be_apart = fault_list[f].may_be_apart;
          }
        name_sides();
        for (unsigned int f = 0; f < fault_list.size(); ++f)
          if (fault_list[f].has_side_groups())
            use_named_sides(f);
          else
            open(f);
        find_junctions();
        for (unsigned int b = 0; b < result.bodies.size(); ++b)
          result.bodies[b].side_names = sides.side_names(b);
        result.topology = FaultTopology(mesh.body_names, topology_of_faults);
        for (unsigned int f = 0; f < fault_list.size(); ++f)
          if (fault_list[f].has_side_groups())
            check_sides_touch(result.bodies,
                              mesh.body_names,
                              topology_of_faults[f]);
        return std::move(result);
      }

    private:
      /** Vertices and cells of all bodies. */
      void
      make_bodies()
      {
        // By body, vertices in the order of the files, fan after fan.
        vertex_numbers.resize(mesh.body_names.size());
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          for (unsigned int v = 0; v < mesh.cells[c].n_vertices; ++v)
            {
              const unsigned int vertex = mesh.cells[c].vertices[v];
              vertex_numbers[mesh.cells[c].body].emplace(
                std::make_pair(vertex, fans.fan(c, vertex)), 0);
            }
        result.bodies.resize(mesh.body_names.size());
        for (unsigned int b = 0; b < vertex_numbers.size(); ++b)
          for (auto &[vertex, number] : vertex_numbers[b])
            {
              number = result.bodies[b].vertices.size();
              result.bodies[b].vertices.push_back(mesh.points[vertex.first]);
            }
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          {
            CellData<dim> cell(mesh.cells[c].n_vertices);
            for (unsigned int v = 0; v < mesh.cells[c].n_vertices; ++v)
              cell.vertices[v] = cut_vertex(c, mesh.cells[c].vertices[v]);
            cell.material_id = 0;
            result.bodies[mesh.cells[c].body].cells.push_back(cell);
          }
      }

      /** The number in its body of the copy of a vertex that a cell has. */
      unsigned int
      cut_vertex(const unsigned int cell, const unsigned int vertex) const
      {
        return vertex_numbers[mesh.cells[cell].body].at(
          {vertex, fans.fan(cell, vertex)});
      }

      /** Add a boundary face as one of the cells has it. */
      void
      add_boundary_face(const unsigned int       face,
                        const unsigned int       cell,
                        const types::boundary_id side)
      {
        const auto        &ring = cell_faces.faces()[face].ring;
        const unsigned int n    = cell_faces.faces()[face].n_vertices;
        CellData<dim - 1>  data(n);
        for (unsigned int v = 0; v < n; ++v)
          data.vertices[v] = cut_vertex(cell, ring[v]);
        if (n == 4)
          std::swap(data.vertices[2], data.vertices[3]);
        data.boundary_id      = side;
        SubCellData &boundary = result.bodies[mesh.cells[cell].body].boundary;
        if constexpr (dim == 2)
          boundary.boundary_lines.push_back(data);
        else
          boundary.boundary_quads.push_back(data);
      }

      /** Faces in groups at the boundaries of the uncut bodies. */
      void
      name_sides()
      {
        for (unsigned int g = 0; g < mesh.group_names.size(); ++g)
          for (const unsigned int f : named.faces_of_group(g))
            {
              const auto &face = cell_faces.faces()[f];
              if (face.is_interior())
                continue;
              add_boundary_face(f,
                                face.cells[0],
                                group_side(mesh.cells[face.cells[0]].body, g));
            }
      }

      void
      use_named_sides(const unsigned int fault)
      {
        for (const unsigned int side : {0, 1})
          for (const MeshFault::Side &part : fault_list[fault].between[side])
            {
              const unsigned int body = named.body(part.body);
              topology_of_faults[fault].sides[side].push_back(
                {body, group_side(body, named.group(part.group))});
            }
      }

      /** Both sides of a fault that is cut open. */
      void
      open(const unsigned int fault)
      {
        const std::vector<unsigned int> &faces = named.faces_of_fault(fault);
        const std::vector<bool>          first_cell_is_first =
          orient_fault(mesh, cell_faces, faces, fault_list[fault]);

        std::array<std::set<unsigned int>, 2> bodies;
        std::map<unsigned int, bool>          is_tip;
        bool                                  is_open = false;
        for (unsigned int i = 0; i < faces.size(); ++i)
          {
            const auto &face      = cell_faces.faces()[faces[i]];
            bool        is_closed = true;
            for (unsigned int v = 0; v < face.n_vertices; ++v)
              {
                const unsigned int vertex = face.ring[v];
                const bool is_shared      = fans.fan(face.cells[0], vertex) ==
                                       fans.fan(face.cells[1], vertex);
                bool &so_far = is_tip.emplace(vertex, true).first->second;
                so_far       = so_far && is_shared;
                is_closed    = is_closed && is_shared;
              }
            if (is_closed)
              {
                ++result.n_closed_faces;
                continue;
              }
            is_open = true;
            for (const unsigned int side : {0, 1})
              {
                const unsigned int cell =
                  face.cells[(side == 0) == first_cell_is_first[i] ? 0 : 1];
                const unsigned int body = mesh.cells[cell].body;
                bodies[side].insert(body);
                add_boundary_face(faces[i],
                                  cell,
                                  fault_side(body, fault, side));
              }
          }
        if (!is_open)
          throw InputError("The fault '" + fault_list[fault].name +
                           "' cannot slip: all vertices of its faces lie on "
                           "its edge, and the mesh must be finer there.");

        for (const unsigned int side : {0, 1})
          for (const unsigned int body : bodies[side])
            topology_of_faults[fault].sides[side].push_back(
              {body, fault_side(body, fault, side)});
        for (const auto &[vertex, is] : is_tip)
          if (is)
            result.tips.push_back({fault, mesh.points[vertex]});
      }

      types::boundary_id
      group_side(const unsigned int body, const unsigned int group)
      {
        return sides.number(body, {none, group}, mesh.group_names[group]);
      }

      types::boundary_id
      fault_side(const unsigned int body,
                 const unsigned int fault,
                 const unsigned int side)
      {
        return sides.number(body,
                            {fault, side},
                            fault_list[fault].name +
                              (side == 0 ? " first" : " second"));
      }

      void
      find_junctions()
      {
        std::map<unsigned int, std::set<unsigned int>> faults_at;
        for (unsigned int f = 0; f < fault_list.size(); ++f)
          if (!fault_list[f].has_side_groups())
            for (const unsigned int face : named.faces_of_fault(f))
              for (unsigned int v = 0; v < cell_faces.faces()[face].n_vertices;
                   ++v)
                faults_at[cell_faces.faces()[face].ring[v]].insert(f);
        for (const auto &[vertex, faults] : faults_at)
          if (fans.n_fans(vertex) > 2)
            result.junctions.push_back(
              {fans.n_fans(vertex), mesh.points[vertex], faults});
      }

      const GroupedCells<dim>      &mesh;
      const std::vector<MeshFault> &fault_list;
      const CellFaces<dim>          cell_faces;
      const FaultFaces<dim>         named;
      const VertexFans<dim>         fans;
      SideNumbers                   sides;
      std::vector<Fault>            topology_of_faults;
      CutMesh<dim>                  result;

      /** For each body the numbers of its vertices by original vertex and fan.
       */
      std::vector<std::map<std::pair<unsigned int, unsigned int>, unsigned int>>
        vertex_numbers;
    };
  } // namespace



  template <int dim>
  CutMesh<dim>
  cut_at_faults(GroupedCells<dim> mesh, const std::vector<MeshFault> &faults)
  {
    std::vector<bool> is_welded(mesh.group_names.size(), false);
    for (const MeshFault &fault : faults)
      for (unsigned int g = 0; g < is_welded.size(); ++g)
        if (!fault.has_side_groups() && mesh.group_names[g] == fault.group)
          is_welded[g] = true;
    weld_nodes(mesh, is_welded);
    return FaultCutter<dim>(mesh, faults).cut();
  }



  template struct CutMesh<2>;
  template struct CutMesh<3>;
  template CutMesh<2>
  cut_at_faults(GroupedCells<2>, const std::vector<MeshFault> &);
  template CutMesh<3>
  cut_at_faults(GroupedCells<3>, const std::vector<MeshFault> &);
} // namespace StickSlip
