// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/name_list.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/point_list.h>
#include <stickslip/parameters/station_list.h>

#include <sstream>

namespace StickSlip
{
  namespace
  {
    const NumberRange &
    length()
    {
      static const NumberRange range = NumberRange().in("m");
      return range;
    }



    /** An item as a station whose position is text; without a name if it is
     * none. */
    std::pair<Station, std::vector<std::string>>
    parts_of(const std::string &item)
    {
      Station           station;
      const std::size_t colon = item.find(':');
      if (colon == std::string::npos)
        return {station, {}};
      std::istringstream before(item.substr(0, colon)),
        after(item.substr(colon + 1));
      before >> station.name;
      after >> station.place;
      std::string rest;
      if (before >> rest)
        station.name.clear();
      std::getline(after, rest);
      return {station, split_quantities(rest)};
    }
  } // namespace



  bool
  StationList::match(const std::string &text) const
  {
    const NameList name;
    for (const std::string &item : Utilities::split_string_list(text))
      {
        const auto [station, numbers] = parts_of(item);
        if (station.name.empty() || station.place.empty() ||
            !name.match(station.name) || !name.match(station.place) ||
            numbers.size() < 2 || numbers.size() > 3)
          return false;
        for (const std::string &number : numbers)
          if (!length().match(number))
            return false;
      }
    return true;
  }



  std::string
  StationList::description(const OutputStyle) const
  {
    return "names of letters, digits, _ and -, each with a colon, a fault or "
           "body and the coordinates of a point" +
           std::string(NumberRange::before_unit) + "m" +
           NumberRange::after_unit +
           ", separated by commas: 'shallow: main 0 0, far: plus 0 16 km'";
  }



  std::vector<Station>
  StationList::values(const std::string &text)
  {
    std::vector<Station> stations;
    for (const std::string &item : Utilities::split_string_list(text))
      {
        auto [station, numbers] = parts_of(item);
        for (const std::string &number : numbers)
          station.position.push_back(NumberRange::values(number)[0]);
        stations.push_back(station);
      }
    return stations;
  }



  std::string
  StationList::text(const std::vector<Station> &stations)
  {
    std::vector<std::string> items;
    for (const Station &station : stations)
      {
        items.push_back(station.name + ": " + station.place);
        for (const double x : station.position)
          items.back() += " " + shortest_form(x);
      }
    return join_names(items);
  }
} // namespace StickSlip
