// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_units_h
#define stickslip_parameters_units_h

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Exponents of m, kg, s and degrees in a unit.
   */
  using Dimensions = std::array<int, 4>;

  /**
   * A product of powers of named units, such as "mm/yr" or "Pa s". Its value in
   * SI units is 10^decimals times numerator over denominator; angles are in
   * degrees. The three are kept apart so that "4 km" is exactly what "4e3" is.
   */
  struct Unit
  {
    Dimensions dimensions  = {};
    int        decimals    = 0;
    double     numerator   = 1.;
    double     denominator = 1.;

    /** The value in SI units. */
    double
    factor() const;
  };

  /**
   * The unit that a text stands for: names out of a table, with whole powers,
   * joined by blanks, '*' or '/' ("kg/m^3"). Nothing if it is none. A year is
   * 365 days.
   */
  std::optional<Unit>
  read_unit(const std::string &text);

  /**
   * A number as users write it, with a unit or without.
   */
  struct Quantity
  {
    /** In SI units, and in degrees; without a unit the number itself. */
    double value = 0.;

    /** The unit as it was written; empty if there is none. */
    std::string unit;

    Dimensions dimensions = {};

    /** True if the number was written with an exponent or a decimal point. */
    bool is_decimal = false;
  };

  /**
   * The quantity that makes up all of a text: a decimal number, and a unit or
   * none. Nothing for anything else, hexadecimal numbers, inf and nan included.
   * The number may have overflown to infinity.
   */
  std::optional<Quantity>
  read_quantity(const std::string &text);

  /**
   * The word after a number, with blanks between both or none, that is no unit
   * and is likely meant to be one. Empty if the text is anything else.
   */
  std::string
  unknown_unit(const std::string &text);

  /**
   * Names of units of the same dimensions as a given one, that one first, for
   * messages: "Pa, kPa, MPa, GPa or bar".
   */
  std::string
  units_like(const std::string &unit);

  /**
   * Names without blanks and powers and their values in SI units, for
   * expressions.
   */
  const std::vector<std::pair<std::string, double>> &
  units_in_expressions();
} // namespace StickSlip

#endif
