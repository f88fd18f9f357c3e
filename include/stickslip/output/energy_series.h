// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_energy_series_h
#define stickslip_output_energy_series_h

#include <stickslip/output/table_columns.h>
#include <stickslip/output/table_file.h>

#include <string>

namespace StickSlip
{
  /**
   * Energies of all bodies at one time and the work since the start, J, in two
   * dimensions for 1 m of the third one.
   */
  struct EnergyRecord
  {
    double time    = 0;
    double kinetic = 0, elastic = 0;
    /** Of driven sides, and of gravity and tractions. */
    double driven_sides = 0, loads = 0;
    /** Energy that is dissipated, positive, and that contacts take which come
     * together or break. */
    double friction = 0, viscosity = 0, radiation = 0, contact = 0;
    /** Energy that new contact mappings add. */
    double mappings = 0;
    /** Change of kinetic and elastic energy that all of these do not explain.
     */
    double missing = 0;
  };

  /**
   * Writes energy.csv, row by row.
   */
  class EnergySeries
  {
  public:
    /** Begin a file for bodies in that many dimensions. Throws InputError if it
     * cannot be written. */
    EnergySeries(const std::string &file_name, const unsigned int dim);

    /** Go on with a file as it was. Throws InputError if that is impossible. */
    EnergySeries(const std::string &file_name, const FileState &earlier);

    static TableColumns
    columns(const unsigned int dim);

    void
    add(const EnergyRecord &record);

    /** The file as it is now. */
    FileState
    state()
    {
      return file.state();
    }

  private:
    TableFile file;
  };
} // namespace StickSlip

#endif
