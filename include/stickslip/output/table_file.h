// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_table_file_h
#define stickslip_output_table_file_h

#include <stickslip/output/file_state.h>

#include <chrono>
#include <string>
#include <type_traits>

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

    TableFile(const TableFile &) = delete;

    TableFile &
    operator=(const TableFile &) = delete;

    ~TableFile();

    /** Add to the present row. */
    template <typename T>
    TableFile &
    operator<<(const T &value)
    {
      if constexpr (std::is_same<T, double>::value)
        add_number(value);
      else if constexpr (std::is_integral<T>::value &&
                         !std::is_same<T, char>::value)
        row += std::to_string(value);
      else
        row += value;
      return *this;
    }

    /** Write the present row. Throws InputError if that is impossible. */
    void
    end_row();

    /** The file as it is now. */
    FileState
    state() const;

  private:
    void
    add_number(const double value);

    /** Write the present row; returns zero or the number of an error. */
    int
    write_row();

    /** True unless the file has been deleted or its folder has been. */
    bool
    is_there();

    std::string   file_name;
    int           file = -1;
    std::string   row;
    std::uint64_t size = 0;

    /** The last look for the file under its name. */
    std::chrono::steady_clock::time_point last_look;
  };
} // namespace StickSlip

#endif
