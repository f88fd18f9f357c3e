// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_field_pattern_h
#define stickslip_parameters_field_pattern_h

#include <stickslip/parameters/number_range.h>

namespace StickSlip
{
  /**
   * Pattern of what a SpatialField is read from: a number of a given range, or
   * any other text, for an expression or a table, which show only later
   * whether they can be used.
   */
  class FieldPattern : public Patterns::PatternBase
  {
  public:
    /** End of the description() of such a pattern. */
    static constexpr auto ending = ", an expression in x, y (z), or table FILE";

    explicit FieldPattern(const NumberRange &range)
      : range(range)
    {}

    virtual bool
    match(const std::string &text) const override
    {
      return !text.empty() && (!NumberRange().match(text) || range.match(text));
    }

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override
    {
      return range.description(style) + ending;
    }

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<FieldPattern>(*this);
    }

  private:
    const NumberRange range;
  };
} // namespace StickSlip

#endif
