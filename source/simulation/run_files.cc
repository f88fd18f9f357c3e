// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/refined_cells.h>
#include <stickslip/output/atomic_file.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/run_files.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace StickSlip
{
  namespace
  {
    OutputDirectory
    prepared_directory(const std::string &path, const RecordState *earlier)
    {
      OutputDirectory directory(path);
      if (earlier == nullptr)
        directory.remove_earlier_results();
      else
        {
          VolumeEntries kept = earlier->volumes;
          kept.insert(kept.end(),
                      earlier->surfaces.begin(),
                      earlier->surfaces.end());
          directory.remove_later_results(kept);
        }
      return directory;
    }
  } // namespace



  template <int dim>
  RunFiles<dim>::RunFiles(const SceneParameters<dim>            &scene,
                          const std::vector<FaultSnapshot<dim>> &faults,
                          const std::vector<FaultLayout<dim>>   &shapes,
                          const std::vector<StationTable>       &station_tables,
                          const RecordState                     *earlier)
    : directory(prepared_directory(scene.output.directory, earlier))
    , catalogue(directory.file("events.csv"),
                names_of(scene.faults),
                shapes,
                event_start_slip_rate(scene),
                scene.output.event_end_fraction)
    , volumes(directory.file("solution.pvd"))
    , surfaces(directory.file("faults.pvd"))
    , progress(std::cout, isatty(STDOUT_FILENO) == 1, scene.time.end_time)
  {
    const std::string series_file  = directory.file("time_series.csv"),
                      history_file = directory.file("faults.h5");
    if (scene.output.time_series_steps > 0)
      time_series = earlier != nullptr && earlier->time_series.size > 0 ?
                      std::make_unique<TimeSeries<dim>>(series_file,
                                                        faults,
                                                        earlier->time_series) :
                      std::make_unique<TimeSeries<dim>>(series_file, faults);
    const std::string energy_file = directory.file("energy.csv");
    if (scene.output.time_series_steps > 0 && scene.output.energy_balance)
      energies =
        earlier != nullptr && earlier->energies.size > 0 ?
          std::make_unique<EnergySeries>(energy_file, earlier->energies) :
          std::make_unique<EnergySeries>(energy_file, dim);
    if (scene.output.write_faults)
      history = earlier != nullptr && earlier->history.size > 0 ?
                  std::make_unique<FaultHistory<dim>>(history_file,
                                                      faults,
                                                      scene.output.fault_fields,
                                                      earlier->history) :
                  std::make_unique<FaultHistory<dim>>(
                    history_file, faults, shapes, scene.output.fault_fields);
    if (!station_tables.empty())
      stations =
        earlier != nullptr && !earlier->stations.empty() ?
          std::make_unique<StationFiles>(directory,
                                         station_tables,
                                         earlier->stations) :
          std::make_unique<StationFiles>(
            directory,
            station_tables,
            std::filesystem::path(scene.output.directory).filename().string());
    if (std::any_of(faults.begin(), faults.end(), [](const auto &fault) {
          return fault.may_open();
        }))
      openings =
        std::make_unique<OpeningCatalogue<dim>>(directory.file("openings.csv"),
                                                shapes,
                                                scene.output.opening_threshold);
    if (earlier != nullptr)
      {
        catalogue.resume(earlier->events);
        if (openings)
          openings->resume(earlier->openings);
        volumes.resume(earlier->volumes);
        surfaces.resume(earlier->surfaces);
      }
    describe_tables(faults);
    SceneParameters<dim> repeated = scene;
    if (!scene.mesh_accuracy.refined_cells.empty())
      {
        MeshAccuracy &meshes      = repeated.mesh_accuracy;
        meshes.refined_cells_file = MeshAccuracy::file_of_run;
        write_file_atomically(directory.file(meshes.refined_cells_file),
                              table_of_refined_cells(names_of(scene.bodies),
                                                     meshes.refined_cells));
      }
    write_parameters(repeated, directory.file("parameters.prm"));
  }



  template <int dim>
  void
  RunFiles<dim>::describe_tables(
    const std::vector<FaultSnapshot<dim>> &faults) const
  {
    std::vector<std::pair<std::string, TableColumns>> tables;
    if (time_series)
      tables.emplace_back("time_series.csv", TimeSeries<dim>::columns(faults));
    if (energies)
      tables.emplace_back("energy.csv", EnergySeries::columns(dim));
    tables.emplace_back("events.csv", catalogue.columns());
    if (openings)
      tables.emplace_back("openings.csv", openings->columns());
    write_columns(directory.file("columns.csv"), tables);
  }



  template struct RunFiles<2>;
  template struct RunFiles<3>;
} // namespace StickSlip
