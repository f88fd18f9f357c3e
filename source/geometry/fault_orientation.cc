// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/face_area.h>
#include <stickslip/geometry/fault_orientation.h>

#include <cmath>
#include <map>
#include <set>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    using Face = typename CellFaces<dim>::Face;



    /** The ends of a line, or the sides of a face in space; with true where the
     * ring leads out of a line or along a side from its lower number. */
    template <int dim>
    std::vector<std::pair<std::array<unsigned int, dim - 1>, bool>>
    rim(const Face<dim> &face)
    {
      std::vector<std::pair<std::array<unsigned int, dim - 1>, bool>> result;
      for (unsigned int v = 0; v < face.n_vertices; ++v)
        if constexpr (dim == 2)
          result.push_back({{{face.ring[v]}}, v == 1});
        else
          {
            const unsigned int a = face.ring[v];
            const unsigned int b = face.ring[(v + 1) % face.n_vertices];
            result.push_back({{{std::min(a, b), std::max(a, b)}}, a < b});
          }
      return result;
    }



    /** One connected part of a fault at a time. */
    template <int dim>
    class Orientation
    {
    public:
      Orientation(const GroupedCells<dim>         &mesh,
                  const CellFaces<dim>            &faces,
                  const std::vector<unsigned int> &fault_faces,
                  const MeshFault                 &fault)
        : mesh(mesh)
        , faces(faces)
        , fault_faces(fault_faces)
        , fault(fault)
        , is_known(fault_faces.size(), false)
        , is_turned(fault_faces.size(), false)
        , first_cell_is_first(fault_faces.size(), false)
      {
        for (unsigned int i = 0; i < fault_faces.size(); ++i)
          for (const auto &part : rim<dim>(face(i)))
            at_rim[part.first].emplace_back(i, part.second);
      }

      std::vector<bool>
      find()
      {
        for (unsigned int i = 0; i < fault_faces.size(); ++i)
          if (!is_known[i])
            {
              const std::vector<unsigned int> part = connected_part(i);
              const bool turn_all = !points_to_second_side(part);
              for (const unsigned int j : part)
                first_cell_is_first[j] =
                  normal_leaves_first_cell(j) != turn_all;
            }
        return first_cell_is_first;
      }

    private:
      const Face<dim> &
      face(const unsigned int i) const
      {
        return faces.faces()[fault_faces[i]];
      }

      std::string
      place(const unsigned int i) const
      {
        return "The fault '" + fault.name + "' at " +
               position_text(face_centre<dim>(mesh, face(i)));
      }

      /** The faces that are connected to the face i, all turned alike. */
      std::vector<unsigned int>
      connected_part(const unsigned int i)
      {
        std::vector<unsigned int> part = {i};
        is_known[i]                    = true;
        for (unsigned int k = 0; k < part.size(); ++k)
          for (const auto &[at, leads_out] : rim<dim>(face(part[k])))
            {
              const auto &meeting = at_rim.at(at);
              if (meeting.size() > 2)
                throw InputError(place(part[k]) +
                                 " branches; each branch must be a group and "
                                 "a fault of its own.");
              for (const auto &[other, other_leads_out] : meeting)
                {
                  if (other == part[k])
                    continue;
                  const bool turned =
                    is_turned[part[k]] != (leads_out == other_leads_out);
                  if (!is_known[other])
                    {
                      is_known[other]  = true;
                      is_turned[other] = turned;
                      part.push_back(other);
                    }
                  else if (is_turned[other] != turned)
                    throw InputError(place(other) +
                                     " has one side only, like a Moebius "
                                     "strip.");
                }
            }
        return part;
      }

      /** The common normal of the part at a face. */
      Tensor<1, dim>
      normal_area(const unsigned int i) const
      {
        const Tensor<1, dim> result = face_area<dim>(mesh, face(i));
        return is_turned[i] ? -result : result;
      }

      bool
      normal_leaves_first_cell(const unsigned int i) const
      {
        const auto &first_cell = mesh.cells[face(i).cells[0]];
        return normal_area(i) *
                 (face_centre<dim>(mesh, face(i)) - mesh.centre(first_cell)) >
               0.;
      }

      /** The bodies behind (0) and before (1) the common normal. */
      std::array<unsigned int, 2>
      bodies_at(const unsigned int i) const
      {
        const auto        &cells  = face(i).cells;
        const unsigned int before = normal_leaves_first_cell(i) ? 1 : 0;
        return {
          {mesh.cells[cells[1 - before]].body, mesh.cells[cells[before]].body}};
      }

      /** True if the common normal of a part is that of the fault. */
      bool
      points_to_second_side(const std::vector<unsigned int> &part) const
      {
        if (!fault.between[0].empty())
          {
            bool may_point = true, may_be_turned = true;
            for (const unsigned int i : part)
              {
                const auto [behind, before] = bodies_at(i);
                const bool as_is  = is_on(0, behind) && is_on(1, before);
                const bool turned = is_on(0, before) && is_on(1, behind);
                may_point         = may_point && as_is;
                may_be_turned     = may_be_turned && turned;
                if (!may_point && !may_be_turned)
                  throw InputError(
                    place(i) + " is between the bodies '" +
                    mesh.body_names[behind] + "' and '" +
                    mesh.body_names[before] +
                    (as_is || turned ?
                       "', the other way round than elsewhere." :
                       "', which are not those that it is said to be "
                       "between."));
              }
            if (may_point != may_be_turned)
              return may_point;
            return points_upwards(part);
          }

        std::array<unsigned int, 2> lowest = {
          {CellFaces<dim>::none, CellFaces<dim>::none}};
        for (const unsigned int i : part)
          for (const unsigned int side : {0, 1})
            lowest[side] = std::min(lowest[side], bodies_at(i)[side]);
        return lowest[0] == lowest[1] ? points_upwards(part) :
                                        lowest[0] < lowest[1];
      }

      bool
      is_on(const unsigned int side, const unsigned int body) const
      {
        for (const MeshFault::Side &part : fault.between[side])
          if (part.body == mesh.body_names[body])
            return true;
        return false;
      }

      /** True if the last component of the mean normal that is not zero is
       * positive. */
      bool
      points_upwards(const std::vector<unsigned int> &part) const
      {
        Tensor<1, dim> sum;
        for (const unsigned int i : part)
          sum += normal_area(i);
        for (int d = dim - 1; d >= 0; --d)
          if (std::abs(sum[d]) > 1e-6 * sum.norm())
            return sum[d] > 0.;
        return true;
      }

      const GroupedCells<dim>         &mesh;
      const CellFaces<dim>            &faces;
      const std::vector<unsigned int> &fault_faces;
      const MeshFault                 &fault;

      /** The faces at each part of the rims of all. */
      std::map<std::array<unsigned int, dim - 1>,
               std::vector<std::pair<unsigned int, bool>>>
        at_rim;

      std::vector<bool> is_known;
      std::vector<bool> is_turned;
      std::vector<bool> first_cell_is_first;
    };
  } // namespace



  template <int dim>
  std::vector<bool>
  orient_fault(const GroupedCells<dim>         &mesh,
               const CellFaces<dim>            &faces,
               const std::vector<unsigned int> &fault_faces,
               const MeshFault                 &fault)
  {
    return Orientation<dim>(mesh, faces, fault_faces, fault).find();
  }



  template std::vector<bool>
  orient_fault(const GroupedCells<2> &,
               const CellFaces<2> &,
               const std::vector<unsigned int> &,
               const MeshFault &);
  template std::vector<bool>
  orient_fault(const GroupedCells<3> &,
               const CellFaces<3> &,
               const std::vector<unsigned int> &,
               const MeshFault &);
} // namespace StickSlip
