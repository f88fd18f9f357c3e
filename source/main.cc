// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/base/libraries.h>
#include <stickslip/base/machine_memory.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/scene/command_line.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/scene/mesh_report.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/scene/version_report.h>
#include <stickslip/simulation/checkpoints.h>
#include <stickslip/simulation/mesh_adaptation.h>
#include <stickslip/simulation/output_folder.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/start_report.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

namespace
{
  using namespace StickSlip;

  // The exit status of a program that was interrupted, by convention.
  constexpr int interrupted = 130;



  /** A message without the middle of what nobody reads to its end, such as
   * the name of an entry of a million characters. */
  std::string
  shortened(const std::string &message)
  {
    constexpr std::size_t longest = 3000, end = 500;
    if (message.size() <= longest)
      return message;
    return message.substr(0, longest - end) + " ... " +
           message.substr(message.size() - end);
  }



  /** Find the cells that have to be refined, if the scene asks for that. */
  template <int dim>
  void
  choose_meshes(SceneParameters<dim> &scene, const bool may_print)
  {
    std::ostream silent(nullptr);
    if (scene.mesh_accuracy.is_wanted())
      adapt_meshes(scene, machine_memory(), may_print ? std::cout : silent);
  }



  /** Take the cells that the run has refined which is to go on. */
  template <int dim>
  void
  take_meshes_of_run(SceneParameters<dim> &scene)
  {
    if (scene.mesh_accuracy.is_wanted())
      scene.mesh_accuracy.refined_cells =
        read_refined_cells(scene.output.directory + "/" +
                             MeshAccuracy::file_of_run,
                           names_of(scene.bodies));
  }



  template <int dim, int n_components>
  int
  simulate(const SceneParameters<dim> &scene,
           const std::string          &checkpoint,
           const bool                  is_first_process)
  {
    Simulation<dim, n_components> simulation(scene, MPI_COMM_WORLD);
    if (!checkpoint.empty())
      {
        simulation.resume(checkpoint);
        if (is_first_process)
          std::cout << "The run goes on from t = " << simulation.state().time
                    << " s (" << checkpoint << ")." << std::endl;
      }
    return simulation.run() ? 0 : interrupted;
  }



  template <int dim>
  int
  run(const SceneReader &reader,
      const CommandLine &command_line,
      const bool         is_first_process)
  {
    SceneParameters<dim> scene;
    const unsigned int   n_on_machine = n_processes_on_machine(MPI_COMM_WORLD);
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      scene = reader.read<dim>();
      refuse_too_large_meshes(scene, n_on_machine, machine_memory());
    });
    std::string checkpoint;
    if (command_line.restart)
      carry_out_agreed(MPI_COMM_WORLD, [&]() { take_meshes_of_run(scene); });
    if (command_line.restart)
      checkpoint = find_checkpoint(scene, MPI_COMM_WORLD);
    std::unique_ptr<OutputFolder> folder;
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      if (is_first_process)
        folder =
          claim_output_folder(scene.output.directory,
                              reader,
                              command_line.restart ? EarlierResults::go_on :
                              command_line.overwrite ?
                                                     EarlierResults::overwrite :
                                                     EarlierResults::refuse);
    });
    carry_out_agreed(MPI_COMM_WORLD,
                     [&]() { choose_meshes(scene, is_first_process); });
    // Input that is refused on a coarser mesh is left to the run, which may
    // take it, and says why if not.
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      if (is_first_process)
        report_start(scene,
                     dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     reader.warnings(),
                     std::cout);
    });
    try
      {
        if constexpr (dim == 2)
          if (scene.deformation == Deformation::antiplane)
            return simulate<dim, 1>(scene, checkpoint, is_first_process);
        return simulate<dim, dim>(scene, checkpoint, is_first_process);
      }
    catch (const InputError &error)
      {
        throw InputError(reader.assignments().with_origin(error.what()));
      }
  }



  template <int dim>
  int
  check(const SceneReader &reader, const bool is_first_process)
  {
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      auto scene = reader.read<dim>();
      if (!is_first_process)
        return;
      refuse_too_large_meshes(scene,
                              dealii::Utilities::MPI::n_mpi_processes(
                                MPI_COMM_WORLD),
                              machine_memory());
      choose_meshes(scene, true);
      const std::string refusal =
        report_start(scene,
                     dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     reader.warnings(),
                     std::cout);
      if (!refusal.empty())
        throw InputError(reader.assignments().with_origin(refusal));
      report_meshes(scene, std::cout);
      write_mesh_pictures(scene, scene.output.directory);
      std::cout << "The meshes are in " << scene.output.directory
                << "/mesh_*.vtk." << std::endl;
    });
    return 0;
  }



  template <int dim>
  int
  print_parameters(const SceneReader &reader, const bool is_first_process)
  {
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      const auto scene = reader.read<dim>();
      if (is_first_process)
        write_parameters(scene, std::cout);
    });
    return 0;
  }



  /** The reader of a file, the same on all processes. */
  std::unique_ptr<SceneReader>
  open_scene(const std::string &file, const CommandLine &command_line)
  {
    std::unique_ptr<SceneReader> reader;
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      reader = std::make_unique<SceneReader>(file, command_line.overrides);
    });
    return reader;
  }



  int
  check(const std::string &file,
        const CommandLine &command_line,
        const bool         is_first_process)
  {
    const auto reader = open_scene(file, command_line);
    return reader->dimension() == 2 ? check<2>(*reader, is_first_process) :
                                      check<3>(*reader, is_first_process);
  }



  /** Check several files, each whatever is wrong with the others. */
  int
  check_all(const CommandLine &command_line, const bool is_first_process)
  {
    std::vector<std::string> files = {command_line.parameter_file};
    files.insert(files.end(),
                 command_line.more_files.begin(),
                 command_line.more_files.end());
    if (files.size() == 1)
      return check(files[0], command_line, is_first_process);
    int status = 0;
    for (const std::string &file : files)
      {
        if (is_first_process)
          std::cout << file << ":" << std::endl;
        try
          {
            check(file, command_line, is_first_process);
          }
        catch (const std::exception &error)
          {
            status = 1;
            if (is_first_process)
              std::cerr << "stickslip: " << file << ": "
                        << shortened(sentence(error)) << std::endl;
          }
      }
    return status;
  }



  int
  carry_out(const CommandLine &command_line, const bool may_print)
  {
    switch (command_line.task)
      {
        case CommandLine::Task::print_help:
          if (may_print)
            std::cout << command_line_help();
          return 0;
        case CommandLine::Task::print_version:
          if (may_print)
            std::cout << version_report();
          return 0;
        case CommandLine::Task::print_parameter_reference:
          if (may_print)
            print_parameter_reference(std::cout);
          return 0;
        case CommandLine::Task::check:
          return check_all(command_line, may_print);
        case CommandLine::Task::print_parameters:
        case CommandLine::Task::run:
          {
            const auto reader =
              open_scene(command_line.parameter_file, command_line);
            if (command_line.task == CommandLine::Task::print_parameters)
              return reader->dimension() == 2 ?
                       print_parameters<2>(*reader, may_print) :
                       print_parameters<3>(*reader, may_print);
            return reader->dimension() == 2 ?
                     run<2>(*reader, command_line, may_print) :
                     run<3>(*reader, command_line, may_print);
          }
      }
    return 1;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Libraries libraries;

  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const bool is_parallel =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1;
  try
    {
      return carry_out(parse_command_line({argv + 1, argv + argc}), rank == 0);
    }
  catch (const InputError &error)
    {
      // All processes read the same input.
      if (rank == 0)
        std::cerr << "stickslip: " << shortened(error.what()) << std::endl;
      return 1;
    }
  catch (const AgreedFailure &error)
    {
      if (rank == 0)
        std::cerr << "stickslip: " << shortened(error.what()) << std::endl;
      return 1;
    }
  catch (const std::exception &error)
    {
      // Usually all processes fail alike and one message is enough. If only
      // this one does, the others must be stopped.
      if (rank != 0)
        std::this_thread::sleep_for(std::chrono::seconds(2));
      std::cerr << "stickslip: " << shortened(sentence(error)) << std::endl;
      if (is_parallel)
        MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
}
