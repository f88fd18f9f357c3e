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

  /** Value of the first control character in a line of UTF-8 that is no tab,
   * nor a carriage return at the end; -1 if there is none. Messages that repeat
   * one would do to a terminal whatever it means. */
  inline int
  control_character(const std::string &line)
  {
    for (std::size_t i = 0; i < line.size(); ++i)
      {
        const auto byte = static_cast<unsigned char>(line[i]);
        if ((byte < 0x20 && byte != '\t' &&
             !(byte == '\r' && i + 1 == line.size())) ||
            byte == 0x7f)
          return byte;
        // Controls of Latin-1 take two bytes.
        if (byte == 0xc2 && i + 1 < line.size() &&
            static_cast<unsigned char>(line[i + 1]) < 0xa0)
          return static_cast<unsigned char>(line[i + 1]);
      }
    return -1;
  }
} // namespace StickSlip

#endif
