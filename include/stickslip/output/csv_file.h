// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_csv_file_h
#define stickslip_output_csv_file_h

#include <fstream>
#include <string>

namespace StickSlip
{
  /**
   * A table of comma-separated values that grows row by row; numbers have 17
   * significant digits. Each row reaches the file at once.
   */
  class CsvFile
  {
  public:
    /**
     * Create or replace the file. Throws InputError if it cannot be written.
     */
    CsvFile(const std::string &file_name, const std::string &titles);

    /** Stream for the values and commas of the present row. */
    std::ostream &
    row()
    {
      return file;
    }

    /** End the present row. Throws an exception if it cannot be written. */
    void
    end_row();

  private:
    std::ofstream file;
    std::string   file_name;
  };
} // namespace StickSlip

#endif
