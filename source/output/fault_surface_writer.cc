// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/fault_field_values.h>
#include <stickslip/output/fault_surface_writer.h>

#include <cstdint>
#include <limits>
#include <map>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** VTK's numbers of the shapes of cells, by the number of their vertices.
     */
    constexpr std::array<std::uint8_t, 5> vtk_shapes = {{0, 0, 3, 5, 9}};



    const std::string &
    vtk_name(const double)
    {
      static const std::string name = "Float64";
      return name;
    }

    const std::string &
    vtk_name(const std::int64_t)
    {
      static const std::string name = "Int64";
      return name;
    }

    const std::string &
    vtk_name(const std::uint8_t)
    {
      static const std::string name = "UInt8";
      return name;
    }



    /** One array, its bytes in text behind their number. */
    template <typename Number>
    void
    write_array(std::ostream              &out,
                const std::string         &name,
                const unsigned int         n_components,
                const std::vector<Number> &values,
                const std::string         &units = "")
    {
      const std::uint64_t        n_bytes = values.size() * sizeof(Number);
      std::vector<unsigned char> bytes(sizeof(n_bytes) + n_bytes);
      std::copy_n(reinterpret_cast<const unsigned char *>(&n_bytes),
                  sizeof(n_bytes),
                  bytes.begin());
      std::copy_n(reinterpret_cast<const unsigned char *>(values.data()),
                  n_bytes,
                  bytes.begin() + sizeof(n_bytes));
      out << "        <DataArray type=\"" << vtk_name(Number()) << "\" Name=\""
          << name << "\" NumberOfComponents=\"" << n_components
          << "\" format=\"binary\">\n          "
          << Utilities::encode_base64(bytes) << '\n';
      if (!units.empty())
        out << "          <InformationKey name=\"UNITS_LABEL\" "
               "location=\"vtkDataArray\">"
            << units << "</InformationKey>\n";
      out << "        </DataArray>\n";
    }



    /** Points and cells of a file. */
    template <int dim>
    struct Grid
    {
      /** The node of each point. */
      std::vector<unsigned int> nodes;
      /** Three coordinates each. */
      std::vector<double>       points;
      std::vector<std::int64_t> connectivity, offsets;
      std::vector<std::uint8_t> shapes;

      Grid(const FaultSurface<dim>       &surface,
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
                connectivity.push_back(point);
              }
            offsets.push_back(connectivity.size());
            shapes.push_back(vtk_shapes[surface.n_vertices_of(f)]);
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
        for (unsigned int d = 0; d < 3; ++d)
          points.push_back(d < dim ? position[d] : 0.);
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
      const Grid<dim>    grid(shape.surface, fault.positions);
      std::ostringstream out;
      out.precision(std::numeric_limits<double>::max_digits10);
      out << "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
             "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
             "  <UnstructuredGrid>\n"
             "    <FieldData>\n"
             "      <DataArray type=\"Float64\" Name=\"TIME\" "
             "NumberOfTuples=\"1\" format=\"ascii\">"
          << time
          << "</DataArray>\n"
             "    </FieldData>\n"
             "    <Piece NumberOfPoints=\""
          << grid.nodes.size() << "\" NumberOfCells=\"" << grid.shapes.size()
          << "\">\n"
             "      <Points>\n";
      write_array(out, "Points", 3, grid.points);
      out << "      </Points>\n"
             "      <Cells>\n";
      write_array(out, "connectivity", 1, grid.connectivity);
      write_array(out, "offsets", 1, grid.offsets);
      write_array(out, "types", 1, grid.shapes);
      out << "      </Cells>\n"
             "      <PointData>\n";
      const auto write_axis = [&](const std::string &name,
                                  const unsigned int number) {
        write_array(out,
                    name,
                    3,
                    grid.at_points(axis_of_nodes(shape.axes, number), 3));
      };
      for (unsigned int i = 0; i + 1 < dim; ++i)
        write_axis(dim == 2 ? "tangent" : "tangent_" + std::to_string(i + 1),
                   i);
      write_axis("normal", dim - 1);
      for (const auto &[field, name] : fault_field_names())
        if (field == FaultField::contact_weight ||
            (field != FaultField::position && has_field(fields, field) &&
             has_values(fault, field)))
          {
            const FaultFieldValues of_nodes = field_values(fault, field);
            write_array(out,
                        name,
                        of_nodes.n_components,
                        grid.at_points(of_nodes.values, of_nodes.n_components),
                        of_nodes.units);
          }
      out << "      </PointData>\n"
             "    </Piece>\n"
             "  </UnstructuredGrid>\n"
             "</VTKFile>\n";
      return out.str();
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
