// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_text_file_h
#define stickslip_parameters_text_file_h

#include <string>

namespace StickSlip
{
  /** Remove the byte order mark of UTF-8, with which some editors begin files,
   * from the first line of one. */
  inline void
  remove_byte_order_mark(std::string &line, const unsigned int line_number)
  {
    if (line_number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
      line.erase(0, 3);
  }
} // namespace StickSlip

#endif
