// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/mesh/coarser_mesh.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/coarser_mesh_files.h>

namespace StickSlip
{
  template <int dim>
  std::vector<std::shared_ptr<const CutMesh<dim>>>
  read_coarser_meshes(const MeshEntries              &entries,
                      const std::vector<std::string> &body_names,
                      const std::vector<std::string> &fault_names,
                      const CutMesh<dim>             &mesh)
  {
    std::vector<std::shared_ptr<const CutMesh<dim>>> meshes;
    for (const std::string &names :
         Utilities::split_string_list(entries.coarser_files, ','))
      try
        {
          MeshEntries of_mesh = entries;
          of_mesh.files = join_names(Utilities::split_string_list(names, '+'));
          const auto coarser = std::make_shared<CutMesh<dim>>(
            read_meshes<dim>(of_mesh, body_names, fault_names));
          match_to_finer(meshes.empty() ? mesh : *meshes.back(), *coarser);
          meshes.push_back(coarser);
        }
      catch (const InputError &error)
        {
          throw InputError("'Bodies/Coarser mesh files', '" + names +
                           "': " + error.what());
        }
    return meshes;
  }



  template std::vector<std::shared_ptr<const CutMesh<2>>>
  read_coarser_meshes(const MeshEntries &,
                      const std::vector<std::string> &,
                      const std::vector<std::string> &,
                      const CutMesh<2> &);
  template std::vector<std::shared_ptr<const CutMesh<3>>>
  read_coarser_meshes(const MeshEntries &,
                      const std::vector<std::string> &,
                      const std::vector<std::string> &,
                      const CutMesh<3> &);
} // namespace StickSlip
