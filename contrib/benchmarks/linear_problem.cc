// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * linear_problem FILE.prm [--set ENTRY=VALUE]... [--solvers NAMES]
 *                [--repetitions N] [--times-only]
 *
 * Measures the linear limit of a rate problem: the operator of the scene's
 * first time step, of size Time/Initial step, with the faults welded, under
 * gravity, tractions and an acceleration that changes from node to node. NAMES
 * are some of
 *
 *   geometric   CG with the geometric multigrid method of deal.II
 *   algebraic   CG with ML of Trilinos
 *   coupled     CG with the V-cycle of this program
 *   tnnmg       TNNMG with its own criterion to stop
 *   umfpack, mumps
 *
 * separated by commas; those with CG take as many steps as an error of 1e-8 in
 * the energy norm takes, relative to the solution. The solvers take turns, and
 * the shortest time of each counts. Prints a row for each. Bytes are what is
 * allocated for matrices and preconditioner, without the meshes; the error is
 * that in the energy norm, relative to the solution; cross_check is the
 * difference between the solutions of both discretisations in the same norm.
 * --times-only leaves these out.
 */

#include <stickslip/scene/command_line.h>
#include <stickslip/scene/scene_reader.h>

#include "coupled_limit.h"
#include "welded_limit.h"

namespace
{
  using namespace Measure;

  template <int dim>
  void
  measure(const SceneParameters<dim> &scene,
          const std::string          &solvers,
          const unsigned int          repetitions,
          const bool                  times_only)
  {
    std::unique_ptr<CoupledLimit<dim>> coupled;
    std::unique_ptr<WeldedLimit<dim>>  welded;
    std::vector<Method>                methods;
    for (const std::string &name : Utilities::split_string_list(solvers))
      {
        if (name == "coupled" || name == "tnnmg")
          {
            if (!coupled)
              coupled = std::make_unique<CoupledLimit<dim>>(scene);
            methods.push_back(name == "tnnmg" ?
                                coupled->tnnmg_method() :
                                coupled->conjugate_gradients_method());
            continue;
          }
        if (!welded)
          welded = std::make_unique<WeldedLimit<dim>>(scene);
        if (name == "geometric")
          methods.push_back(welded->geometric_method());
        else if (name == "algebraic")
          methods.push_back(welded->algebraic_method());
        else if (name == "umfpack")
          methods.push_back(welded->umfpack_method());
        else if (name == "mumps")
          methods.push_back(welded->mumps_method());
        else
          AssertThrow(false, ExcMessage("There is no solver " + name + "."));
      }

    for (Method &method : methods)
      method.prepare();
    // In turns: what else the machine does meets all of them.
    for (unsigned int repetition = 0; repetition < repetitions; ++repetition)
      for (Method &method : methods)
        if (repetition < method.repetitions)
          method.solve_s =
            std::min(method.solve_s,
                     seconds([&]() { method.iterations = method.solve(); }));

    const double cross_check =
      welded && coupled && !times_only ? welded->difference(*coupled) : 0.;
    ResultTable table;
    for (Method &method : methods)
      {
        // Methods for the coupled problem share their solution.
        if (!times_only && (method.name == "coupled" || method.name == "tnnmg"))
          method.solve();
        table.add("solver", method.name);
        table.add("unknowns", method.unknowns);
        table.add("tau", scene.time.initial_step);
        table.add("iterations", method.iterations.first);
        table.add("cycles", method.iterations.second);
        table.add("meshes_s", method.meshes_s);
        table.add("assembly_s", method.assembly_s);
        table.add("preconditioner_s", method.preconditioner_s);
        table.add("solve_s", method.solve_s);
        table.add("mesh_bytes_per_unknown",
                  method.mesh_bytes / method.unknowns);
        table.add("bytes_per_unknown", method.bytes / method.unknowns);
        if (!times_only)
          {
            table.add("error", method.error());
            table.add("cross_check", cross_check);
          }
        table.add("largest_MiB", largest_resident_size());
        table.end_row();
      }
    table.print();
  }
} // namespace



int
main(int argc, char *argv[])
{
  carry_out("linear_problem", argc, argv, [](Options &options) {
    const std::string solvers =
      options.take_value("--solvers", "geometric,coupled,tnnmg,algebraic");
    const unsigned int repetitions =
      Utilities::string_to_int(options.take_value("--repetitions", "3"));
    const bool times_only = options.take("--times-only");
    AssertThrow(Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1,
                ExcMessage("This is for one process."));
    const CommandLine arguments = parse_command_line(options.rest());
    const SceneReader reader(arguments.parameter_file, arguments.overrides);
    if (reader.dimension() == 2)
      measure(reader.read<2>(), solvers, repetitions, times_only);
    else
      measure(reader.read<3>(), solvers, repetitions, times_only);
  });
}
