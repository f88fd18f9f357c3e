// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/output/vtu_file.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** VTK's name of a type of numbers. */
    template <typename Number>
    constexpr const char *vtk_name = nullptr;
    template <>
    constexpr const char *vtk_name<float> = "Float32";
    template <>
    constexpr const char *vtk_name<double> = "Float64";
    template <>
    constexpr const char *vtk_name<std::int64_t> = "Int64";
    template <>
    constexpr const char *vtk_name<std::uint8_t> = "UInt8";



    /** VTK's number of a shape of cells. */
    std::uint8_t
    vtk_shape(const unsigned int dimension, const std::size_t n_vertices)
    {
      switch (dimension * 10 + n_vertices)
        {
          case 12:
            return 3;
          case 23:
            return 5;
          case 24:
            return 9;
          case 34:
            return 10;
          case 38:
            return 12;
        }
      AssertThrow(false, ExcMessage("Cells of this shape are not written."));
      return 0;
    }



    std::string
    base64(const unsigned char *bytes, const std::size_t size)
    {
      return Utilities::encode_base64({bytes, bytes + size});
    }



    /** The number of blocks, their size, that of the last one if it is smaller,
     * and what each takes compressed; then the blocks. A tenth larger than by
     * the best compression, in a small part of its time. */
    std::string
    compressed(const unsigned char *bytes, const std::size_t size)
    {
      constexpr std::size_t block_size  = 1 << 22;
      const std::size_t     n_blocks    = (size + block_size - 1) / block_size;
      std::vector<std::uint32_t> header = {
        static_cast<std::uint32_t>(n_blocks),
        static_cast<std::uint32_t>(block_size),
        static_cast<std::uint32_t>(size % block_size)};
      std::vector<unsigned char> content;
      for (std::size_t begin = 0; begin < size; begin += block_size)
        {
          const uLong of_block = std::min(block_size, size - begin);
          uLongf      n_bytes  = compressBound(of_block);
          const auto  end      = content.size();
          content.resize(end + n_bytes);
          const int status = compress2(content.data() + end,
                                       &n_bytes,
                                       bytes + begin,
                                       of_block,
                                       Z_BEST_SPEED);
          AssertThrow(status == Z_OK, ExcInternalError());
          content.resize(end + n_bytes);
          header.push_back(n_bytes);
        }
      return base64(reinterpret_cast<const unsigned char *>(header.data()),
                    header.size() * sizeof(std::uint32_t)) +
             base64(content.data(), content.size());
    }



    template <typename Number>
    std::string
    array_of(const std::string         &name,
             const unsigned int         n_components,
             const std::vector<Number> &values,
             const std::string         &units = "")
    {
      std::string text = "        <DataArray type=\"";
      text += vtk_name<Number>;
      text += "\" Name=\"" + name + "\" NumberOfComponents=\"" +
              std::to_string(n_components) +
              "\" format=\"binary\">\n          " +
              compressed(reinterpret_cast<const unsigned char *>(values.data()),
                         values.size() * sizeof(Number)) +
              '\n';
      if (!units.empty())
        text += "          <InformationKey name=\"UNITS_LABEL\" "
                "location=\"vtkDataArray\">" +
                units + "</InformationKey>\n";
      return text + "        </DataArray>\n";
    }
  } // namespace



  template <int dim>
  void
  VtuGrid::add_point(const Point<dim> &position)
  {
    for (unsigned int d = 0; d < 3; ++d)
      coordinates.push_back(d < dim ? position[d] : 0.);
  }



  void
  VtuGrid::add_cell(const unsigned int               dimension,
                    const std::vector<std::int64_t> &points)
  {
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    offsets.push_back(connectivity.size());
    shapes.push_back(vtk_shape(dimension, points.size()));
  }



  VtuFile::VtuFile(const VtuGrid  &grid,
                   const double    time,
                   const Precision precision)
    : grid(grid)
    , precision(precision)
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "      <DataArray type=\"Float64\" Name=\"TIME\" "
            "NumberOfTuples=\"1\" format=\"ascii\">"
         << time << "</DataArray>\n";
    field_data = text.str();
  }



  void
  VtuFile::add_names(const std::string              &title,
                     const std::vector<std::string> &names)
  {
    field_data += "      <DataArray type=\"String\" Name=\"" + title +
                  "\" NumberOfTuples=\"" + std::to_string(names.size()) +
                  "\" format=\"ascii\">";
    // Strings are the numbers of their characters, with a zero at the end.
    for (const std::string &name : names)
      {
        for (const char c : name)
          field_data += std::to_string(static_cast<unsigned char>(c)) + ' ';
        field_data += "0 ";
      }
    field_data += "</DataArray>\n";
  }



  void
  VtuFile::add_point_data(const std::string         &name,
                          const unsigned int         n_components,
                          const std::vector<double> &values,
                          const std::string         &units)
  {
    AssertDimension(values.size(), grid.n_points() * n_components);
    point_data += array(name, n_components, values, units);
    point_declarations += declaration(name, n_components);
  }



  void
  VtuFile::add_cell_data(const std::string         &name,
                         const unsigned int         n_components,
                         const std::vector<double> &values,
                         const std::string         &units)
  {
    AssertDimension(values.size(), grid.n_cells() * n_components);
    cell_data += array(name, n_components, values, units);
    cell_declarations += declaration(name, n_components);
  }



  std::string
  VtuFile::array(const std::string         &name,
                 const unsigned int         n_components,
                 const std::vector<double> &values,
                 const std::string         &units) const
  {
    if (precision == Precision::full)
      return array_of(name, n_components, values, units);
    return array_of(name,
                    n_components,
                    std::vector<float>(values.begin(), values.end()),
                    units);
  }



  std::string
  VtuFile::declaration(const std::string &name,
                       const unsigned int n_components) const
  {
    return std::string("      <PDataArray type=\"") +
           (precision == Precision::full ? vtk_name<double> :
                                           vtk_name<float>)+"\" Name=\"" +
           name + "\" NumberOfComponents=\"" + std::to_string(n_components) +
           "\"/>\n";
  }



  std::string
  VtuFile::text_that_joins(const std::vector<std::string> &pieces) const
  {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\" header_type=\"UInt32\" "
                       "compressor=\"vtkZLibDataCompressor\">\n"
                       "  <PUnstructuredGrid GhostLevel=\"0\">\n"
                       "    <FieldData>\n" +
                       field_data +
                       "    </FieldData>\n"
                       "    <PPoints>\n" +
                       declaration("Points", 3) +
                       "    </PPoints>\n"
                       "    <PPointData>\n" +
                       point_declarations +
                       "    </PPointData>\n"
                       "    <PCellData>\n" +
                       cell_declarations + "    </PCellData>\n";
    for (const std::string &piece : pieces)
      text += "    <Piece Source=\"" + piece + "\"/>\n";
    return text + "  </PUnstructuredGrid>\n"
                  "</VTKFile>\n";
  }



  std::string
  VtuFile::text() const
  {
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt32\" "
           "compressor=\"vtkZLibDataCompressor\">\n"
           "  <UnstructuredGrid>\n"
           "    <FieldData>\n" +
           field_data +
           "    </FieldData>\n"
           "    <Piece NumberOfPoints=\"" +
           std::to_string(grid.n_points()) + "\" NumberOfCells=\"" +
           std::to_string(grid.n_cells()) +
           "\">\n"
           "      <Points>\n" +
           array("Points", 3, grid.coordinates) +
           "      </Points>\n"
           "      <Cells>\n" +
           array_of("connectivity", 1, grid.connectivity) +
           array_of("offsets", 1, grid.offsets) +
           array_of("types", 1, grid.shapes) +
           "      </Cells>\n"
           "      <PointData>\n" +
           point_data +
           "      </PointData>\n"
           "      <CellData>\n" +
           cell_data +
           "      </CellData>\n"
           "    </Piece>\n"
           "  </UnstructuredGrid>\n"
           "</VTKFile>\n";
  }



  template void
  VtuGrid::add_point(const Point<2> &);
  template void
  VtuGrid::add_point(const Point<3> &);
} // namespace StickSlip
