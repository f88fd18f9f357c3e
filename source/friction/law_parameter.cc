// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/law_parameter.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/name_list.h>

#include <algorithm>
#include <stdexcept>

namespace StickSlip
{
  std::string
  LawParameter::full_documentation() const
  {
    const std::string with_unit = !words.empty() ? "" :
                                  unit == "1"    ? ", without unit" :
                                                   ", in " + unit;
    return documentation + with_unit + ".";
  }



  std::string
  LawParameter::mistake() const
  {
    if (entry.empty())
      return "has no name";
    if (documentation.empty())
      return "has no documentation";
    if (!words.empty())
      return "";
    if (unit.empty())
      return "has no unit; a number without unit has the unit '1'";
    if (!range.contains(default_value))
      return "has the default value " + shortest_form(default_value) +
             ", but must be " + range.description();
    return "";
  }



  void
  LawParameter::declare(ParameterHandler &prm, SpatialField &value) const
  {
    NumberRange range_with_unit = range;
    if (unit != "1")
      range_with_unit.in(unit);
    if (varies)
      add_field(prm, entry, value, range_with_unit, full_documentation());
    else if (words.empty())
      {
        value.describe(entry, range_with_unit);
        prm.declare_entry(entry,
                          value.text(),
                          range_with_unit,
                          full_documentation());
        prm.add_action(entry,
                       [&value](const std::string &text) { value.set(text); });
      }
    else
      {
        prm.declare_entry(entry,
                          words.at(static_cast<unsigned int>(value.constant())),
                          Patterns::Selection(join_names(words, "|")),
                          full_documentation());
        prm.add_action(entry, [&value, words = words](const std::string &text) {
          value = std::find(words.begin(), words.end(), text) - words.begin();
        });
      }
  }



  bool
  operator==(const LawParameter &one, const LawParameter &other)
  {
    return one.entry == other.entry &&
           one.documentation == other.documentation && one.unit == other.unit &&
           one.range.description() == other.range.description() &&
           one.default_value == other.default_value &&
           one.varies == other.varies && one.words == other.words &&
           one.least_dimension == other.least_dimension &&
           one.optional == other.optional;
  }



  LawValues::LawValues(const std::vector<LawParameter> &parameters,
                       const std::vector<double>       &values)
    : parameters(parameters)
    , values(values)
  {
    AssertDimension(parameters.size(), values.size());
  }



  double
  LawValues::operator[](const LawParameter &parameter) const
  {
    for (unsigned int i = 0; i < parameters.size(); ++i)
      if (parameters[i].entry == parameter.entry)
        return values[i];
    throw std::logic_error("the parameter '" + parameter.entry +
                           "' is read, but not listed");
  }

} // namespace StickSlip
