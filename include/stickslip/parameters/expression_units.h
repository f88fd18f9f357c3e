// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_expression_units_h
#define stickslip_parameters_expression_units_h

#include <stickslip/parameters/units.h>

#include <optional>
#include <string>

namespace StickSlip
{
  /**
   * A mistake in the units of an expression that an Expression can read, in
   * words; empty if there is none. Mistakes are quantities of different
   * dimensions that are added, compared, or take each other's place
   * ("if(x < 5 km, 30 GPa, 2 km)"), units in the argument of a function like
   * sin, and results of other dimensions than @p wanted, if that is given, to
   * which @p fitting is added.
   *
   * Numbers without a unit may be of any: a product with one may be anything,
   * since "26e3 * (5 km - y)" may well be a pressure. Coordinates are in m and
   * the time is in s where they are added to quantities or compared with them.
   */
  std::string
  mistake_in_units(const std::string               &expression,
                   const std::optional<Dimensions> &wanted,
                   const std::string               &fitting);
} // namespace StickSlip

#endif
