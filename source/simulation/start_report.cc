// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>
#include <stickslip/friction/instability.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/scene/scene_warnings.h>
#include <stickslip/simulation/initial_balance.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/start_report.h>
#include <stickslip/simulation/weakening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    // Unknowns of the coarser scene: as many as the first where refinement
    // allows it, and less than the second where cells can be joined.
    constexpr double wanted_unknowns = 2000., many_unknowns = 20000.;

    // Meshes with more take longer than 20 s.
    template <int dim>
    constexpr double most_unknowns = dim == 2 ? 400000. : 100000.;



    /** A number in three digits. */
    std::string
    figure(const double x)
    {
      std::ostringstream text;
      text.precision(3);
      text << x;
      return text.str();
    }



    /** Make the coarse cells of all bricks twice as long; false if none can
     * be. */
    template <int dim>
    bool
    join_coarse_cells(SceneParameters<dim> &scene)
    {
      bool is_coarser = false;
      for (BodyParameters<dim> &body : scene.bodies)
        for (unsigned int &n : body.geometry.coarse_cells)
          if (n > 2)
            {
              n          = (n + 1) / 2;
              is_coarser = true;
            }
      return is_coarser;
    }



    /** The scene with as little refinement as leaves the wanted number of
     * unknowns, on longer cells or the coarsest mesh file where there are many
     * without any; null if there are too many still. */
    template <int dim>
    std::unique_ptr<SceneParameters<dim>>
    coarser_scene(const SceneParameters<dim> &scene)
    {
      auto       coarser  = std::make_unique<SceneParameters<dim>>(scene);
      const auto unknowns = [&]() {
        return estimate_meshes(*coarser).unknowns(scene.n_components());
      };
      coarser->coarser_meshes.clear();
      coarser->mesh_accuracy.refined_cells.clear();
      for (BodyParameters<dim> &body : coarser->bodies)
        body.geometry.uniform_refinements = body.geometry.refinement_passes = 0;
      if (!scene.mesh)
        while (unknowns() > many_unknowns && join_coarse_cells(*coarser))
          ;
      else if (!scene.coarser_meshes.empty() && unknowns() > many_unknowns)
        coarser->mesh = scene.coarser_meshes.back();

      // Cells that the program chooses may be refined all over.
      const unsigned int n_chosen =
        scene.mesh_accuracy.refined_cells.empty() ? 0 : 3;
      bool can_grow = true;
      while (can_grow && unknowns() < wanted_unknowns)
        {
          can_grow = false;
          for (unsigned int b = 0; b < scene.bodies.size(); ++b)
            {
              BodyGeometry<dim>       &geometry = coarser->bodies[b].geometry;
              const BodyGeometry<dim> &full     = scene.bodies[b].geometry;
              if (geometry.uniform_refinements <
                  full.uniform_refinements + n_chosen)
                ++geometry.uniform_refinements;
              else if (geometry.refinement_passes < full.refinement_passes)
                ++geometry.refinement_passes;
              else
                continue;
              can_grow = true;
            }
        }
      const double n = unknowns();
      if (n > most_unknowns<dim>)
        return nullptr;
      // A factorisation would take minutes.
      if (dim == 3 && n > many_unknowns)
        coarser->tnnmg.coarse_solver = CoarseSolverType::amg;
      return coarser;
    }



    /** Lines and warnings on the faults, from a coarser mesh. */
    class FaultOutlook
    {
    public:
      template <int dim, int n_components>
      FaultOutlook(const SceneParameters<dim>    &coarser,
                   Simulation<dim, n_components> &simulation)
      {
        simulation.set_up();
        const FaultNodes<dim> &faults = simulation.fault_nodes();
        warnings                      = what_friction_does_not_hold(coarser,
                                               faults,
                                               simulation.fault_points(),
                                               simulation.node_laws(),
                                               simulation.state());
        for (unsigned int f = 0; f < coarser.faults.size(); ++f)
          {
            balances.push_back(initial_balance(
              faults, simulation.node_laws(), simulation.state(), f));
            weakenings.push_back(find_weakening(coarser, simulation, f));
          }
      }

      /** Facts about a fault whose finest faces have this size, m. */
      std::string
      line(const unsigned int f, const double face) const
      {
        std::string      text;
        const Weakening &weakening = weakenings[f];
        if (weakening.is_there())
          text += "; where b > a, stiffness " +
                  figure(weakening.stiffness_ratio()) +
                  " of the critical one, nucleation length " +
                  figure(weakening.nucleation_length) +
                  " m = " + figure(weakening.nucleation_length / face) +
                  " faces, process zone " + figure(weakening.process_zone) +
                  " m = " + figure(weakening.process_zone / face) + " faces";
        if (balances[f].is_known)
          text += "; shear over normal stress at the start " +
                  figure(balances[f].least) + " to " +
                  figure(balances[f].greatest);
        return text;
      }

      void
      warn(const FaultParameters    &fault,
           const unsigned int        f,
           const double              face,
           std::vector<std::string> &all) const
      {
        const Weakening &weakening = weakenings[f];
        if (!weakening.is_there())
          return;
        if (weakening.stiffness_ratio() > 1.)
          all.push_back(
            "'" + fault.section() +
            "': cannot slip unstably by itself though b > a, since the stiffness "
            "of the bodies, " +
            figure(weakening.stiffness) +
            " Pa/m, is above the critical one, (b - a) sigma/L = " +
            figure(weakening.critical_stiffness) + " Pa/m.");
        else if (weakening.process_zone < least_cells_in_process_zone * face)
          all.push_back(
            "'" + fault.section() +
            "': ruptures are not resolved, since their process zone, " +
            figure(weakening.process_zone) + " m, has " +
            figure(weakening.process_zone / face) +
            " faces of the fault, and should have three or more.");
      }

      std::vector<std::string> warnings;

    private:
      std::vector<InitialBalance> balances;
      std::vector<Weakening>      weakenings;
    };



    template <int dim, int n_components>
    std::unique_ptr<FaultOutlook>
    look_at(const SceneParameters<dim> &coarser)
    {
      Simulation<dim, n_components> simulation(coarser, MPI_COMM_SELF);
      return std::make_unique<FaultOutlook>(coarser, simulation);
    }



    /** Null if the coarser mesh tells nothing; input that is refused there is
     * said in @p refusal. */
    template <int dim>
    std::unique_ptr<FaultOutlook>
    make_outlook(const SceneParameters<dim> &scene,
                 std::vector<std::string>   &warnings,
                 std::string                &refusal)
    {
      if (scene.faults.empty())
        return nullptr;
      const auto coarser = coarser_scene(scene);
      if (!coarser)
        return nullptr;
      try
        {
          std::unique_ptr<FaultOutlook> outlook;
          if constexpr (dim == 2)
            if (scene.deformation == Deformation::antiplane)
              outlook = look_at<dim, 1>(*coarser);
          if (!outlook)
            outlook = look_at<dim, dim>(*coarser);
          warnings.insert(warnings.end(),
                          outlook->warnings.begin(),
                          outlook->warnings.end());
          return outlook;
        }
      catch (const InputError &error)
        {
          refusal = error.what();
          return nullptr;
        }
      catch (const std::exception &error)
        {
          warnings.push_back("The start on a coarser mesh has failed: " +
                             sentence(error));
          return nullptr;
        }
    }



    std::string
    plural(const double n, const std::string &one, const std::string &several)
    {
      return rounded_count(n) + " " + (n == 1. ? one : several);
    }
  } // namespace



  template <int dim>
  std::string
  report_start(const SceneParameters<dim>     &scene,
               const unsigned int              n_processes,
               const std::vector<std::string> &more_warnings,
               std::ostream                   &out)
  {
    const MeshEstimate       meshes   = estimate_meshes(scene);
    std::vector<std::string> warnings = more_warnings;
    for (const std::string &warning : scene_warnings(scene, meshes))
      warnings.push_back(warning);
    std::string refusal;
    const auto  outlook = make_outlook(scene, warnings, refusal);

    out << "Meshes: " << plural(scene.bodies.size(), "body", "bodies")
        << ", about " << rounded_count(meshes.cells) << " cells, "
        << rounded_count(meshes.unknowns(scene.n_components())) << " unknowns, "
        << plural(meshes.levels, "level", "levels") << ", "
        << rounded_count(meshes.memory(dim, n_processes) / 1048576.)
        << " MiB of memory.\n";
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const MeshEstimate::OfFault &fault = meshes.faults[f];
        out << "Fault " << scene.faults[f].name << ": " << figure(fault.size)
            << (dim == 2 ? " m" : " m^2") << " in "
            << plural(fault.faces, "face", "faces") << " of up to "
            << figure(fault.largest_edge) << " m"
            << (fault.is_refined_in_part ? " where they are refined" : "")
            << (outlook ? outlook->line(f, fault.largest_edge) : "") << ".\n";
        if (outlook)
          outlook->warn(scene.faults[f], f, fault.largest_edge, warnings);
      }
    const FewestOutputs fewest(scene.time, scene.output);
    out << "Time: " << figure(scene.time.end_time) << " s in at least "
        << plural(std::ceil(fewest.steps), "step", "steps")
        << ", with at least "
        << plural(std::ceil(fewest.fault_records), "record", "records")
        << " of the faults and "
        << plural(std::ceil(fewest.volume_sets), "set", "sets")
        << " of VTU files.\n";
    for (const std::string &warning : warnings)
      out << "Warning: " << warning << '\n';
    out << std::flush;
    return refusal;
  }



  template std::string
  report_start(const SceneParameters<2> &,
               const unsigned int,
               const std::vector<std::string> &,
               std::ostream &);
  template std::string
  report_start(const SceneParameters<3> &,
               const unsigned int,
               const std::vector<std::string> &,
               std::ostream &);
} // namespace StickSlip
