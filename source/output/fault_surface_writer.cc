// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/fault_field_values.h>
#include <stickslip/output/fault_surface_writer.h>
#include <stickslip/output/vtu_file.h>

#include <map>

namespace StickSlip
{
  namespace
  {
    /** Nodes and faces of a fault as a grid. */
    template <int dim>
    struct FaultGrid
    {
      VtuGrid grid;

      /** The node of each point. */
      std::vector<unsigned int> nodes;

      FaultGrid(const FaultSurface<dim>       &surface,
                const std::vector<Point<dim>> &positions)
      {
        AssertDimension(positions.size(), surface.points.size());
        for (unsigned int k = 0; k < positions.size(); ++k)
          add_point(k, positions[k]);
        // Points beyond the ends, by node and periods.
        using Wrap = std::array<int, dim - 1>;
        std::map<std::pair<unsigned int, Wrap>, unsigned int> beyond;
        for (unsigned int f = 0; f < surface.faces.size(); ++f)
          {
            const auto corners = surface.face_vertices(positions, f);
            std::vector<std::int64_t> points;
            for (const unsigned int v : vertices_around(surface, f))
              {
                unsigned int point = surface.faces[f][v];
                if (!surface.wraps.empty() && surface.wraps[f][v] != Wrap())
                  {
                    const auto entry =
                      beyond.emplace(std::make_pair(point, surface.wraps[f][v]),
                                     nodes.size());
                    if (entry.second)
                      add_point(point, corners[v]);
                    point = entry.first->second;
                  }
                points.push_back(point);
              }
            grid.add_cell(dim - 1, points);
          }
      }

      /** The numbers of the points, from those of the nodes. */
      std::vector<double>
      at_points(const std::vector<double> &values,
                const unsigned int         n_components) const
      {
        std::vector<double> result;
        for (const unsigned int node : nodes)
          for (unsigned int c = 0; c < n_components; ++c)
            result.push_back(values[std::size_t(node) * n_components + c]);
        return result;
      }

    private:
      void
      add_point(const unsigned int node, const Point<dim> &position)
      {
        nodes.push_back(node);
        grid.add_point(position);
      }
    };



    /** Vectors in space along one of the axes of all nodes. */
    template <int dim>
    std::vector<double>
    axis_of_nodes(const std::vector<Tensor<2, dim>> &axes,
                  const unsigned int                 number)
    {
      std::vector<double> result;
      for (const Tensor<2, dim> &of_node : axes)
        for (unsigned int d = 0; d < 3; ++d)
          result.push_back(d < dim ? of_node[d][number] : 0.);
      return result;
    }



    template <int dim>
    std::string
    text_of_fault(const double                   time,
                  const FaultLayout<dim>        &shape,
                  const FaultSnapshot<dim>      &fault,
                  const std::vector<FaultField> &fields)
    {
      const FaultGrid<dim> points(shape.surface, fault.positions);
      VtuFile              file(points.grid, time, VtuFile::Precision::full);
      file.add_names("fault_name", {fault.name});
      const auto add_axis = [&](const std::string &name,
                                const unsigned int number) {
        file.add_point_data(
          name, 3, points.at_points(axis_of_nodes(shape.axes, number), 3), "");
      };
      for (unsigned int i = 0; i + 1 < dim; ++i)
        add_axis(dim == 2 ? "tangent" : "tangent_" + std::to_string(i + 1), i);
      add_axis("normal", dim - 1);
      for (const auto &[field, name] : fault_field_names())
        if (field == FaultField::contact_weight ||
            (field != FaultField::position && has_field(fields, field) &&
             has_values(fault, field)))
          {
            const FaultFieldValues of_nodes = field_values(fault, field);
            file.add_point_data(name,
                                of_nodes.n_components,
                                points.at_points(of_nodes.values,
                                                 of_nodes.n_components),
                                of_nodes.units);
          }
      return file.text();
    }
  } // namespace



  template <int dim>
  std::string
  write_fault_surface(const std::string             &directory,
                      const unsigned int             number,
                      const double                   time,
                      const FaultLayout<dim>        &shape,
                      const FaultSnapshot<dim>      &fault,
                      const std::vector<FaultField> &fields)
  {
    const std::string name = "fault_" + fault.name + "_" +
                             Utilities::int_to_string(number, 5) + ".vtu";
    write_file_atomically(directory + "/" + name,
                          text_of_fault(time, shape, fault, fields));
    return name;
  }



  template decltype(write_fault_surface<2>) write_fault_surface<2>;
  template decltype(write_fault_surface<3>) write_fault_surface<3>;
} // namespace StickSlip
