// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/point_list.h>

#include <sstream>

namespace StickSlip
{
  std::vector<std::string>
  split_quantities(const std::string &text)
  {
    std::istringstream       stream(text);
    std::vector<std::string> list;
    for (std::string word; stream >> word;)
      if (list.empty() ||
          std::string("+-.0123456789").find(word[0]) != std::string::npos)
        list.push_back(word);
      else
        list.back() += " " + word;
    return list;
  }



  namespace
  {
    const NumberRange &
    length()
    {
      static const NumberRange range = NumberRange().in("m");
      return range;
    }
  } // namespace



  bool
  PointList::match(const std::string &text) const
  {
    const std::vector<std::string> items = Utilities::split_string_list(text);
    for (const std::string &item : items)
      {
        const std::vector<std::string> numbers = split_quantities(item);
        if (numbers.size() != 2 || !length().match(numbers[0]) ||
            !length().match(numbers[1]))
          return false;
      }
    return n_points == 0 || items.empty() || items.size() == n_points;
  }



  std::string
  PointList::description(const OutputStyle) const
  {
    return (n_points == 0 ?
              std::string("points") :
              "empty or " + std::to_string(n_points) + " points") +
           ", each of two numbers" + NumberRange::before_unit + "m" +
           NumberRange::after_unit + ", separated by commas: '0 0, 1 0.5'";
  }



  std::vector<Point<2>>
  PointList::values(const std::string &text)
  {
    std::vector<Point<2>> points;
    for (const std::string &item : Utilities::split_string_list(text))
      {
        const std::vector<std::string> numbers = split_quantities(item);
        points.emplace_back(NumberRange::values(numbers[0])[0],
                            NumberRange::values(numbers[1])[0]);
      }
    return points;
  }
} // namespace StickSlip
