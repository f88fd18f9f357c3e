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
   * A text file that is written row by row, each of which reaches the file as a
   * whole: where there is no space for it, the file ends with the one before.
   * Numbers have 17 significant digits.
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

    /** Writes the rows that wait, if that is possible. */
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
        rows += std::to_string(value);
      else
        rows += value;
      return *this;
    }

    /** Write the present row, and those that wait. Throws InputError if that is
     * impossible. */
    void
    end_row();

    /** End the present row, which may wait for the next ones if the last
     * writing was less than a tenth of a second ago: for rows that come fast,
     * since each writing is a call of the system. Throws as end_row(). */
    void
    end_waiting_row();

    /** Write the rows that wait. Throws as end_row(). */
    void
    write_waiting_rows();

    /** The file as it is now; writes the rows that wait. */
    FileState
    state();

  private:
    void
    add_number(const double value);

    /** Write the rows that are complete, or those of them for which there is
     * space; returns zero or the number of an error. */
    int
    write_rows();

    /** True unless the file has been deleted or its folder has been. */
    bool
    has_name() const;

    std::string file_name;
    int         file = -1;
    /** Rows that are not in the file, the last one perhaps not complete. */
    std::string rows;

    /** Length of the file up to its last whole row. */
    std::uint64_t size = 0;

    std::chrono::steady_clock::time_point last_writing;
  };
} // namespace StickSlip

#endif
