// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_field_pattern_h
#define stickslip_parameters_field_pattern_h

#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/units.h>

namespace StickSlip
{
  /**
   * Pattern of what a SpatialField is read from: a number of a given range, or
   * any other text, for an expression or a table, which show only later
   * whether they can be used; or nothing, if the field is optional.
   */
  class FieldPattern : public Patterns::PatternBase
  {
  public:
    /** End of the description() of such a pattern. */
    static constexpr auto ending = ", an expression in x, y (z), or table FILE";

    explicit FieldPattern(const NumberRange &range,
                          const bool         is_optional = false)
      : range(range)
      , is_optional(is_optional)
    {}

    virtual bool
    match(const std::string &text) const override
    {
      if (text.empty())
        return is_optional;
      const bool is_number =
        text.find(',') == std::string::npos &&
        (read_quantity(text) || !unknown_unit(text).empty());
      return !is_number || range.match(text);
    }

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override
    {
      return (is_optional ? "nothing, or " : "") + range.description(style) +
             ending;
    }

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<FieldPattern>(*this);
    }

  private:
    const NumberRange range;
    const bool        is_optional;
  };
} // namespace StickSlip

#endif
