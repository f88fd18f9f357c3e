// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_atomic_file_h
#define stickslip_output_atomic_file_h

#include <string>

namespace StickSlip
{
  /**
   * Replace a file so that a reader finds either the old or the new content,
   * never a part: the content is written next to it and then renamed.
   *
   * Throws InputError if the folder cannot be written to.
   */
  void
  write_file_atomically(const std::string &file_name,
                        const std::string &content);
} // namespace StickSlip

#endif
