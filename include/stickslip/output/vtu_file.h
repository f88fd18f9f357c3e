// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_vtu_file_h
#define stickslip_output_vtu_file_h

#include <deal.II/base/point.h>

#include <cstdint>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Points and cells of an unstructured grid.
   */
  class VtuGrid
  {
  public:
    /** Add a point; its number is that of those before. */
    template <int dim>
    void
    add_point(const Point<dim> &position);

    /** Add a cell of @p dimension dimensions by the numbers of its points in
     * the order of VTK: around a face, and around the opposite one. */
    void
    add_cell(const unsigned int               dimension,
             const std::vector<std::int64_t> &points);

    std::size_t
    n_points() const
    {
      return coordinates.size() / 3;
    }

    std::size_t
    n_cells() const
    {
      return shapes.size();
    }

  private:
    friend class VtuFile;

    /** Three for each point. */
    std::vector<double>       coordinates;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> shapes;
  };

  /**
   * The text of a VTU file: arrays of bytes compressed by zlib, in base64.
   * @p Number, float or double, is what points and fields are written in. An
   * array's unit is its information key UNITS_LABEL.
   */
  class VtuFile
  {
  public:
    enum class Precision
    {
      simple,
      full
    };

    /** @p time in s, as the field TIME. */
    VtuFile(const VtuGrid &grid, const double time, const Precision precision);

    /** Add an array of strings that belongs to the whole file. */
    void
    add_names(const std::string &title, const std::vector<std::string> &names);

    /** Add the values of all points or of all cells, those of one after the
     * other; no unit: @p units is empty. */
    void
    add_point_data(const std::string         &name,
                   const unsigned int         n_components,
                   const std::vector<double> &values,
                   const std::string         &units);
    void
    add_cell_data(const std::string         &name,
                  const unsigned int         n_components,
                  const std::vector<double> &values,
                  const std::string         &units);

    std::string
    text() const;

    /** The text of a PVTU file that joins pieces with the arrays of this file,
     * by their names. */
    std::string
    text_that_joins(const std::vector<std::string> &pieces) const;

  private:
    /** The line of a PVTU file for an array. */
    std::string
    declaration(const std::string &name, const unsigned int n_components) const;

    std::string
    array(const std::string         &name,
          const unsigned int         n_components,
          const std::vector<double> &values,
          const std::string         &units = "") const;

    const VtuGrid  &grid;
    const Precision precision;
    std::string     field_data, point_data, cell_data;
    std::string     point_declarations, cell_declarations;
  };
} // namespace StickSlip

#endif
