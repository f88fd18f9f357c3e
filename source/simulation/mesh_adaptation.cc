// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/base/input_error.h>
#include <stickslip/mechanics/halving_error.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/simulation/mesh_adaptation.h>
#include <stickslip/simulation/test_displacements.h>
#include <stickslip/simulation/weakening.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    using RefinedCells = std::vector<std::set<CellId>>;



    /** Smooth slip of a part of a fault, times a wave with such a wave number,
     * 1/m, along each of two axes; zero: no wave. */
    template <int dim>
    std::function<double(const Point<dim> &)>
    slip_of_patch(const std::vector<Point<dim>> &points, const double wave)
    {
      Point<dim> centre;
      for (const Point<dim> &point : points)
        centre += point / double(points.size());
      Point<dim> farthest = centre;
      for (const Point<dim> &point : points)
        if (point.distance(centre) > farthest.distance(centre))
          farthest = point;
      const double radius = farthest.distance(centre);
      if (radius == 0.)
        return [](const Point<dim> &) { return 1.; };

      const Tensor<1, dim> axis = (farthest - centre) / radius;
      return [=](const Point<dim> &point) {
        const Tensor<1, dim> arm      = point - centre;
        const double         distance = arm.norm();
        if (distance >= radius)
          return 0.;
        const double along  = arm * axis,
                     across = std::sqrt(
                       std::max(0., arm.norm_square() - along * along));
        const double envelope = std::cos(0.5 * numbers::PI * distance / radius);
        return envelope * envelope * std::cos(wave * along) *
               (dim == 3 ? std::cos(wave * across) : 1.);
      };
    }



    // Slip that varies over the process zone decides on the last moments before
    // an event only: on the spring slider an error of 0.013 moves the first
    // event by 2e-4 of its time, an error of the loading by as much as itself.
    constexpr double allowance_of_fronts = 30.;



    /** The kinds of slip that meshes shall resolve. */
    template <int dim, int n_components>
    std::vector<SlipPattern<dim>>
    slip_patterns(const SceneParameters<dim>    &scene,
                  Simulation<dim, n_components> &simulation)
    {
      const FaultNodes<dim>        &faults = simulation.fault_nodes();
      const std::vector<Point<dim>> points = simulation.fault_points();
      std::vector<SlipPattern<dim>> patterns;
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const Weakening weakening = find_weakening(scene, simulation, f);
          std::vector<Point<dim>> part;
          for (unsigned int k = faults.first_of_fault()[f];
               k < faults.first_of_fault()[f + 1];
               ++k)
            if (faults.in_contact(k) &&
                !simulation.node_laws()[k].is_prescribed &&
                (weakening.nodes[k] || !weakening.is_there()))
              part.push_back(points[k]);
          if (part.empty())
            continue;
          const std::string of_fault = " of " + scene.faults[f].name;
          patterns.push_back({f, slip_of_patch(part, 0.), "slip" + of_fault});
          if (weakening.is_there())
            patterns.push_back(
              {f,
               slip_of_patch(part, 1. / weakening.process_zone),
               "fronts" + of_fault,
               allowance_of_fronts});
        }
      return patterns;
    }



    /** Time of the fastest motion of driven sides and known slip, s, among some
     * between zero and the end of a run. */
    template <int dim, int n_components>
    double
    time_of_loads(SpatialProblem<dim, n_components> &problem,
                  const double                       end_time)
    {
      constexpr unsigned int n_times = 16;

      double fastest = 0., result = end_time;
      for (unsigned int i = n_times; i > 0; --i)
        {
          const double time     = end_time * i / n_times;
          NodalVector  velocity = problem.make_nodal_vector(),
                      jumps     = problem.make_vector();
          problem.boundary_values().set_velocities(time, velocity);
          problem.set_known_jumps(time, jumps);
          const double size = velocity.l2_norm() + jumps.l2_norm();
          if (size > fastest * (1. + 1e-6))
            {
              fastest = size;
              result  = time;
            }
        }
      return result;
    }



    /** A mesh, and the displacements on it. */
    template <int dim, int n_components>
    struct Trial
    {
      Simulation<dim, n_components> simulation;
      std::vector<TestDisplacement> displacements;

      explicit Trial(const SceneParameters<dim> &scene)
        : simulation(scene, MPI_COMM_SELF)
      {}

      const MeshLevel<dim> &
      level() const
      {
        return simulation.meshes().finest();
      }

      void
      solve(const double time, const std::vector<SlipPattern<dim>> &patterns)
      {
        displacements =
          test_displacements(simulation.spatial_problem(), time, patterns);
      }
    };



    /** The cells with children in the mesh in which all cells of another one
     * are refined once. */
    template <int dim>
    RefinedCells
    all_refined(const MeshLevel<dim> &level)
    {
      RefinedCells cells;
      for (const auto &body : level.bodies)
        {
          cells.emplace_back();
          if (!body->is_rigid())
            for (const auto &cell : body->triangulation().cell_iterators())
              cells.back().insert(cell->id());
        }
      return cells;
    }



    /** Refine the cells with the largest errors that together have a part of
     * the whole. */
    template <int dim>
    RefinedCells
    refined_where(const std::vector<std::vector<double>> &errors,
                  const MeshLevel<dim>                   &level)
    {
      constexpr double part = 0.6;

      std::vector<double> sorted;
      for (const std::vector<double> &of_body : errors)
        sorted.insert(sorted.end(), of_body.begin(), of_body.end());
      std::sort(sorted.begin(), sorted.end(), std::greater<double>());
      double whole = 0.;
      for (const double error : sorted)
        whole += error;
      // Cells of the same error, as symmetry makes them, are refined together.
      constexpr double nearly = 1. - 1e-6;
      double           least = 0., sum = 0.;
      for (unsigned int i = 0; i < sorted.size() && sum < part * whole; ++i)
        {
          sum += sorted[i];
          least = nearly * sorted[i];
        }

      RefinedCells cells;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const Triangulation<dim> &mesh = level.bodies[b]->triangulation();
          cells.push_back(refined_cells(mesh));
          for (const auto &cell : mesh.active_cell_iterators())
            if (errors[b][cell->active_cell_index()] >= least)
              cells.back().insert(cell->id());
        }
      return cells;
    }



    /** Errors relative to the energy, of the finer of two meshes, and where
     * they are too large those of cells of the coarser one. */
    struct Errors
    {
      double                           largest = 0.;
      std::vector<std::vector<double>> of_cells;
      /** Names and their errors. */
      std::ostringstream report;
    };



    template <int dim, int n_components>
    Errors
    compare(const Trial<dim, n_components>    &coarse,
            const Trial<dim, n_components>    &fine,
            const std::vector<MaterialFields> &materials,
            const double                       allowed)
    {
      // Energies of errors fall by four where cells are halved, so that a third
      // of the difference is left; at a corner between a held and a free side,
      // by 2^1.42 with nu = 0.3, and 0.6 is left.
      constexpr double left_on_fine = 0.5;

      Errors errors;
      errors.report.precision(2);
      for (unsigned int i = 0; i < fine.displacements.size(); ++i)
        {
          const TestDisplacement &on_fine = fine.displacements[i];
          const HalvingError      error =
            halving_error<dim, n_components>(coarse.level(),
                                             coarse.displacements[i].values,
                                             fine.level(),
                                             on_fine.values,
                                             materials);
          // Nothing has moved.
          if (!(error.energy > 0.))
            continue;
          const double relative = left_on_fine * error.sum / error.energy,
                       counted  = relative / on_fine.allowance;
          errors.report << (errors.report.tellp() > 0 ? ", " : "")
                        << on_fine.name << ' ' << relative;
          errors.largest = std::max(errors.largest, counted);
          errors.of_cells.resize(error.of_cells.size());
          for (unsigned int b = 0; b < error.of_cells.size(); ++b)
            {
              errors.of_cells[b].resize(error.of_cells[b].size());
              if (counted > allowed)
                for (unsigned int k = 0; k < error.of_cells[b].size(); ++k)
                  errors.of_cells[b][k] +=
                    error.of_cells[b][k] / (error.energy * on_fine.allowance);
            }
        }
      return errors;
    }



    template <int dim>
    void
    refuse_too_large(const SceneParameters<dim> &scene,
                     const double                available_memory)
    {
      constexpr double   GiB    = 1073741824.;
      const MeshEstimate meshes = estimate_meshes(scene);
      const double       memory = meshes.memory(dim, 1);
      if (memory <= available_memory)
        return;
      std::ostringstream message;
      message.precision(3);
      message << "'Mesh/Accuracy' = '" << scene.mesh_accuracy.relative_error
              << "': takes more than "
              << rounded_count(meshes.unknowns(scene.n_components()))
              << " unknowns and " << memory / GiB
              << " GiB of memory, and this machine has "
              << available_memory / GiB << " GiB.";
      throw InputError(message.str());
    }



    template <int dim, int n_components>
    void
    adapt(SceneParameters<dim> &scene,
          const double          available_memory,
          std::ostream         &out)
    {
      const double allowed = scene.mesh_accuracy.relative_error;
      const std::vector<MaterialFields> materials =
        members_of(scene.bodies, &BodyParameters<dim>::material);
      SceneParameters<dim> trial_scene = scene;

      std::vector<SlipPattern<dim>> patterns;
      double                        time = 0.;
      {
        // No trial: a start changes its problem.
        Trial<dim, n_components> start(trial_scene);
        start.simulation.set_up();
        patterns = slip_patterns(scene, start.simulation);
        time     = time_of_loads(start.simulation.spatial_problem(),
                             scene.time.end_time);
      }
      auto coarse = std::make_unique<Trial<dim, n_components>>(trial_scene);
      for (unsigned int round = 1;; ++round)
        {
          coarse->solve(time, patterns);
          trial_scene.mesh_accuracy.refined_cells =
            all_refined(coarse->level());
          refuse_too_large(trial_scene, available_memory);
          Trial<dim, n_components> fine(trial_scene);
          fine.solve(time, patterns);
          const Errors errors = compare(*coarse, fine, materials, allowed);
          if (errors.largest <= allowed || fine.displacements.empty())
            {
              scene.mesh_accuracy.refined_cells =
                trial_scene.mesh_accuracy.refined_cells;
              out << "Mesh accuracy: " << round
                  << (round == 1 ? " round" : " rounds")
                  << " of refinement, relative errors of the energy: "
                  << errors.report.str() << '.' << std::endl;
              return;
            }
          trial_scene.mesh_accuracy.refined_cells =
            refined_where(errors.of_cells, coarse->level());
          coarse = std::make_unique<Trial<dim, n_components>>(trial_scene);
        }
    }
  } // namespace



  template <int dim>
  void
  adapt_meshes(SceneParameters<dim> &scene,
               const double          available_memory,
               std::ostream         &out)
  {
    if constexpr (dim == 2)
      if (scene.deformation == Deformation::antiplane)
        {
          adapt<dim, 1>(scene, available_memory, out);
          return;
        }
    adapt<dim, dim>(scene, available_memory, out);
  }



  template decltype(adapt_meshes<2>) adapt_meshes<2>;
  template decltype(adapt_meshes<3>) adapt_meshes<3>;
} // namespace StickSlip
