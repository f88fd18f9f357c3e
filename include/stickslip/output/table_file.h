// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_table_file_h
#define stickslip_output_table_file_h

#include <stickslip/output/file_state.h>

#include <fstream>
#include <sstream>
#include <string>

namespace StickSlip
{
  /**
   * A text file that is written row by row, each of which reaches the file at
   * once and as a whole: where there is no space for it, the file ends with the
   * one before. Numbers have 17 significant digits.
   */
  class TableFile
  {
  public:
    /** Create or replace a file. */
    explicit TableFile(const std::string &file_name);

    /** Go on with a file as it was. Throws InputError if that is impossible. */
    TableFile(const std::string &file_name, const FileState &earlier);

    /** Add to the present row. */
    template <typename T>
    TableFile &
    operator<<(const T &value)
    {
      row << value;
      return *this;
    }

    /** Write the present row. Throws InputError if that is impossible. */
    void
    end_row();

    /** The file as it is now. */
    FileState
    state() const;

  private:
    std::string        file_name;
    std::ofstream      file;
    std::ostringstream row;
    std::uint64_t      size = 0;
  };
} // namespace StickSlip

#endif
