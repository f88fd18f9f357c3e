// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * rate_problem FILE.prm [--set ENTRY=VALUE]...
 *
 * Measures one rate problem of a scene: that of its first time step, of size
 * Time/Initial step, at the initial state of the faults, from the static
 * equilibrium. Prints one line of comma-separated values under a header. Times
 * are those of the slowest process, in s; those of set-up of the operator and
 * of the solution are the shortest of several repetitions.
 */

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <stickslip/simulation/command_line.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/scene_reader.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

namespace
{
  using namespace StickSlip;

  constexpr unsigned int repetitions = 3;



  double
  seconds(const std::function<void()> &action)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    Timer timer;
    action();
    timer.stop();
    return Utilities::MPI::max(timer.wall_time(), MPI_COMM_WORLD);
  }



  /** Largest resident size so far of any process, MiB. */
  double
  resident_size()
  {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    return Utilities::MPI::max(memory.VmHWM / 1024., MPI_COMM_WORLD);
  }



  /** Names and values of a table with one row. */
  struct Row
  {
    std::ostringstream names, values;

    template <typename T>
    void
    add(const std::string &name, const T &value)
    {
      names << (names.tellp() > 0 ? "," : "") << name;
      values << (values.tellp() > 0 ? "," : "") << value;
    }
  };



  template <int dim>
  void
  measure(const SceneParameters<dim> &scene)
  {
    Row          row;
    const double memory_at_start = resident_size();

    std::vector<BodyGeometry<dim>> geometries;
    std::vector<Material>          materials;
    std::vector<std::string>       names;
    for (const BodyParameters<dim> &body : scene.bodies)
      {
        geometries.push_back(body.geometry);
        materials.push_back(body.material);
        names.push_back(body.name);
      }
    std::unique_ptr<MeshHierarchy<dim>>  meshes;
    std::unique_ptr<BoundaryValues<dim>> boundary;
    std::unique_ptr<SpatialProblem<dim>> problem;
    const double                         mesh_time        = seconds([&]() {
      meshes = std::make_unique<MeshHierarchy<dim>>(geometries, MPI_COMM_WORLD);
      boundary =
        std::make_unique<BoundaryValues<dim>>(*meshes,
                                              scene.boundary_conditions,
                                              names);
    });
    const double                         memory_of_meshes = resident_size();
    const double                         problem_time     = seconds([&]() {
      problem = std::make_unique<SpatialProblem<dim>>(*meshes,
                                                      materials,
                                                      *boundary,
                                                      scene.gravity);
    });
    const double                         contact_time =
      seconds([&]() { problem->build_contact(problem->make_nodal_vector()); });

    InitialEquilibrium<dim> equilibrium;
    const double            equilibrium_time =
      seconds([&]() { equilibrium = solve_initial_equilibrium(*problem); });
    unsigned int           n_in_tension = 0;
    FaultNodes<dim>        faults(problem->jump_basis(),
                           problem->hierarchy().finest().nodes,
                           make_fault_laws(scene),
                           make_normal_stress(scene,
                                              problem->jump_basis(),
                                              equilibrium,
                                              n_in_tension));
    const SystemState<dim> state =
      make_initial_state(scene, problem->jump_basis(), equilibrium);
    faults.set_state(state.alpha);

    const double      tau = scene.time.initial_step;
    const NodalVector rhs = Newmark::right_hand_side(*problem, state, tau);
    TNNMGSolver<dim>  solver(problem->hierarchy(), scene.tnnmg);
    SolveSummary      summary;
    double            operator_time = std::numeric_limits<double>::max();
    double            solve_time    = operator_time;
    NodalVector       w             = problem->make_vector();
    for (unsigned int repetition = 0; repetition < repetitions; ++repetition)
      {
        problem->hierarchy().combine(Newmark::operator_coefficients(2. * tau));
        operator_time = std::min(operator_time, seconds([&]() {
                                   problem->hierarchy().combine(
                                     Newmark::operator_coefficients(tau));
                                 }));
        w             = 0.;
        solve_time    = std::min(solve_time, seconds([&]() {
                                summary =
                                  solver.solve(faults.friction(), rhs, w);
                              }));
        AssertThrow(summary.converged, ExcMessage("No convergence."));
      }
    double slowest = std::numeric_limits<double>::max(), fastest = 0;
    for (const auto &rate : faults.tangential_jumps(w))
      {
        slowest = std::min(slowest, rate.norm());
        fastest = std::max(fastest, rate.norm());
      }

    const NodePartition &nodes = problem->hierarchy().finest().nodes;
    row.add("processes", Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    row.add("unknowns", nodes.n_global() * dim);
    row.add("levels", meshes->n_levels());
    row.add("fault_nodes", faults.size());
    row.add("largest_share",
            double(Utilities::MPI::max(nodes.n_owned(), MPI_COMM_WORLD)) /
              nodes.n_global());
    row.add("slowest_node", slowest);
    row.add("fastest_node", fastest);
    row.add("tnnmg_iterations", summary.iterations.size());
    row.add("cycles", summary.n_cycles());
    row.add("meshes_s", mesh_time);
    row.add("matrices_and_contact_s", problem_time);
    row.add("contact_s", contact_time);
    row.add("equilibrium_iterations", equilibrium.iterations);
    row.add("equilibrium_s", equilibrium_time);
    row.add("operator_s", operator_time);
    row.add("solve_s", solve_time);
    row.add("start_MiB", memory_at_start);
    row.add("meshes_MiB", memory_of_meshes);
    row.add("largest_MiB", resident_size());
    row.add("hierarchy_MiB",
            Utilities::MPI::max(problem->hierarchy().memory_consumption() /
                                  1048576.,
                                MPI_COMM_WORLD));
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << row.names.str() << '\n' << row.values.str() << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const CommandLine arguments = parse_command_line({argv + 1, argv + argc});
      const SceneReader reader(arguments.parameter_file, arguments.overrides);
      if (reader.dimension() == 2)
        measure(reader.read<2>());
      else
        measure(reader.read<3>());
    }
  catch (const std::exception &error)
    {
      std::cerr << "rate_problem: " << error.what() << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
}
