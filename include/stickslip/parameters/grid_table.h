// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_grid_table_h
#define stickslip_parameters_grid_table_h

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A function of position given by its values on a grid, which a text file
   * holds: comments begin with #; the first line that is more than that names
   * the coordinates, one, two or three of x, y and z; each further line has a
   * number for each of these and the value there, in any order. There must
   * be one value at every combination of the coordinates that occur, and at
   * least two of each.
   *
   * Numbers are in SI units where the line with the names has no other ones in
   * parentheses: "x (km) y (km) value (GPa)".
   *
   * In between, the function is linear along each coordinate; beyond the ends
   * it goes on with the values there; it does not depend on coordinates that
   * are not named.
   */
  class GridTable
  {
  public:
    /**
     * Read a file. Throws InputError naming file and line.
     */
    explicit GridTable(const std::string &file_name);

    /**
     * The axes of the coordinates in the order of the file: 0 for x, 1 for y, 2
     * for z.
     */
    const std::vector<unsigned int> &
    axes() const
    {
      return column_axes;
    }

    /** The unit in which the file has the values, empty if it names none. */
    const std::string &
    unit() const
    {
      return unit_of_values;
    }

    /**
     * The value at a point, in SI units. All axes() must be less than @p dim.
     */
    template <int dim>
    double
    value(const Point<dim> &point) const;

    /**
     * True if a point is not beyond the ends of the grid. All axes() must be
     * less than @p dim.
     */
    template <int dim>
    bool
    covers(const Point<dim> &point) const;

  private:
    std::vector<unsigned int> column_axes;
    std::string               unit_of_values;

    /** The ends of the grid along the coordinates in the order of the file. */
    std::vector<std::pair<double, double>> ends;

    /** The function of the coordinates in the order of the file. */
    std::function<double(const std::array<double, 3> &)> interpolation;
  };
} // namespace StickSlip

#endif
