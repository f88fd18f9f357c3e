// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_parameters_h
#define stickslip_output_output_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/output/output_cadence.h>
#include <stickslip/output/output_fields.h>
#include <stickslip/parameters/station_list.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Choice of files and fields, and how often they are written.
   */
  struct OutputParameters
  {
    /** Folder of all files; empty: one below output with the
     * name of the parameter file. */
    std::string directory;

    /** Cadence of time_series.csv: a row after every so many accepted steps;
     * zero: no such file. */
    unsigned int time_series_steps = 1;

    /** Choice of faults.h5 and of its fields. */
    bool                    write_faults = true;
    std::vector<FaultField> fault_fields = {FaultField::slip,
                                            FaultField::slip_rate,
                                            FaultField::shear_traction,
                                            FaultField::normal_stress,
                                            FaultField::state,
                                            FaultField::gap,
                                            FaultField::opening_rate,
                                            FaultField::contact_state};

    /** Cadence of faults.h5, by the largest slip rate of any fault. */
    CadenceParameters fault_cadence = {2., 1e-5, 1e-3, 0.5};

    /** Stations whose fields are recorded, and their cadence, by the largest
     * slip rate of any fault. */
    std::vector<Station> stations;
    CadenceParameters    station_cadence = {2., 1e-5, 1e-3, 0.5};

    /** Choice of the VTU files of the faults, which have the same fields and
     * come with the cadence of those of the bodies. */
    bool write_fault_surfaces = true;

    /** Choice, fields and cadence of the VTU files of the bodies. */
    bool                     write_volume   = true;
    std::vector<VolumeField> volume_fields  = {VolumeField::displacement,
                                               VolumeField::velocity,
                                               VolumeField::stress,
                                               VolumeField::body,
                                               VolumeField::material};
    CadenceParameters        volume_cadence = {100., 1e-4, 0.05, 5.};

    /** True if each process writes a file of its own. */
    bool volume_pieces = false;

    /** An event begins when the mean slip rate of a fault rises above this,
     * m/s; zero: twice the largest prescribed velocity. */
    double event_start_slip_rate = 0.;

    /** An event ends when it falls below this fraction of the former. */
    double event_end_fraction = 0.5;

    /** An opening begins when the largest gap of a fault rises above this, m;
     * zero: a part of the fault's extent, see OpeningCatalogue. */
    double opening_threshold = 0.;

    /** Simulated time, s, and wall time, s, after which a checkpoint is
     * written; zero: not for this reason. */
    double checkpoint_interval  = 0.;
    double checkpoint_wall_time = 600.;

    /** The number of checkpoints that stay, the last ones; zero: none are
     * written. */
    unsigned int checkpoints_kept = 2;

    /** Account of the energy in the summary. */
    bool energy_balance = true;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
