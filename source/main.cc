// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/base/libraries.h>
#include <stickslip/scene/command_line.h>
#include <stickslip/scene/mesh_report.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>
#include <stickslip/simulation/checkpoints.h>
#include <stickslip/simulation/output_folder.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/version.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

namespace
{
  using namespace StickSlip;

  // The exit status of a program that was interrupted, by convention.
  constexpr int interrupted = 130;



  template <int dim>
  int
  run(const SceneReader &reader,
      const CommandLine &command_line,
      const bool         is_first_process)
  {
    SceneParameters<dim> scene;
    carry_out_agreed(MPI_COMM_WORLD, [&]() { scene = reader.read<dim>(); });
    std::string checkpoint;
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
    Simulation<dim> simulation(scene, MPI_COMM_WORLD);
    if (command_line.restart)
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
  check(const SceneReader &reader, const bool is_first_process)
  {
    carry_out_agreed(MPI_COMM_WORLD, [&]() {
      const auto scene = reader.read<dim>();
      if (!is_first_process)
        return;
      report_meshes(scene, std::cout);
      write_mesh_pictures(scene, scene.output.directory);
      std::cout << "The meshes are in " << scene.output.directory
                << "/mesh_*.vtk." << std::endl;
    });
    return 0;
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
            std::cout << "stickslip " << version << std::endl;
          return 0;
        case CommandLine::Task::print_parameter_reference:
          if (may_print)
            print_parameter_reference(std::cout);
          return 0;
        case CommandLine::Task::check:
        case CommandLine::Task::run:
          {
            std::unique_ptr<SceneReader> reader;
            carry_out_agreed(MPI_COMM_WORLD, [&]() {
              reader =
                std::make_unique<SceneReader>(command_line.parameter_file,
                                              command_line.overrides);
            });
            const bool is_check = command_line.task == CommandLine::Task::check;
            if (reader->dimension() == 2)
              return is_check ? check<2>(*reader, may_print) :
                                run<2>(*reader, command_line, may_print);
            return is_check ? check<3>(*reader, may_print) :
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
        std::cerr << "stickslip: " << error.what() << std::endl;
      return 1;
    }
  catch (const AgreedFailure &error)
    {
      if (rank == 0)
        std::cerr << "stickslip: " << error.what() << std::endl;
      return 1;
    }
  catch (const std::exception &error)
    {
      // Usually all processes fail alike and one message is enough. If only
      // this one does, the others must be stopped.
      if (rank != 0)
        std::this_thread::sleep_for(std::chrono::seconds(2));
      std::cerr << "stickslip: " << sentence(error) << std::endl;
      if (is_parallel)
        MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
}
