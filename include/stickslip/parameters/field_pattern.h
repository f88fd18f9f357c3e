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
    explicit FieldPattern(const NumberRange &range);

    virtual bool
    match(const std::string &text) const override;

    /** Text for declared_entries(), whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override;

    virtual std::unique_ptr<PatternBase>
    clone() const override;

    /** True for the description() of such a pattern. */
    static bool
    is_described_by(const std::string &description);

    /** Allowed values, in words, from the description(). */
    static std::string
    in_words(const std::string &description);

  private:
    const NumberRange range;
  };
} // namespace StickSlip

#endif
