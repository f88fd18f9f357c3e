// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_spatial_field_h
#define stickslip_parameters_spatial_field_h

#include <stickslip/parameters/grid_table.h>
#include <stickslip/parameters/number_range.h>

#include <memory>

namespace StickSlip
{
  /**
   * A parameter that may vary in space: a number, with a unit or without; a
   * muParser expression in the coordinates x, y (z), in m; or `table FILE`, the
   * interpolation of a GridTable. A number costs no more than a number.
   */
  class SpatialField
  {
  public:
    SpatialField(const double value = 0.)
      : number(value)
    {}

    /** Become a number; entry and range stay. */
    SpatialField &
    operator=(const double value);

    /**
     * Become what the text of a parameter file says. Throws InputError if it
     * names a table that cannot be read or has a wrong unit; whether an
     * expression can be read shows in function().
     */
    void
    set(const std::string &text);

    /** Text that gives the same field. */
    std::string
    text() const;

    /**
     * Say by which entry of its subsection the field is set, and which values
     * it may have. Any finite ones if this is never called.
     */
    void
    describe(const std::string &new_entry, const NumberRange &new_range)
    {
      entry = new_entry;
      range = new_range;
    }

    /** Let the text be empty from now on, which it is: nothing is given then,
     * and the field is a number all the same. */
    void
    make_optional(const double value_if_empty);

    bool
    is_optional() const
    {
      return optional;
    }

    /** False if the text is empty. */
    bool
    is_given() const
    {
      return given;
    }

    bool
    is_constant() const
    {
      return !table && expression.empty();
    }

    /** True if the table has this axis, or the expression names its
     * coordinate. */
    bool
    depends_on(const unsigned int axis) const;

    /** The number; only where the field is constant. */
    double
    constant() const;

    /**
     * The field as a function of the position (m), for many evaluations.
     *
     * Throws InputError where the expression cannot be read or the table
     * depends on a coordinate that this dimension does not have. The function
     * that is returned throws InputError where the value is out of range; the
     * message names the entry in the subsection @p section, the position and
     * the value.
     */
    template <int dim>
    std::function<double(const Point<dim> &)>
    function(const std::string &section) const;

    /** Values at some points; throws as function() and what it returns. */
    template <int dim>
    std::vector<double>
    values(const std::vector<Point<dim>> &points,
           const std::string             &section) const;

    /**
     * True if the field is a table, and all of some points are beyond its ends,
     * where it goes on with the values there.
     */
    template <int dim>
    bool
    is_table_elsewhere(const std::vector<Point<dim>> &points) const;

    /**
     * The text of a field where the file of a table has an absolute path: a
     * relative one begins in @p folder, or in the current one if that is
     * empty. Any other text is returned as it is.
     */
    static std::string
    with_absolute_path(const std::string &text, const std::string &folder);

  private:
    double                           number = 0;
    std::string                      expression;
    std::string                      table_file;
    std::shared_ptr<const GridTable> table;

    std::string entry;
    NumberRange range;

    bool   given          = true;
    bool   optional       = false;
    double value_if_empty = 0;
  };
} // namespace StickSlip

#endif
