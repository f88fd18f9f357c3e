// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_fault_faces_h
#define stickslip_geometry_fault_faces_h

#include <stickslip/geometry/cell_faces.h>
#include <stickslip/geometry/mesh_fault.h>

#include <map>
#include <utility>

namespace StickSlip
{
  /**
   * The groups of the faces of cells, and which of these are faults.
   */
  template <int dim>
  class FaultFaces
  {
  public:
    /** Throws InputError if anything does not fit together, as described for
     * cut_at_faults(). */
    FaultFaces(const GroupedCells<dim>      &mesh,
               const CellFaces<dim>         &faces,
               const std::vector<MeshFault> &faults);

    /** The number of a body, which must be there. */
    unsigned int
    body(const std::string &name) const;

    /** The number of a group, which must be there. */
    unsigned int
    group(const std::string &name) const;

    /** The faces of a group in rising order. */
    const std::vector<unsigned int> &
    faces_of_group(const unsigned int group) const
    {
      return of_group[group];
    }

    /** The faces of a fault that is one group. */
    const std::vector<unsigned int> &
    faces_of_fault(const unsigned int fault) const
    {
      return of_group[group_of_fault[fault]];
    }

    /** For each face whether it is on a fault that is one group. */
    std::vector<bool>
    is_cut() const;

  private:
    void
    find_groups_of_faults(const std::vector<MeshFault> &faults);

    void
    find_side_groups(const MeshFault &fault, const unsigned int number);

    void
    name_faces();

    void
    check_faces() const;

    void
    check_interior_face(const unsigned int face) const;

    void
    check_boundary_face(const unsigned int face) const;

    void
    check_touching_faces() const;

    void
    check_side_groups(const std::vector<MeshFault> &faults) const;

    std::string
    place(const unsigned int face) const;

    std::string
    in_group(const unsigned int face) const;

    const GroupedCells<dim> &mesh;
    const CellFaces<dim>    &cell_faces;

    /** The fault of each group that is one, and the group of each face. */
    std::vector<unsigned int>              fault_of_group;
    std::vector<std::string>               fault_names;
    std::vector<unsigned int>              group_of_fault;
    std::vector<unsigned int>              group_of_face;
    std::vector<std::vector<unsigned int>> of_group;

    /** The fault on whose side a group of a body's boundary is, by body and
     * group. */
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> fault_of_side;
  };
} // namespace StickSlip

#endif
