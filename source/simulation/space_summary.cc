// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/simulation/space_summary.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  namespace
  {
    struct MeshFigures
    {
      unsigned int n_vertices = 0, n_cells = 0;
      double       smallest = std::numeric_limits<double>::max(), largest = 0;

      void
      add_to(RunSummary &summary, const std::string &section) const
      {
        summary.add_count(section, "vertices", n_vertices);
        summary.add_count(section, "cells", n_cells);
        summary.add(section, "smallest cell diameter", smallest, "m");
        summary.add(section, "largest cell diameter", largest, "m");
      }
    };
  } // namespace



  template <int dim>
  void
  summarise_meshes(RunSummary                     &summary,
                   const MeshHierarchy<dim>       &meshes,
                   const std::vector<std::string> &body_names)
  {
    MeshFigures           all;
    const MeshLevel<dim> &finest = meshes.finest();
    for (unsigned int i = 0; i < finest.bodies.size(); ++i)
      {
        const auto &mesh      = finest.bodies[i]->triangulation();
        const auto  diameters = finest.bodies[i]->cell_diameters();
        MeshFigures one;
        one.n_vertices = mesh.n_used_vertices();
        one.n_cells    = mesh.n_active_cells();
        one.smallest   = diameters.first;
        one.largest    = diameters.second;
        one.add_to(summary, "Mesh of body " + body_names[i]);

        all.n_vertices += one.n_vertices;
        all.n_cells += one.n_cells;
        all.smallest = std::min(all.smallest, one.smallest);
        all.largest  = std::max(all.largest, one.largest);
      }
    all.add_to(summary, "Mesh of all bodies");
    summary.add_count("Mesh of all bodies", "levels", meshes.n_levels());
  }



  template <int dim>
  void
  summarise_problem(RunSummary                     &summary,
                    const SpatialProblem<dim>      &problem,
                    const std::vector<std::string> &body_names,
                    const std::vector<std::string> &fault_names)
  {
    const LevelDescription<dim> &level = problem.hierarchy().finest();
    const auto                   n_all = level.nodes.n_global() * dim;
    summary.add_count("Unknowns", "all", n_all);
    summary.add_count("Unknowns",
                      "not fixed",
                      n_all - Utilities::MPI::sum(level.fixed.n_masked(
                                                    level.nodes.n_owned()),
                                                  level.nodes.communicator()));
    for (unsigned int f = 0; f < fault_names.size(); ++f)
      {
        const FaultContact<dim> &contact = problem.jump_basis().faults()[f];
        const std::string        section = "Fault " + fault_names[f];
        summary.add_count(section, "nodes", contact.slave_nodes.size());
        std::string slave_bodies;
        for (const BodySide &part :
             problem.meshes().topology().faults()[f].sides[contact.sides.slave])
          slave_bodies +=
            (slave_bodies.empty() ? "" : ", ") + body_names[part.body];
        summary.add(section, "slave body", slave_bodies);
        summary.add(section,
                    "area in contact",
                    contact.coupling.covered_area,
                    dim == 2 ? "m" : "m^2");
      }
  }



#define STICKSLIP_INSTANTIATE(dim)                                       \
  template void summarise_meshes<dim>(RunSummary &,                      \
                                      const MeshHierarchy<dim> &,        \
                                      const std::vector<std::string> &); \
  template void summarise_problem<dim>(RunSummary &,                     \
                                       const SpatialProblem<dim> &,      \
                                       const std::vector<std::string> &, \
                                       const std::vector<std::string> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
