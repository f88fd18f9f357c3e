// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/number_range.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace StickSlip
{
  namespace
  {
    // The number that makes up all of the text, or NaN. Hexadecimal numbers
    // and words such as inf are no input a user means.
    double
    to_number(const std::string &text)
    {
      if (text.empty() ||
          text.find_first_not_of("0123456789+-.eE") != std::string::npos)
        return std::numeric_limits<double>::quiet_NaN();
      char        *end = nullptr;
      const double x   = std::strtod(text.c_str(), &end);
      if (end != text.c_str() + text.size())
        return std::numeric_limits<double>::quiet_NaN();
      return x;
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
    return items.size() == n_numbers &&
           std::all_of(items.begin(),
                       items.end(),
                       [this](const std::string &item) {
                         return (!only_whole || item.find_first_of(".eE") ==
                                                  std::string::npos) &&
                                contains(to_number(item));
                       });
  }



  std::string
  NumberRange::description(const OutputStyle) const
  {
    std::string words =
      n_numbers == 1 ? "a" : Utilities::int_to_string(n_numbers);
    words += only_whole ? " whole number" : " number";
    if (n_numbers > 1)
      words += "s";

    std::string joint = " ";
    if (std::isfinite(lower))
      {
        words += joint + (lower_included ? ">= " : "> ") + shortest_form(lower);
        joint = " and ";
      }
    if (std::isfinite(upper))
      words += joint + (upper_included ? "<= " : "< ") + shortest_form(upper);
    if (n_numbers > 1)
      words += ", separated by commas";
    return words;
  }



  std::vector<double>
  NumberRange::values(const std::string &text)
  {
    std::vector<double> numbers;
    for (const std::string &item : Utilities::split_string_list(text))
      numbers.push_back(to_number(item));
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
