// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/tensor.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/grouped_cells.h>
#include <stickslip/parameters/name_list.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** Elements of a dimension in words. */
    const char *
    name_of_elements(const unsigned int dim)
    {
      const char *const names[] = {"points", "lines", "surfaces", "volumes"};
      return names[dim];
    }



    /** The place of a name in a list, or its length. */
    unsigned int
    place_of(const std::string &name, const std::vector<std::string> &names)
    {
      return std::find(names.begin(), names.end(), name) - names.begin();
    }



    /** Smallest and largest volume that the cell has at its vertices, as
     * multiples of its longest side to the power of the dimension. */
    template <int dim>
    std::pair<double, double>
    volumes_at_vertices(const std::vector<Point<dim>>          &points,
                        const typename GroupedCells<dim>::Cell &cell)
    {
      const auto point = [&](const unsigned int v) {
        return points[cell.vertices[v]];
      };
      const bool          is_simplex = cell.n_vertices == dim + 1;
      const unsigned int  n_corners  = is_simplex ? 1 : cell.n_vertices;
      std::vector<double> volumes;
      double              longest = 0.;
      for (unsigned int v = 0; v < n_corners; ++v)
        {
          Tensor<2, dim> sides;
          for (unsigned int d = 0; d < dim; ++d)
            {
              // The neighbour along each axis, in the axis' direction.
              const unsigned int other = is_simplex ? d + 1 : v ^ (1u << d);
              const double       sign =
                (!is_simplex && ((v >> d) & 1u) != 0) ? -1. : 1.;
              sides[d] = sign * (point(other) - point(v));
              longest  = std::max(longest, sides[d].norm());
            }
          volumes.push_back(determinant(sides));
        }
      const auto [least, largest] =
        std::minmax_element(volumes.begin(), volumes.end());
      const double scale = std::pow(longest, dim);
      return {*least / scale, *largest / scale};
    }



    /** Exchange vertices such that the volume changes its sign. */
    template <int dim>
    void
    turn_around(typename GroupedCells<dim>::Cell &cell)
    {
      auto &v = cell.vertices;
      if (cell.n_vertices == dim + 1)
        std::swap(v[dim - 1], v[dim]);
      else
        for (unsigned int i = 0; i < cell.n_vertices; i += 4)
          std::swap(v[i + 1], v[i + 2]);
    }



    template <int dim>
    class Collector
    {
    public:
      explicit Collector(GroupedCells<dim> &result)
        : result(result)
        , n_cells_of_body(result.body_names.size(), 0)
        , vertices_of_body(result.body_names.size(), 0)
      {}

      void
      add(const GmshFile &file)
      {
        check_dimension(file);
        check_groups(file);
        const unsigned int first = result.points.size();
        for (const Point<3> &node : file.nodes)
          {
            result.points.emplace_back();
            for (unsigned int d = 0; d < dim; ++d)
              result.points.back()[d] = node[d];
          }
        add_cells(file, first);
        add_faces(file, first);
      }

      void
      check_bodies() const
      {
        for (unsigned int b = 0; b < n_cells_of_body.size(); ++b)
          if (n_cells_of_body[b] == 0)
            throw InputError("The body '" + result.body_names[b] +
                             "' has no cells: no mesh file has a physical "
                             "group of " +
                             name_of_elements(dim) + " of that name.");
      }

    private:
      static void
      check_dimension(const GmshFile &file)
      {
        for (unsigned int d = dim + 1; d < 4; ++d)
          if (!file.elements[d].empty())
            throw InputError(
              "The mesh file '" + file.name + "' has " + name_of_elements(d) +
              " in " + file.describe(file.elements[d][0].group) +
              ", but the scene has " + std::to_string(dim) + " dimensions.");
        if (file.elements[dim].empty())
          throw InputError("The mesh file '" + file.name + "' has no " +
                           name_of_elements(dim) +
                           ": there is nothing to compute with in " +
                           std::to_string(dim) + " dimensions.");
        if (dim == 2)
          for (const auto &cell : file.elements[dim])
            for (unsigned int v = 0; v < cell.n_nodes; ++v)
              if (file.nodes[cell.nodes[v]][2] != 0.)
                throw InputError("The mesh file '" + file.name +
                                 "' has a surface in " +
                                 file.describe(cell.group) + " at " +
                                 position_text(file.nodes[cell.nodes[v]]) +
                                 ", but in two dimensions z must be 0.");
      }

      /** Groups of cells and faces must be of use. */
      void
      check_groups(const GmshFile &file) const
      {
        std::vector<bool> has_elements(file.groups.size(), false);
        for (const unsigned int d : {dim - 1, dim})
          for (const auto &element : file.elements[d])
            if (element.group != GmshFile::no_group)
              has_elements[element.group] = true;
        for (unsigned int g = 0; g < file.groups.size(); ++g)
          {
            const GmshFile::Group &group = file.groups[g];
            if (group.dim + 1 < dim)
              continue;
            if (group.name.empty())
              throw InputError(
                "The mesh file '" + file.name + "' has a physical group of " +
                name_of_elements(group.dim) + " without a name, number " +
                std::to_string(group.tag) +
                ": bodies, sides and faults are found by names.");
            if (!has_elements[g])
              throw InputError("The mesh file '" + file.name + "' has no " +
                               name_of_elements(group.dim) + " in the group '" +
                               group.name + "'.");
            if (group.dim == dim && place_of(group.name, result.body_names) ==
                                      result.body_names.size())
              throw InputError("The mesh file '" + file.name +
                               "' has a group of " + name_of_elements(dim) +
                               " '" + group.name +
                               "', which is none of the bodies: " +
                               join_names(result.body_names) + ".");
          }
      }

      void
      add_cells(const GmshFile &file, const unsigned int first)
      {
        for (const auto &element : file.elements[dim])
          {
            typename GroupedCells<dim>::Cell cell = {};
            cell.n_vertices                       = element.n_nodes;
            for (unsigned int v = 0; v < cell.n_vertices; ++v)
              cell.vertices[v] = first + element.nodes[v];
            if (element.group == GmshFile::no_group)
              throw InputError("The mesh file '" + file.name +
                               "' has a cell at " +
                               position_text(result.centre(cell)) +
                               " that is in no physical group, and so in no "
                               "body.");
            const std::string &group = file.groups[element.group].name;
            cell.body                = place_of(group, result.body_names);

            unsigned int &n_vertices = vertices_of_body[cell.body];
            if (n_vertices != 0 && n_vertices != cell.n_vertices)
              throw InputError("The body '" + group + "' has both " +
                               (dim == 2 ? "triangles and quadrilaterals" :
                                           "tetrahedra and hexahedra") +
                               "; all cells of a body must be of one kind.");
            n_vertices = cell.n_vertices;
            ++n_cells_of_body[cell.body];

            auto volumes = volumes_at_vertices<dim>(result.points, cell);
            if (volumes.second < 0.)
              {
                turn_around<dim>(cell);
                volumes = volumes_at_vertices<dim>(result.points, cell);
              }
            // Also refuses what is not a number, for cells without extent.
            if (!(volumes.first > 1e-8))
              throw InputError(
                "The mesh file '" + file.name + "' has a cell at " +
                position_text(result.centre(cell)) + " in the group '" + group +
                "' that is " +
                (volumes.first < -1e-8 ? "inverted" : "degenerate") + ".");
            result.cells.push_back(cell);
          }
      }

      void
      add_faces(const GmshFile &file, const unsigned int first)
      {
        for (const auto &element : file.elements[dim - 1])
          {
            // Programs may write all faces, those without meaning too.
            if (element.group == GmshFile::no_group)
              continue;
            typename GroupedCells<dim>::Face face = {};
            face.n_vertices                       = element.n_nodes;
            for (unsigned int v = 0; v < face.n_vertices; ++v)
              face.vertices[v] = first + element.nodes[v];
            const std::string &group = file.groups[element.group].name;
            face.group               = place_of(group, result.group_names);
            if (face.group == result.group_names.size())
              result.group_names.push_back(group);
            result.faces.push_back(face);
          }
      }

      GroupedCells<dim>        &result;
      std::vector<std::size_t>  n_cells_of_body;
      std::vector<unsigned int> vertices_of_body;
    };
  } // namespace



  template <int dim>
  GroupedCells<dim>::GroupedCells(const std::vector<GmshFile>    &files,
                                  const std::vector<std::string> &body_names)
    : body_names(body_names)
  {
    Collector<dim> collector(*this);
    for (const GmshFile &file : files)
      collector.add(file);
    collector.check_bodies();
  }



  template <int dim>
  std::string
  position_text(const Point<dim> &point)
  {
    std::ostringstream text;
    text << '(';
    for (unsigned int d = 0; d < dim; ++d)
      text << (d > 0 ? ", " : "") << point[d];
    text << ')';
    return text.str();
  }



  template struct GroupedCells<2>;
  template struct GroupedCells<3>;
  template std::string
  position_text(const Point<2> &);
  template std::string
  position_text(const Point<3> &);
} // namespace StickSlip
