// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/field_pattern.h>

namespace StickSlip
{
  void
  add_number(ParameterHandler  &prm,
             const std::string &entry,
             double            &value,
             const NumberRange &range,
             const std::string &documentation)
  {
    prm.declare_entry(entry, shortest_form(value), range, documentation);
    prm.add_action(entry, [&value](const std::string &text) {
      value = NumberRange::values(text).front();
    });
  }



  void
  add_field(ParameterHandler  &prm,
            const std::string &entry,
            SpatialField      &field,
            const NumberRange &range,
            const std::string &documentation)
  {
    field.describe(entry, range);
    prm.declare_entry(entry, field.text(), FieldPattern(range), documentation);
    prm.add_action(entry,
                   [&field](const std::string &text) { field.set(text); });
  }



  void
  add_count(ParameterHandler  &prm,
            const std::string &entry,
            unsigned int      &value,
            const unsigned int smallest,
            const unsigned int largest,
            const std::string &documentation)
  {
    prm.declare_entry(entry,
                      std::to_string(value),
                      NumberRange().whole().at_least(smallest).at_most(largest),
                      documentation);
    prm.add_action(entry, [&value](const std::string &text) {
      value = static_cast<unsigned int>(NumberRange::values(text).front());
    });
  }



  void
  add_switch(ParameterHandler  &prm,
             const std::string &entry,
             bool              &value,
             const std::string &documentation)
  {
    prm.declare_entry(entry,
                      value ? "true" : "false",
                      Patterns::Selection("true|false"),
                      documentation);
    prm.add_action(entry, [&value](const std::string &text) {
      value = (text == "true");
    });
  }



  void
  add_text(ParameterHandler  &prm,
           const std::string &entry,
           std::string       &value,
           const std::string &documentation)
  {
    prm.declare_entry(entry, value, Patterns::Anything(), documentation);
    prm.add_action(entry, [&value](const std::string &text) { value = text; });
  }
} // namespace StickSlip
