// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_run_files_h
#define stickslip_simulation_run_files_h

#include <stickslip/output/energy_series.h>
#include <stickslip/output/event_catalogue.h>
#include <stickslip/output/fault_history.h>
#include <stickslip/output/opening_catalogue.h>
#include <stickslip/output/output_directory.h>
#include <stickslip/output/progress.h>
#include <stickslip/output/pvd_record.h>
#include <stickslip/output/station_files.h>
#include <stickslip/output/time_series.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/simulation/run_state.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The folder and the files of one run, but for those of the bodies and of
   * surfaces at one time. On the process that writes.
   */
  template <int dim>
  struct RunFiles
  {
    /** Make the folder and the files or, with an @p earlier record, go on with
     * those that are there. Throws InputError if one cannot be written. */
    RunFiles(const SceneParameters<dim>            &scene,
             const std::vector<FaultSnapshot<dim>> &faults,
             const std::vector<FaultLayout<dim>>   &shapes,
             const std::vector<StationTable>       &station_tables,
             const RecordState                     *earlier);

    /** Say in columns.csv what is in the tables. */
    void
    describe_tables(const std::vector<FaultSnapshot<dim>> &faults) const;

    const OutputDirectory directory;
    EventCatalogue<dim>   catalogue;
    PvdRecord             volumes, surfaces;
    Progress              progress;
    /** Files that are asked for, null otherwise. */
    std::unique_ptr<TimeSeries<dim>>   time_series;
    std::unique_ptr<EnergySeries>      energies;
    std::unique_ptr<FaultHistory<dim>> history;
    std::unique_ptr<StationFiles>      stations;
    /** Openings, if a fault may open, null otherwise. */
    std::unique_ptr<OpeningCatalogue<dim>> openings;
  };
} // namespace StickSlip

#endif
