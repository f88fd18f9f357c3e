// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/field_pattern.h>

namespace StickSlip
{
  namespace
  {
    const std::string beginning = "[Field ";
  } // namespace



  FieldPattern::FieldPattern(const NumberRange &range)
    : range(range)
  {}



  bool
  FieldPattern::match(const std::string &text) const
  {
    return !text.empty() && (!NumberRange().match(text) || range.match(text));
  }



  std::string
  FieldPattern::description(const OutputStyle) const
  {
    return beginning + range.description() + "]";
  }



  std::unique_ptr<Patterns::PatternBase>
  FieldPattern::clone() const
  {
    return std::make_unique<FieldPattern>(*this);
  }



  bool
  FieldPattern::is_described_by(const std::string &description)
  {
    return description.rfind(beginning, 0) == 0;
  }



  std::string
  FieldPattern::in_words(const std::string &description)
  {
    return description.substr(beginning.size(),
                              description.size() - beginning.size() - 1) +
           ", an expression in x, y (z), or table FILE";
  }
} // namespace StickSlip
