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
    /** Call @p visit(cells, patch) on each patch of a body that touches an
     * owned node; without moduli if there are no @p materials. */
    template <int dim, typename Visitor>
    void
    visit_patches(const MeshLevel<dim>              &level,
                  const unsigned int                 body,
                  const std::vector<MaterialFields> &materials,
                  const Visitor                     &visit)
    {
      const IndexSet           &owned       = level.nodes.owned();
      const DoFHandler<dim>    &dof_handler = level.bodies[body]->dof_handler();
      const FiniteElement<dim> &fe          = dof_handler.get_fe();
      FEValues<dim>             fe_values(
        fe,
        fe.reference_cell().template get_gauss_type_quadrature<dim>(fe.degree +
                                                                    1),
        with_points(update_gradients | update_JxW_values, materials));
      MaterialsOfCell<dim> at(materials);

      const auto is_touched = [&](const auto &cell) {
        for (const auto v : cell->vertex_indices())
          for (const auto &[node, weight] :
               level.resolve(body, cell->vertex_dof_index(v, 0)))
            if (owned.is_element(node))
              return true;
        return false;
      };
      level.bodies[body]->patches().for_each(
        dof_handler, [&](const auto &cells) {
          if (std::none_of(cells.begin(), cells.end(), is_touched))
            return;
          PatchVolume<dim>                                  patch;
          std::map<types::global_dof_index, Tensor<1, dim>> gradients;
          for (const auto &cell : cells)
            {
              fe_values.reinit(cell);
              for (const double JxW : fe_values.get_JxW_values())
                patch.volume += JxW;
              if (!materials.empty())
                {
                  at.reinit(body, fe_values);
                  for (const unsigned int q :
                       fe_values.quadrature_point_indices())
                    {
                      const double    JxW      = fe_values.JxW(q);
                      const Material &material = at[q];
                      patch.bulk_modulus += JxW * material.bulk_modulus();
                      patch.shear_modulus += JxW * material.shear_modulus();
                      patch.bulk_viscosity += JxW * material.bulk_viscosity;
                      patch.shear_viscosity += JxW * material.shear_viscosity;
                    }
                }
              for (const auto i : cell->vertex_indices())
                {
                  Tensor<1, dim> gradient;
                  for (const unsigned int q :
                       fe_values.quadrature_point_indices())
                    gradient += fe_values.shape_grad(i, q) * fe_values.JxW(q);
                  for (const auto &[node, weight] :
                       level.resolve(body, cell->vertex_dof_index(i, 0)))
                    gradients[node] += weight * gradient;
                }
            }
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
          visit(cells, patch);
        });
    }
  } // namespace



  template <int dim>
  std::vector<PatchVolume<dim>>
  patch_volumes(const MeshLevel<dim>              &level,
                const std::vector<MaterialFields> &materials)
  {
    std::vector<PatchVolume<dim>> result;
    for (unsigned int body = 0; body < level.bodies.size(); ++body)
      if (!level.bodies[body]->is_rigid() &&
          materials[body].volumetric_strain == VolumetricStrain::patch_mean)
        visit_patches(level,
                      body,
                      materials,
                      [&](const auto &, const PatchVolume<dim> &patch) {
                        result.push_back(patch);
                      });
    return result;
  }



  template <int dim>
  std::vector<double>
  patch_dilatations(const MeshLevel<dim> &level,
                    const unsigned int    body,
                    const NodalVector    &displacement)
  {
    std::vector<double> result;
    if (level.bodies[body]->patches().are_single())
      return result;
    update_ghosts(displacement);
    result.resize(level.bodies[body]->triangulation().n_active_cells());
    visit_patches(
      level, body, {}, [&](const auto &cells, const PatchVolume<dim> &patch) {
        double change = 0.;
        for (const auto &[node, gradient] : patch.gradients)
          for (unsigned int c = 0; c < dim; ++c)
            change += gradient[c] * displacement.local_element(node * dim + c);
        for (const auto &cell : cells)
          result[cell->active_cell_index()] = change / patch.volume;
      });
    return result;
  }



  template std::vector<double>
  patch_dilatations<2>(const MeshLevel<2> &,
                       const unsigned int,
                       const NodalVector &);
  template std::vector<double>
  patch_dilatations<3>(const MeshLevel<3> &,
                       const unsigned int,
                       const NodalVector &);
  template std::vector<PatchVolume<2>>
  patch_volumes<2>(const MeshLevel<2> &, const std::vector<MaterialFields> &);
  template std::vector<PatchVolume<3>>
  patch_volumes<3>(const MeshLevel<3> &, const std::vector<MaterialFields> &);
} // namespace StickSlip
