// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/checkpoints.h>
#include <stickslip/simulation/run_state_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    std::filesystem::path
    folder_of(const std::string &output_directory)
    {
      return std::filesystem::path(output_directory) / "checkpoints";
    }



    /** Intervals since zero, of a time that is a sum of steps. */
    double
    n_intervals(const double time, const double interval)
    {
      return std::floor(time / interval * (1. + 1e-12));
    }



    bool
    may_change(const std::string &entry)
    {
      // Cells of another mesh would not fit to what is read.
      return entry == "Time/End time" || entry == "Mesh/Refined cells" ||
             (entry.rfind("Output/", 0) == 0 &&
              entry != "Output/Write faults" &&
              entry != "Output/Fault fields" && entry != "Output/Stations");
    }



    /** Throw where an entry that may not change has another value. */
    void
    compare_entries(const std::string &file, const SceneEntries &now)
    {
      for (const auto &[entry, value] : run_state_entries(file))
        {
          const auto present = now.find(entry);
          if (present != now.end() && present->second != value &&
              !may_change(entry))
            throw InputError("'" + entry + "' = '" + present->second +
                             "': in the run that is to go on it is '" + value +
                             "'; with --restart only 'Time/End time' and most "
                             "entries of 'Output' may change.");
        }
    }
  } // namespace



  Checkpoints::Checkpoints(const OutputParameters &parameters,
                           const double            time,
                           const MPI_Comm          communicator)
    : parameters(parameters)
    , communicator(communicator)
    , last_time(time)
  {}



  bool
  Checkpoints::is_due(const double time) const
  {
    if (!are_written())
      return false;
    const double interval = parameters.checkpoint_interval;
    if (interval > 0. &&
        n_intervals(time, interval) > n_intervals(last_time, interval))
      return true;
    return parameters.checkpoint_wall_time > 0. &&
           Utilities::MPI::broadcast(communicator,
                                     since_last.wall_time() >=
                                       parameters.checkpoint_wall_time);
  }



  std::string
  Checkpoints::file(const unsigned int step) const
  {
    const std::filesystem::path folder = folder_of(parameters.directory);
    carry_out_agreed(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::error_code error;
      std::filesystem::create_directories(folder, error);
      if (!std::filesystem::is_directory(folder))
        throw InputError("The folder '" + folder.string() +
                         "' cannot be created" +
                         (error ? " (" + error.message() + ")" : "") + ".");
    });
    std::ostringstream name;
    name << std::setfill('0') << std::setw(9) << step << ".state";
    return (folder / name.str()).string();
  }



  void
  Checkpoints::note_written(const double time)
  {
    last_time = time;
    since_last.restart();
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::error_code                error;
    const std::vector<std::string> files =
      checkpoint_files(parameters.directory);
    for (unsigned int i = parameters.checkpoints_kept; i < files.size(); ++i)
      std::filesystem::remove(files[i], error);
  }



  std::vector<std::string>
  checkpoint_files(const std::string &output_directory)
  {
    std::vector<std::string> files;
    std::error_code          error;
    for (const auto &item :
         std::filesystem::directory_iterator(folder_of(output_directory),
                                             error))
      if (item.path().extension() == ".state")
        files.push_back(item.path().string());
    std::sort(files.rbegin(), files.rend());
    return files;
  }



  template <int dim>
  std::string
  find_checkpoint(const SceneParameters<dim> &scene,
                  const MPI_Comm              communicator)
  {
    std::string found;
    carry_out_agreed(communicator, [&]() {
      for (const std::string &file : checkpoint_files(scene.output.directory))
        {
          try
            {
              run_state_entries(file);
              found = file;
              break;
            }
          catch (const InputError &error)
            {
              if (Utilities::MPI::this_mpi_process(communicator) == 0)
                std::cout << error.what() << " The one before is used."
                          << std::endl;
            }
        }
      if (found.empty())
        throw InputError("'Output/Output directory' = '" +
                         scene.output.directory +
                         "': there is no whole checkpoint of a run that could "
                         "go on; without --restart the run begins anew.");
      compare_entries(found, entries_of(scene));
    });
    return found;
  }



  template decltype(find_checkpoint<2>) find_checkpoint<2>;
  template decltype(find_checkpoint<3>) find_checkpoint<3>;
} // namespace StickSlip
