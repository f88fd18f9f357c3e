// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * rate_problem FILE.prm [--set ENTRY=VALUE]... [--repetitions N]
 *              [--state NAME:EXPRESSION]... [--taus SIZES]
 *              [--without-smoother] [--amg] [--costs]
 *
 * Measures one rate problem of a scene: that of its first time step, of size
 * Time/Initial step, at the initial state of the faults, from the static
 * equilibrium; or several, one for each given initial state of all faults and
 * each of the given step sizes, separated by commas. Prints a line of
 * comma-separated values for each under a header. Times are those of the
 * slowest process, in s; those of set-up of the operator and of the solution
 * are the shortest of several repetitions.
 *
 * The error is that in the energy norm against TNNMG's solution with tolerance
 * 1e-13, relative to that. Bytes are what is allocated for matrices and solver,
 * without the meshes. Messages and sums are those of one solution, of the
 * process that has sent most. --without-smoother leaves out the nonlinear
 * smoother;
 * --amg solves the linearised problems by conjugate gradients with algebraic
 * multigrid. --costs measures what changes of the operator take. The column
 * converged tells whether the iteration has; there is no error exit if not.
 */

#include <stickslip/faults/fault_functional.h>
#include <stickslip/scene/command_line.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/time/newmark.h>

#include "coupled_problem.h"
#include "linearisation_cost.h"
#include "message_count.h"
#include "rate_solver.h"

namespace
{
  using namespace Measure;

  struct Task
  {
    unsigned int repetitions      = 3;
    bool         without_smoother = false;
    bool         costs            = false;
    Correction   correction       = Correction::of_scene;

    std::vector<double>                              taus;
    std::vector<std::pair<std::string, std::string>> states;
  };



  template <int dim>
  class RateProblem
  {
  public:
    RateProblem(const SceneParameters<dim> &scene, const Task &task)
      : scene(scene)
      , task(task)
      , coupled(scene)
      , problem(*coupled.problem)
    {
      // Levels are made when they are needed first.
      const double bytes_before = allocated_bytes();
      make_all_levels();
      level_bytes  = allocated_bytes() - bytes_before;
      contact_time = shortest(task.repetitions, [&]() {
        problem.build_contact(problem.make_nodal_vector());
        make_all_levels();
      });
      equilibrium_time =
        seconds([&]() { equilibrium = solve_initial_equilibrium(problem); });
      faults = FaultNodes<dim>(problem.jump_basis(),
                               problem.hierarchy().finest().nodes);
      laws   = make_node_laws(scene, problem.jump_basis());
      w      = problem.make_vector();
      if (task.without_smoother)
        this->scene.tnnmg.nonlinear_smoothing = false;
    }

    /** All step sizes for all states. */
    void
    run()
    {
      for (const auto &state : task.states)
        {
          for (FaultParameters &fault : scene.faults)
            if (!state.second.empty())
              fault["Initial state"].set(state.second);
          const SystemState<dim> initial =
            make_initial_state(scene, problem.jump_basis(), equilibrium).system;
          friction = make_fault_friction(faults, laws, initial.normal_stress);
          friction->set_state(faults.at_owned_contact(initial.alpha));
          for (const double size : task.taus)
            {
              tau = size;
              rhs = Newmark<dim>().right_hand_side(problem, initial, tau);
              solve();
              compare();
              add_row(state.first);
            }
        }
      table.print();
    }

  private:
    /** Solve from zero some times. */
    void
    solve()
    {
      const double bytes_before = allocated_bytes();
      const auto   solver = make_rate_solver(problem, scene, task.correction);
      operator_time = solve_time = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i < task.repetitions; ++i)
        {
          problem.combine(Newmark<dim>().operator_coefficients(2. * tau));
          problem.hierarchy().take_over_operator();
          operator_time =
            std::min(operator_time, seconds([&]() {
                       problem.combine(
                         Newmark<dim>().operator_coefficients(tau));
                       problem.hierarchy().take_over_operator();
                     }));
          w = 0.;
          reset_message_count();
          solve_time = std::min(solve_time, seconds([&]() {
                                  summary = solver->solve(*friction, rhs, w);
                                }));
          sent       = message_count();
        }
      solver_bytes = allocated_bytes() - bytes_before;
    }

    /** Compare with a better solution. */
    void
    compare()
    {
      TNNMGParameters parameters = SceneParameters<dim>().tnnmg;
      parameters.tolerance       = 1e-13;
      parameters.max_iterations  = 200;
      TNNMGSolver<dim> solver(problem.hierarchy(), parameters);
      NodalVector      reference = w;
      // Rounding may leave it slightly above such a tolerance.
      solver.solve(*friction, rhs, reference);
      NodalVector difference = reference, product = reference;
      const auto  energy = [&](const NodalVector &vector) {
        problem.operators().matrix().vmult(product, vector);
        return std::sqrt(std::abs(vector * product));
      };
      difference -= w;
      error = energy(difference) / energy(reference);
    }

    void
    add_row(const std::string &state)
    {
      double slowest = std::numeric_limits<double>::max(), fastest = 0;
      for (const auto &rate : faults.tangential_jumps(w))
        {
          slowest = std::min(slowest, rate.norm());
          fastest = std::max(fastest, rate.norm());
        }
      const NodePartition &nodes = problem.hierarchy().finest().nodes;
      const double         n_own = double(nodes.n_owned()) * dim;
      table.add("processes", Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
      table.add("unknowns", coupled.n_unknowns());
      table.add("bodies", scene.bodies.size());
      table.add("state", state);
      table.add("tau", tau);
      table.add("levels", coupled.meshes->n_levels());
      table.add("fault_nodes", faults.size());
      table.add("largest_share",
                double(Utilities::MPI::max(nodes.n_owned(), MPI_COMM_WORLD)) /
                  nodes.n_global());
      table.add("slowest_node", slowest);
      table.add("fastest_node", fastest);
      table.add("converged", summary.converged);
      table.add("tnnmg_iterations", summary.iterations.size());
      table.add("cycles", summary.n_cycles());
      table.add("error", error);
      table.add("meshes_s", coupled.meshes_time);
      table.add("matrices_and_contact_s", coupled.problem_time);
      table.add("contact_s", contact_time);
      table.add("equilibrium_iterations", equilibrium.iterations);
      table.add("equilibrium_s", equilibrium_time);
      table.add("operator_s", operator_time);
      table.add("solve_s", solve_time);
      table.add("messages", most(sent.messages));
      table.add("message_bytes", most(sent.message_bytes));
      table.add("sums", most(sent.sums));
      table.add("sum_bytes", most(sent.sum_bytes));
      table.add("start_MiB", memory_at_start);
      table.add("meshes_MiB", coupled.memory_of_meshes);
      table.add("largest_MiB", largest_resident_size());
      table.add("hierarchy_MiB",
                Utilities::MPI::max(problem.hierarchy().memory_consumption() /
                                      1048576.,
                                    MPI_COMM_WORLD));
      table.add("bytes_per_unknown",
                (coupled.problem_bytes + level_bytes + solver_bytes) / n_own);
      if (task.costs)
        add_costs();
      table.end_row();
    }

    /** Of the process that has sent most. */
    static std::uint64_t
    most(const std::uint64_t count)
    {
      return Utilities::MPI::max(count, MPI_COMM_WORLD);
    }

    void
    make_all_levels()
    {
      LevelHierarchy<dim> &hierarchy = problem.hierarchy();
      problem.combine(Newmark<dim>().operator_coefficients(1.));
      hierarchy.linearise(std::vector<Tensor<2, dim>>(
                            hierarchy.finest().nonsmooth_nodes.size()),
                          hierarchy.finest().fixed);
    }

    void
    add_costs()
    {
      const double assembly = coupled.assembly_time(scene.gravity_vector());
      const LinearisationCost cost =
        measure_linearisation(problem,
                              Newmark<dim>().operator_coefficients(tau));
      table.add("assembly_s", assembly);
      table.add("v_cycle_s", cost.v_cycle);
      table.add("new_tau_s", cost.new_coefficients);
      table.add("new_hessian_s", cost.new_hessians);
      table.add("new_truncation_s", cost.new_truncation);
      table.add("moved_front_s", cost.moved_front);
      table.add("new_tau_cycles", cost.new_coefficients / cost.v_cycle);
      table.add("new_hessian_cycles", cost.new_hessians / cost.v_cycle);
      table.add("new_truncation_cycles", cost.new_truncation / cost.v_cycle);
      table.add("moved_front_cycles", cost.moved_front / cost.v_cycle);
      table.add("contact_assemblies", contact_time / assembly);
    }

    SceneParameters<dim>    scene;
    const Task              task;
    const double            memory_at_start = largest_resident_size();
    CoupledProblem<dim>     coupled;
    SpatialProblem<dim>    &problem;
    InitialEquilibrium<dim> equilibrium;
    FaultNodes<dim>         faults;
    NodeLaws                laws;
    std::unique_ptr<FaultFriction<dim>> friction;
    double                              contact_time = 0, equilibrium_time = 0;
    double                              level_bytes = 0;

    /** Of the present case. */
    double       tau = 0;
    NodalVector  rhs, w;
    SolveSummary summary;
    double       error = 0, solver_bytes = 0, operator_time = 0, solve_time = 0;
    MessageCount sent;

    ResultTable table;
  };



  template <int dim>
  void
  measure(const SceneParameters<dim> &scene, Task task)
  {
    if (task.taus.empty())
      task.taus.push_back(scene.time.initial_step);
    if (task.states.empty())
      task.states.emplace_back("scene", "");
    RateProblem<dim>(scene, task).run();
  }
} // namespace



int
main(int argc, char *argv[])
{
  carry_out("rate_problem", argc, argv, [](Options &options) {
    Task task;
    task.repetitions =
      Utilities::string_to_int(options.take_value("--repetitions", "3"));
    task.without_smoother = options.take("--without-smoother");
    task.costs            = options.take("--costs");
    if (options.take("--amg"))
      task.correction = Correction::amg;
    task.taus = Utilities::string_to_double(
      Utilities::split_string_list(options.take_value("--taus", "")));
    for (std::string state = options.take_value("--state", ""); !state.empty();
         state             = options.take_value("--state", ""))
      {
                    const auto colon = state.find(':');
                    task.states.emplace_back(state.substr(0, colon),
                                 state.substr(colon + 1));
      }
    const CommandLine arguments = parse_command_line(options.rest());
    const SceneReader reader(arguments.parameter_file, arguments.overrides);
    if (reader.dimension() == 2)
      measure(reader.read<2>(), task);
    else
      measure(reader.read<3>(), task);
  });
}
