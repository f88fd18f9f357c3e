// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_station_files_h
#define stickslip_output_station_files_h

#include <stickslip/output/output_directory.h>
#include <stickslip/output/table_columns.h>
#include <stickslip/output/table_file.h>
#include <stickslip/parameters/station_list.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Contents of the header of a station's file.
   */
  struct StationTable
  {
    Station station;

    /** True on a fault, false in a body. */
    bool is_on_fault;

    /** The size of the face or cell in which the station is, m. */
    double element_size;

    /** All columns but the time. */
    TableColumns columns;
  };

  /**
   * The files stations/NAME.dat of a run, in the form of the SEAS benchmarks: a
   * header of lines that begin with #, a line of names, and a line for each
   * time, all separated by blanks. The time has 14 digits, other numbers have
   * seven.
   */
  class StationFiles
  {
  public:
    /** Create or replace them. @p problem: first line of the headers. */
    StationFiles(const OutputDirectory           &directory,
                 const std::vector<StationTable> &tables,
                 const std::string               &problem);

    /** Go on with files as they were. Throws InputError if that is impossible.
     */
    StationFiles(const OutputDirectory           &directory,
                 const std::vector<StationTable> &tables,
                 const std::vector<FileState>    &earlier);

    /** Add the values of each station at a time. Throws InputError if that is
     * impossible. */
    void
    add(const double time, const std::vector<std::vector<double>> &values);

    /** The files as they are now. */
    std::vector<FileState>
    state() const;

  private:
    std::vector<std::unique_ptr<TableFile>> files;
  };
} // namespace StickSlip

#endif
