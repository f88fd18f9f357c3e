// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>

#include <stickslip/mechanics/strain_energy.h>

namespace StickSlip
{
  template <int dim, int n_components>
  StrainEnergy<dim, n_components>::StrainEnergy(
    const MeshLevel<dim>              &level,
    const std::vector<MaterialFields> &materials)
    : materials(materials)
  {
    for (const auto &body : level.bodies)
      {
        const FiniteElement<dim> &fe = body->dof_handler().get_fe();
        values_of_body.push_back(std::make_unique<FEValues<dim>>(
          fe,
          fe.reference_cell().template get_gauss_type_quadrature<dim>(
            fe.degree + 1),
          with_points(update_gradients | update_JxW_values, materials)));
      }
  }



  template <int dim, int n_components>
  double
  StrainEnergy<dim, n_components>::operator()(
    const unsigned int                                          body,
    const std::vector<typename DoFHandler<dim>::cell_iterator> &cells,
    const std::vector<std::vector<Tensor<1, n_components>>>    &displacements)
  {
    FEValues<dim> &fe_values = *values_of_body[body];
    double energy = 0., volume = 0., volume_change = 0., bulk_modulus = 0.;
    bool   is_mean = false;
    for (unsigned int k = 0; k < cells.size(); ++k)
      {
        fe_values.reinit(
          static_cast<const typename Triangulation<dim>::cell_iterator &>(
            cells[k]));
        materials.reinit(body, fe_values);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const Material &material = materials[q];
            const double JxW = fe_values.JxW(q), mu = material.shear_modulus();
            if constexpr (n_components == 1)
              {
                // Shear out of the plane.
                Tensor<1, dim> gradient;
                for (unsigned int i = 0; i < displacements[k].size(); ++i)
                  gradient +=
                    displacements[k][i][0] * fe_values.shape_grad(i, q);
                energy += 0.5 * mu * gradient.norm_square() * JxW;
              }
            else
              {
                Tensor<2, dim> gradient;
                for (unsigned int i = 0; i < displacements[k].size(); ++i)
                  gradient += outer_product(displacements[k][i],
                                            fe_values.shape_grad(i, q));
                const Tensor<2, dim> strain =
                  0.5 * (gradient + transpose(gradient));
                const double dilatation = trace(strain);
                is_mean =
                  material.volumetric_strain == VolumetricStrain::patch_mean;
                // The deviator is that of three dimensions.
                const double lambda =
                  is_mean ? -2. * mu / 3. : material.lame_lambda();
                energy += (0.5 * lambda * dilatation * dilatation +
                           mu * strain.norm_square()) *
                          JxW;
                volume += JxW;
                volume_change += dilatation * JxW;
                bulk_modulus += material.bulk_modulus() * JxW;
              }
          }
      }
    if (is_mean)
      energy +=
        0.5 * bulk_modulus * volume_change * volume_change / (volume * volume);
    return energy;
  }



  template class StrainEnergy<2>;
  template class StrainEnergy<3>;
  template class StrainEnergy<2, 1>;
} // namespace StickSlip
