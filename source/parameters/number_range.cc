// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/expression_units.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/units.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace StickSlip
{
  namespace
  {
    /** True if a unit is one of these dimensions. Numbers without dimensions
     * may be written as m/m. */
    bool
    has_dimensions_of(const Quantity &quantity, const std::string &unit)
    {
      if (quantity.unit.empty())
        return true;
      const std::optional<Unit> wanted = read_unit(unit);
      return quantity.dimensions ==
             (wanted ? wanted->dimensions : Dimensions());
    }
  } // namespace



  bool
  NumberRange::contains(const double x) const
  {
    return std::isfinite(x) && (lower_included ? x >= lower : x > lower) &&
           (upper_included ? x <= upper : x < upper);
  }



  bool
  NumberRange::match(const std::string &text) const
  {
    const std::vector<std::string> items = Utilities::split_string_list(text);
    return (n_numbers == 0 || items.size() == n_numbers) &&
           std::all_of(items.begin(),
                       items.end(),
                       [this](const std::string &item) {
                         const auto quantity = read_quantity(item);
                         return quantity &&
                                (!only_whole || (quantity->unit.empty() &&
                                                 !quantity->is_decimal)) &&
                                has_dimensions_of(*quantity, unit) &&
                                contains(quantity->value);
                       });
  }



  std::string
  NumberRange::mistaken_unit(const std::string &text) const
  {
    const std::string fitting = fitting_units();
    for (const std::string &item : Utilities::split_string_list(text))
      {
        const std::string word = unknown_unit(item);
        if (!word.empty())
          return "'" + word + "' is no unit" + fitting;
        const auto quantity = read_quantity(item);
        if (quantity && !has_dimensions_of(*quantity, unit))
          return "'" + quantity->unit + "' is a unit of something else" +
                 fitting;
      }
    return "";
  }



  std::string
  NumberRange::mistaken_unit_in_expression(const std::string &expression) const
  {
    std::optional<Dimensions> wanted;
    if (!unit_is_open)
      {
        const std::optional<Unit> of_range = read_unit(unit);
        wanted = of_range ? of_range->dimensions : Dimensions();
      }
    return mistake_in_units(expression, wanted, fitting_units());
  }



  std::string
  NumberRange::fitting_units() const
  {
    return unit.empty() || !read_unit(unit) ?
             "; there is no unit here" :
             "; units that fit are " + units_like(unit);
  }



  std::string
  NumberRange::description(const OutputStyle) const
  {
    std::string words = n_numbers == 0 ? "a list of" :
                        n_numbers == 1 ? "a" :
                                         Utilities::int_to_string(n_numbers);
    words += only_whole ? " whole number" : " number";
    if (n_numbers != 1)
      words += "s";

    std::string joint = " ";
    if (std::isfinite(lower))
      {
        words += joint + (lower_included ? ">= " : "> ") + shortest_form(lower);
        joint = " and ";
      }
    if (std::isfinite(upper))
      words += joint + (upper_included ? "<= " : "< ") + shortest_form(upper);
    if (!unit.empty())
      words += before_unit + unit + after_unit;
    if (n_numbers != 1)
      words += ", separated by commas";
    return words;
  }



  std::vector<double>
  NumberRange::values(const std::string &text)
  {
    std::vector<double> numbers;
    for (const std::string &item : Utilities::split_string_list(text))
      {
        const auto quantity = read_quantity(item);
        numbers.push_back(quantity ? quantity->value :
                                     std::numeric_limits<double>::quiet_NaN());
      }
    return numbers;
  }



  std::string
  shortest_form(const double x)
  {
    std::array<char, 40> buffer;
    const auto           result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return std::string(buffer.data(), result.ptr);
  }
} // namespace StickSlip
