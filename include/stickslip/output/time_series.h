// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_time_series_h
#define stickslip_output_time_series_h

#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/table_columns.h>
#include <stickslip/output/table_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Writes time_series.csv: a header, then a row for each accepted step with
   * the columns of StepRecord and, for each fault, those of FaultStatistics, in
   * SI units and with 17 significant digits. Faults that may open have those of
   * OpeningStatistics as well, largest_gap and open_area; of faults that bend
   * and may not open there is the largest gap between their sides so far. Rows
   * of steps that take less than a tenth of a second reach the file together.
   */
  template <int dim>
  class TimeSeries
  {
  public:
    /**
     * @p faults: as they are at the start. Throws InputError if the file cannot
     * be written.
     */
    TimeSeries(const std::string                     &file_name,
               const std::vector<FaultSnapshot<dim>> &faults);

    /**
     * Go on with the file of another run with the same faults, as it was.
     * Throws InputError if that is impossible.
     */
    TimeSeries(const std::string                     &file_name,
               const std::vector<FaultSnapshot<dim>> &faults,
               const FileState                       &earlier);

    /** The columns of the file of these faults. */
    static TableColumns
    columns(const std::vector<FaultSnapshot<dim>> &faults);

    /** The file as it is now; writes the rows that wait. */
    FileState
    state()
    {
      return file.state();
    }

    /** Write the rows that wait. Throws InputError if that is impossible. */
    void
    finish()
    {
      file.write_waiting_rows();
    }

    /**
     * Append a row; @p faults in the order of those given first.
     */
    void
    add(const StepRecord &step, const std::vector<FaultSnapshot<dim>> &faults);

  private:
    TableFile    file;
    unsigned int n_faults;
  };
} // namespace StickSlip

#endif
