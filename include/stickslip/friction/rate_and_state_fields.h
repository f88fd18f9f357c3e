// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_rate_and_state_fields_h
#define stickslip_friction_rate_and_state_fields_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/friction/rate_and_state.h>
#include <stickslip/parameters/spatial_field.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * RateAndStateParameters that may vary along a fault.
   */
  struct RateAndStateFields
  {
    SpatialField a = RateAndStateParameters().a;
    SpatialField b = RateAndStateParameters().b;
    SpatialField reference_friction =
      RateAndStateParameters().reference_friction;
    SpatialField reference_slip_rate =
      RateAndStateParameters().reference_slip_rate;
    SpatialField characteristic_slip =
      RateAndStateParameters().characteristic_slip;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);

    /** The parameters at some points. Throws InputError, see
     * SpatialField::function(). */
    template <int dim>
    std::vector<RateAndStateParameters>
    values(const std::vector<Point<dim>> &points,
           const std::string             &section) const;

    /** The parameters, where all are numbers. */
    RateAndStateParameters
    constants() const;
  };
} // namespace StickSlip

#endif
