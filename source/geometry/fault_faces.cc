// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/face_area.h>
#include <stickslip/geometry/fault_faces.h>
#include <stickslip/geometry/node_welding.h>
#include <stickslip/parameters/name_list.h>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** The place of a name among others; none if it is not there. */
    unsigned int
    place_of(const std::string &name, const std::vector<std::string> &names)
    {
      const auto place = std::find(names.begin(), names.end(), name);
      return place == names.end() ? none : place - names.begin();
    }
  } // namespace



  template <int dim>
  FaultFaces<dim>::FaultFaces(const GroupedCells<dim>      &mesh,
                              const CellFaces<dim>         &faces,
                              const std::vector<MeshFault> &faults)
    : mesh(mesh)
    , cell_faces(faces)
    , fault_of_group(mesh.group_names.size(), none)
    , group_of_face(faces.faces().size(), none)
    , of_group(mesh.group_names.size())
  {
    find_groups_of_faults(faults);
    name_faces();
    check_side_groups(faults);
    check_faces();
  }



  template <int dim>
  unsigned int
  FaultFaces<dim>::body(const std::string &name) const
  {
    return place_of(name, mesh.body_names);
  }



  template <int dim>
  unsigned int
  FaultFaces<dim>::group(const std::string &name) const
  {
    return place_of(name, mesh.group_names);
  }



  template <int dim>
  std::vector<bool>
  FaultFaces<dim>::is_cut() const
  {
    std::vector<bool> result(group_of_face.size());
    for (unsigned int f = 0; f < result.size(); ++f)
      result[f] =
        group_of_face[f] != none && fault_of_group[group_of_face[f]] != none;
    return result;
  }



  template <int dim>
  void
  FaultFaces<dim>::find_groups_of_faults(const std::vector<MeshFault> &faults)
  {
    for (unsigned int f = 0; f < faults.size(); ++f)
      {
        const MeshFault &fault = faults[f];
        fault_names.push_back(fault.name);
        group_of_fault.push_back(none);
        for (const auto &side : fault.between)
          for (const MeshFault::Side &part : side)
            if (body(part.body) == none)
              throw InputError("The fault '" + fault.name +
                               "' is said to be at the body '" + part.body +
                               "', but the bodies are " +
                               join_names(mesh.body_names) + ".");
        if (fault.between[0].empty() != fault.between[1].empty())
          throw InputError("The fault '" + fault.name +
                           "' is said to have bodies on one side only.");
        for (const auto &side : fault.between)
          for (const MeshFault::Side &part : side)
            if (part.group.empty() == fault.has_side_groups())
              throw InputError("The fault '" + fault.name +
                               "' is said to be between bodies, and between "
                               "groups at their boundaries; it can be one of "
                               "these only.");
        if (fault.has_side_groups())
          {
            find_side_groups(fault, f);
            continue;
          }
        const unsigned int g = group(fault.group);
        if (g == none)
          throw InputError("The fault '" + fault.name +
                           "' has no faces: no mesh file has a physical group "
                           "of " +
                           (dim == 2 ? "lines" : "surfaces") + " named '" +
                           fault.group + "', but there are " +
                           join_names(mesh.group_names) + ".");
        if (fault_of_group[g] != none)
          throw InputError("The faults '" + fault_names[fault_of_group[g]] +
                           "' and '" + fault.name + "' are the same group '" +
                           fault.group + "' of the mesh.");
        fault_of_group[g] = f;
        group_of_fault[f] = g;
      }
  }



  template <int dim>
  void
  FaultFaces<dim>::find_side_groups(const MeshFault   &fault,
                                    const unsigned int number)
  {
    for (const auto &side : fault.between)
      for (const MeshFault::Side &part : side)
        {
          const unsigned int g = group(part.group);
          if (g == none)
            throw InputError("The fault '" + fault.name + "' is at the side '" +
                             part.body + " " + part.group +
                             "', but no mesh file has a group '" + part.group +
                             "'; there are " + join_names(mesh.group_names) +
                             ".");
          fault_of_side[{body(part.body), g}] = number;
        }
  }



  template <int dim>
  void
  FaultFaces<dim>::name_faces()
  {
    for (const auto &face : mesh.faces)
      {
        const unsigned int f = cell_faces.find(
          CellFaces<dim>::make_key(face.vertices, face.n_vertices));
        if (f == none)
          throw InputError("The group '" + mesh.group_names[face.group] +
                           "' has a face at " +
                           position_text(mesh.centre(face)) +
                           " that is not the face of any cell.");
        if (group_of_face[f] == face.group)
          continue;
        if (group_of_face[f] != none)
          throw InputError("A face at " + position_text(mesh.centre(face)) +
                           " is in both groups '" +
                           mesh.group_names[group_of_face[f]] + "' and '" +
                           mesh.group_names[face.group] + "'.");
        group_of_face[f] = face.group;
      }
    for (unsigned int f = 0; f < group_of_face.size(); ++f)
      if (group_of_face[f] != none)
        of_group[group_of_face[f]].push_back(f);
  }



  template <int dim>
  std::string
  FaultFaces<dim>::place(const unsigned int face) const
  {
    return position_text(face_centre<dim>(mesh, cell_faces.faces()[face]));
  }



  template <int dim>
  std::string
  FaultFaces<dim>::in_group(const unsigned int face) const
  {
    return group_of_face[face] == none ?
             "in no group" :
             "in the group '" + mesh.group_names[group_of_face[face]] + "'";
  }



  template <int dim>
  void
  FaultFaces<dim>::check_side_groups(const std::vector<MeshFault> &faults) const
  {
    for (const MeshFault &fault : faults)
      if (fault.has_side_groups())
        for (const auto &side : fault.between)
          for (const MeshFault::Side &part : side)
            {
              bool any = false;
              for (const unsigned int f : of_group[group(part.group)])
                {
                  const auto &face = cell_faces.faces()[f];
                  if (mesh.cells[face.cells[0]].body == body(part.body))
                    any = true;
                  if (face.is_interior())
                    throw InputError(
                      "The side '" + part.body + " " + part.group +
                      "' of the fault '" + fault.name + "' has a face at " +
                      place(f) +
                      " with cells on both sides, whose nodes are joined: name "
                      "the group as that of the fault, not of a side.");
                }
              if (!any)
                throw InputError("The body '" + part.body +
                                 "' has no faces in the group '" + part.group +
                                 "', which is to be a side of the fault '" +
                                 fault.name + "'.");
            }
  }



  template <int dim>
  void
  FaultFaces<dim>::check_faces() const
  {
    for (unsigned int f = 0; f < group_of_face.size(); ++f)
      if (cell_faces.faces()[f].is_interior())
        check_interior_face(f);
    // Faces that are open by mistake explain unnamed boundaries.
    check_touching_faces();
    for (unsigned int f = 0; f < group_of_face.size(); ++f)
      if (!cell_faces.faces()[f].is_interior())
        check_boundary_face(f);
  }



  template <int dim>
  void
  FaultFaces<dim>::check_interior_face(const unsigned int f) const
  {
    const unsigned int g = group_of_face[f];
    if (g != none && fault_of_group[g] != none)
      return;
    const auto        &cells  = cell_faces.faces()[f].cells;
    const std::string &first  = mesh.body_names[mesh.cells[cells[0]].body];
    const std::string &second = mesh.body_names[mesh.cells[cells[1]].body];
    if (first != second)
      throw InputError("The bodies '" + first + "' and '" + second +
                       "' are joined at " + place(f) + " in a face " +
                       in_group(f) + ", but no fault is there.");
    if (g != none)
      throw InputError("The group '" + mesh.group_names[g] +
                       "' has a face at " + place(f) + " inside the body '" +
                       first +
                       "', but is no fault, and sides are at boundaries.");
  }



  template <int dim>
  void
  FaultFaces<dim>::check_boundary_face(const unsigned int f) const
  {
    const unsigned int g = group_of_face[f];
    const std::string &body =
      mesh.body_names[mesh.cells[cell_faces.faces()[f].cells[0]].body];
    if (g == none)
      {
        unsigned int n = 0;
        for (unsigned int other = f; other < group_of_face.size(); ++other)
          n += group_of_face[other] == none &&
               !cell_faces.faces()[other].is_interior();
        throw InputError("The body '" + body + "' has a boundary face at " +
                         place(f) + " in no group, one of " +
                         std::to_string(n) +
                         "; all boundary faces must be in named groups.");
      }
    if (fault_of_group[g] != none)
      throw InputError("The fault '" + fault_names[fault_of_group[g]] +
                       "', the group '" + mesh.group_names[g] +
                       "', has a face at " + place(f) +
                       " with a cell of the body '" + body +
                       "' on one side and none on the other.");
  }



  template <int dim>
  void
  FaultFaces<dim>::check_touching_faces() const
  {
    for (const auto &pair : touching_faces(mesh, cell_faces))
      {
        const auto fault_at = [&](const unsigned int f) {
          const auto side =
            fault_of_side.find({mesh.cells[cell_faces.faces()[f].cells[0]].body,
                                group_of_face[f]});
          return side == fault_of_side.end() ? none : side->second;
        };
        if (fault_at(pair.first) != none &&
            fault_at(pair.first) == fault_at(pair.second))
          continue;
        const auto body_at = [&](const unsigned int f) {
          return mesh
            .body_names[mesh.cells[cell_faces.faces()[f].cells[0]].body];
        };
        throw InputError(
          "A face of the body '" + body_at(pair.first) + "' " +
          in_group(pair.first) + " and one of the body '" +
          body_at(pair.second) + "' " + in_group(pair.second) +
          " are both at " + place(pair.first) +
          ", but do not share their nodes, and no fault is there.");
      }
  }



  template class FaultFaces<2>;
  template class FaultFaces<3>;
} // namespace StickSlip
