// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreement.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_checks.h>
#include <stickslip/simulation/checked_scene.h>

namespace StickSlip
{
  template <int dim>
  const SceneParameters<dim> &
  checked_scene(const SceneParameters<dim> &scene, const MPI_Comm &communicator)
  {
    check_process_count(scene, Utilities::MPI::n_mpi_processes(communicator));
    return scene;
  }



  template <int dim>
  std::vector<MaterialFields>
  checked_materials(const SceneParameters<dim> &scene,
                    const MeshHierarchy<dim>   &meshes,
                    const MPI_Comm             &communicator)
  {
    const std::vector<MaterialFields> materials =
      members_of(scene.bodies, &BodyParameters<dim>::material);
    carry_out_agreed(communicator,
                     [&]() { check_materials(meshes.finest(), materials); });
    return materials;
  }



#define STICKSLIP_INSTANTIATE(dim)                             \
  template const SceneParameters<dim> &checked_scene<dim>(     \
    const SceneParameters<dim> &, const MPI_Comm &);           \
  template std::vector<MaterialFields> checked_materials<dim>( \
    const SceneParameters<dim> &,                              \
    const MeshHierarchy<dim> &,                                \
    const MPI_Comm &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
