// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_stress_field_h
#define stickslip_parameters_stress_field_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <stickslip/parameters/spatial_field.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A symmetric stress, Pa, tension positive, whose components are numbers,
   * expressions in the coordinates x, y (z), in m, or tables; or none. In two
   * dimensions
   * these are sxx, syy, sxy, in three sxx, syy, szz, sxy, syz, sxz.
   */
  class StressField
  {
  public:
    /** In the description of the pattern of such entries, before the names of
     * the components. */
    static constexpr auto each_component =
      "a number, an expression in x, y (z), or table FILE, separated by "
      "commas: ";

    /** Declare an entry of the current subsection of @p prm for a scene in
     * @p dim dimensions. The field must stay where it is for as long as the
     * handler is used. */
    void
    add_parameters(ParameterHandler  &prm,
                   const std::string &entry,
                   const unsigned int dim,
                   const std::string &documentation);

    /** True if there is a stress. */
    bool
    is_given() const
    {
      return !components.empty();
    }

    /** The stress at some points. Throws InputError with the entry in the
     * subsection @p section if an expression or a table cannot be used or is no
     * finite number at a point. */
    template <int dim>
    std::vector<SymmetricTensor<2, dim>>
    values(const std::vector<Point<dim>> &points,
           const std::string             &section) const;

    /** The text of a stress whose tables have absolute paths, as
     * SpatialField::with_absolute_path() says for each component. */
    static std::string
    with_absolute_paths(const std::string &text, const std::string &folder);

  private:
    std::string               text;
    std::vector<SpatialField> components;
  };
} // namespace StickSlip

#endif
