// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_file_state_h
#define stickslip_output_file_state_h

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * All that is needed to give a file that has been written further the content
   * again that it has now: its size, and those of its bytes that may be
   * changed.
   */
  struct FileState
  {
    /** Zero: there is no such file. */
    std::uint64_t size = 0;

    /** First byte of each part, and its bytes. */
    std::vector<std::pair<std::uint64_t, std::string>> parts;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &size &parts;
    }
  };

  /** Ranges of bytes, each by its first one and the number of them. */
  using ByteRanges = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  /**
   * The state of a file whose bytes in @p final_ranges, in any order, are never
   * changed any more. Throws InputError if the file cannot be read.
   */
  FileState
  file_state(const std::string &file_name, ByteRanges final_ranges);

  /**
   * Make the file again as it was. Throws InputError if that is impossible,
   * since it has become shorter than it was or cannot be written.
   */
  void
  restore_file(const std::string &file_name, const FileState &state);
} // namespace StickSlip

#endif
