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



  namespace
  {
    const std::string automatic = "auto";



    /** Pattern of a number or the word that stands for one that follows. */
    class AutomaticPattern : public Patterns::PatternBase
    {
    public:
      explicit AutomaticPattern(const NumberRange &range)
        : range(range)
      {}

      virtual bool
      match(const std::string &text) const override
      {
        return text == automatic || range.match(text);
      }

      virtual std::string
      description(const OutputStyle style) const override
      {
        return automatic + " or " + range.description(style);
      }

      virtual std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<AutomaticPattern>(*this);
      }

    private:
      const NumberRange range;
    };
  } // namespace



  void
  add_number(ParameterHandler  &prm,
             const std::string &entry,
             AutomaticNumber   &value,
             const NumberRange &range,
             const std::string &documentation)
  {
    prm.declare_entry(entry,
                      value.follows() ? automatic : shortest_form(value),
                      AutomaticPattern(range),
                      documentation);
    prm.add_action(entry, [&value](const std::string &text) {
      if (text == automatic)
        value.make_automatic();
      else
        value = NumberRange::values(text).front();
    });
  }



  void
  add_numbers(ParameterHandler    &prm,
              const std::string   &entry,
              std::vector<double> &values,
              const NumberRange   &range,
              const std::string   &documentation)
  {
    std::string list;
    for (const double x : values)
      list += (list.empty() ? "" : ", ") + shortest_form(x);
    prm.declare_entry(entry, list, range, documentation);
    prm.add_action(entry, [&values](const std::string &text) {
      values = NumberRange::values(text);
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
    prm.declare_entry(entry,
                      field.text(),
                      FieldPattern(range, field.is_optional()),
                      documentation);
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
