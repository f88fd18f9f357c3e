// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_coupled_problem_h
#define stickslip_contrib_coupled_problem_h

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/scene/scene_parameters.h>

#include "measurement.h"

namespace Measure
{
  using namespace StickSlip;

  /**
   * A scene in space as the program builds it, with what each part takes.
   */
  template <int dim>
  struct CoupledProblem
  {
    explicit CoupledProblem(const SceneParameters<dim> &scene)
    {
      std::vector<std::string> names;
      for (const BodyParameters<dim> &body : scene.bodies)
        {
          materials.push_back(body.material);
          names.push_back(body.name);
        }
      const double bytes_at_start = allocated_bytes();
      meshes_time                 = seconds([&]() {
        meshes = std::make_unique<MeshHierarchy<dim>>(scene.coarse_bodies(),
                                                      scene.topology,
                                                      MPI_COMM_WORLD);
        boundary =
          std::make_unique<BoundaryValues<dim>>(*meshes,
                                                scene.boundary_conditions,
                                                names);
      });
      memory_of_meshes            = largest_resident_size();
      mesh_bytes                  = allocated_bytes() - bytes_at_start;
      problem_time                = seconds([&]() {
        problem = std::make_unique<SpatialProblem<dim>>(*meshes,
                                                        materials,
                                                        *boundary,
                                                        scene.gravity_vector());
      });
      problem_bytes = allocated_bytes() - bytes_at_start - mesh_bytes;
    }

    /** The time that assembly alone takes, s. */
    double
    assembly_time(const Tensor<1, dim> &gravity) const
    {
      return seconds([&]() {
        assemble_elastic_matrices(meshes->finest(), materials);
        assemble_gravity(meshes->finest(), materials, gravity);
      });
    }

    /** Vector entries on all processes. */
    types::global_dof_index
    n_unknowns() const
    {
      return problem->hierarchy().finest().nodes.n_global() * dim;
    }

    std::vector<MaterialFields>          materials;
    std::unique_ptr<MeshHierarchy<dim>>  meshes;
    std::unique_ptr<BoundaryValues<dim>> boundary;
    std::unique_ptr<SpatialProblem<dim>> problem;

    /** s. The second is that of matrices, contact mapping and levels. */
    double meshes_time = 0, problem_time = 0;

    /** MiB of the largest process. */
    double memory_of_meshes = 0;

    /** Of this process. */
    double mesh_bytes = 0, problem_bytes = 0;
  };
} // namespace Measure

#endif
