// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <stickslip/mechanics/materials_of_cell.h>
#include <stickslip/mechanics/patch_volumes.h>

#include <algorithm>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** Add what a cell has, by global numbers of the nodes; moduli times
     * volumes. */
    template <int dim, typename Cell>
    void
    add_cell(const MeshLevel<dim>                              &level,
             const unsigned int                                 body,
             const Cell                                        &cell,
             FEValues<dim>                                     &fe_values,
             MaterialsOfCell<dim>                              &at,
             PatchVolume<dim>                                  &patch,
             std::map<types::global_dof_index, Tensor<1, dim>> &gradients)
    {
      fe_values.reinit(cell);
      at.reinit(body, fe_values);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          const double    JxW      = fe_values.JxW(q);
          const Material &material = at[q];
          patch.volume += JxW;
          patch.bulk_modulus += JxW * material.bulk_modulus();
          patch.shear_modulus += JxW * material.shear_modulus();
          patch.bulk_viscosity += JxW * material.bulk_viscosity;
          patch.shear_viscosity += JxW * material.shear_viscosity;
        }
      for (const auto i : cell->vertex_indices())
        {
          Tensor<1, dim> gradient;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            gradient += fe_values.shape_grad(i, q) * fe_values.JxW(q);
          for (const auto &[node, weight] :
               level.resolve(body, cell->vertex_dof_index(i, 0)))
            gradients[node] += weight * gradient;
        }
    }
  } // namespace



  template <int dim>
  void
  for_each_patch_volume(
    const MeshLevel<dim>                                &level,
    const std::vector<MaterialFields>                   &materials,
    const std::function<void(const PatchVolume<dim> &)> &visit)
  {
    const IndexSet      &owned = level.nodes.owned();
    MaterialsOfCell<dim> at(materials);
    for (unsigned int body = 0; body < level.bodies.size(); ++body)
      {
        if (level.bodies[body]->is_rigid() ||
            materials[body].volumetric_strain != VolumetricStrain::patch_mean)
          continue;
        const DoFHandler<dim>    &dof_handler = level.bodies[body]->dof_handler();
        const FiniteElement<dim> &fe          = dof_handler.get_fe();
        FEValues<dim>             fe_values(
          fe,
          fe.reference_cell().template get_gauss_type_quadrature<dim>(
            fe.degree + 1),
          with_points(update_gradients | update_JxW_values, materials));
        level.bodies[body]->patches().for_each(
          dof_handler, [&](const auto &cells) {
            const auto is_touched = [&](const auto &cell) {
              for (const auto v : cell->vertex_indices())
                for (const auto &[node, weight] :
                     level.resolve(body, cell->vertex_dof_index(v, 0)))
                  if (owned.is_element(node))
                    return true;
              return false;
            };
            if (std::none_of(cells.begin(), cells.end(), is_touched))
              return;
            PatchVolume<dim>                                  patch;
            std::map<types::global_dof_index, Tensor<1, dim>> gradients;
            for (const auto &cell : cells)
              add_cell(level, body, cell, fe_values, at, patch, gradients);
            for (double *mean : {&patch.bulk_modulus,
                                 &patch.shear_modulus,
                                 &patch.bulk_viscosity,
                                 &patch.shear_viscosity})
              *mean /= patch.volume;
            for (const auto &[node, gradient] : gradients)
              patch.gradients.emplace_back(level.nodes.local_index(node),
                                           gradient);
            std::sort(patch.gradients.begin(),
                      patch.gradients.end(),
                      [](const auto &a, const auto &b) {
                        return a.first < b.first;
                      });
            visit(patch);
          });
      }
  }



  template void
  for_each_patch_volume<2>(
    const MeshLevel<2> &,
    const std::vector<MaterialFields> &,
    const std::function<void(const PatchVolume<2> &)> &);
  template void
  for_each_patch_volume<3>(
    const MeshLevel<3> &,
    const std::vector<MaterialFields> &,
    const std::function<void(const PatchVolume<3> &)> &);
} // namespace StickSlip
