// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_expression_text_h
#define stickslip_parameters_expression_text_h

#include <regex>
#include <string>

namespace StickSlip
{
  /** An expression as muParser wants it: the parenthesis of a function next to
   * its name. Moved there, it leaves all other characters in their place. */
  inline std::string
  without_space_after_names(const std::string &expression)
  {
    static const std::regex name_and_spaces("([A-Za-z_][A-Za-z0-9_]*)"
                                            "([ \t]+)\\(");
    return std::regex_replace(expression, name_and_spaces, "$1($2");
  }
} // namespace StickSlip

#endif
