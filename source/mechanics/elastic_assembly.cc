// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/mechanics/materials_of_cell.h>
#include <stickslip/mechanics/patch_volumes.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Bodies count as nearly incompressible from there on, about nu = 0.47. */
    constexpr double largest_vortex_ratio = 0.1;

    /** The local nodes and weights to which a degree of freedom is bound. */
    using LocalRow = std::vector<std::pair<unsigned int, double>>;



    /**
     * Call @p visit(body, FEValues, rows) on each cell of a body that deforms
     * and that touches an owned node, with the nodes that its degrees of
     * freedom are bound to.
     */
    template <int dim, typename Visitor>
    void
    for_each_cell(const MeshLevel<dim> &level,
                  const UpdateFlags     flags,
                  const Visitor        &visit)
    {
      const IndexSet &owned = level.nodes.owned();
      for (unsigned int body = 0; body < level.bodies.size(); ++body)
        {
          if (level.bodies[body]->is_rigid())
            continue;
          const DoFHandler<dim> &dof_handler =
            level.bodies[body]->dof_handler();
          const FiniteElement<dim> &fe = dof_handler.get_fe();
          const Quadrature<dim>     quadrature =
            fe.reference_cell().template get_gauss_type_quadrature<dim>(
              fe.degree + 1);
          FEValues<dim> fe_values(fe, quadrature, flags | update_JxW_values);
          std::vector<types::global_dof_index> dofs(fe_values.dofs_per_cell);
          std::vector<GlobalRow>               bound(fe_values.dofs_per_cell);
          std::vector<LocalRow>                rows(fe_values.dofs_per_cell);
          for (const auto &cell : dof_handler.active_cell_iterators())
            {
              cell->get_dof_indices(dofs);
              bool touches_owned = false;
              for (unsigned int i = 0; i < dofs.size(); ++i)
                {
                  bound[i] = level.resolve(body, dofs[i]);
                  for (const auto &node : bound[i])
                    touches_owned |= owned.is_element(node.first);
                }
              if (!touches_owned)
                continue;
              for (unsigned int i = 0; i < dofs.size(); ++i)
                {
                  rows[i].clear();
                  for (const auto &node : bound[i])
                    rows[i].emplace_back(level.nodes.local_index(node.first),
                                         node.second);
                }
              fe_values.reinit(cell);
              visit(body, fe_values, rows);
            }
        }
    }



    template <int dim>
    std::shared_ptr<const BlockSparsity>
    make_sparsity(const MeshLevel<dim>                &level,
                  const std::vector<PatchVolume<dim>> &patches)
    {
      std::vector<std::vector<unsigned int>> couplings(level.nodes.n_owned());
      for_each_cell(level,
                    update_default,
                    [&](const unsigned int,
                        const FEValues<dim> &,
                        const std::vector<LocalRow> &rows) {
                      for (const auto &row_i : rows)
                        for (const auto &row_j : rows)
                          for (const auto &i : row_i)
                            if (i.first < couplings.size())
                              for (const auto &j : row_j)
                                couplings[i.first].push_back(j.first);
                    });
      for (const PatchVolume<dim> &patch : patches)
        for (const auto &i : patch.gradients)
          if (i.first < couplings.size())
            for (const auto &j : patch.gradients)
              couplings[i.first].push_back(j.first);
      return std::make_shared<const BlockSparsity>(std::move(couplings));
    }



    /**
     * The block of an isotropic form 2 mu eps(u):eps(v) + lambda div u div v
     * for the shape functions with gradients @p gi (test) and @p gj.
     */
    template <int n_components, int dim>
    Tensor<2, n_components>
    isotropic_block(const double          lambda,
                    const double          mu,
                    const Tensor<1, dim> &gi,
                    const Tensor<1, dim> &gj)
    {
      Tensor<2, n_components> block;
      for (unsigned int c = 0; c < n_components; ++c)
        {
          // Displacements out of the plane change no volume.
          for (unsigned int d = 0; d < n_components && n_components == dim; ++d)
            block[c][d] = lambda * gi[c] * gj[d] + mu * gi[d] * gj[c];
          block[c][c] += mu * (gi * gj);
        }
      return block;
    }



    /** The moduli of isotropic_block() at a point. */
    struct Moduli
    {
      double lambda, mu, viscous_lambda, eta;
    };



    /**
     * The deviator is that of three dimensions, in plane strain too. What
     * resists a change of volume either joins it, in the form of Lame's first
     * parameter, or acts on the mean over a patch of cells.
     */
    Moduli
    moduli(const Material &material)
    {
      Moduli result;
      result.mu             = material.shear_modulus();
      result.eta            = material.shear_viscosity;
      result.lambda         = -2. * result.mu / 3.;
      result.viscous_lambda = -2. * result.eta / 3.;
      if (material.volumetric_strain == VolumetricStrain::full)
        {
          result.lambda = material.lame_lambda();
          result.viscous_lambda += material.bulk_viscosity;
        }
      return result;
    }



    template <int n_components>
    void
    add(BlockMatrix<n_components>     &matrix,
        const LocalRow                &row_i,
        const LocalRow                &row_j,
        const Tensor<2, n_components> &value)
    {
      for (const auto &i : row_i)
        for (const auto &j : row_j)
          {
            // The owner of a ghost adds this to its row.
            if (i.first >= matrix.n_rows())
              continue;
            double *block =
              matrix.block(matrix.sparsity().position(i.first, j.first));
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int d = 0; d < n_components; ++d)
                block[c * n_components + d] +=
                  i.second * j.second * value[c][d];
          }
    }



    /** The stiffness of a vortex, which keeps the volumes of patches, over that
     * of other motions of nodes, about: 2 mu / (kappa + 7/3 mu). */
    double
    vortex_ratio(const double bulk, const double shear)
    {
      return bulk > 0. ? 2. * shear / (bulk + 7. / 3. * shear) : 1.;
    }



    /** Add what resists the mean changes of volume of patches. */
    template <int dim>
    void
    add_patch_volumes(const std::vector<PatchVolume<dim>> &patches,
                      BlockMatrix<dim>                    &stiffness,
                      BlockMatrix<dim>                    &damping,
                      ElasticMatrices<dim>                &result)
    {
      std::vector<bool> is_stiff(stiffness.n_rows(), false),
        is_viscous(stiffness.n_rows(), false);
      for (const PatchVolume<dim> &patch : patches)
        {
          const auto add_to = [&](BlockMatrix<dim> &matrix,
                                  const double      modulus) {
            for (const auto &[i, gradient_i] : patch.gradients)
              if (i < matrix.n_rows())
                for (const auto &[j, gradient_j] : patch.gradients)
                  {
                    double *block =
                      matrix.block(matrix.sparsity().position(i, j));
                    for (unsigned int c = 0; c < dim; ++c)
                      for (unsigned int d = 0; d < dim; ++d)
                        block[c * dim + d] += modulus / patch.volume *
                                              gradient_i[c] * gradient_j[d];
                  }
          };
          add_to(stiffness, patch.bulk_modulus);
          if (patch.bulk_viscosity > 0.)
            add_to(damping, patch.bulk_viscosity);

          const double elastic =
                         vortex_ratio(patch.bulk_modulus, patch.shear_modulus),
                       viscous = vortex_ratio(patch.bulk_viscosity,
                                              patch.shear_viscosity);
          if (std::min(elastic, viscous) <= largest_vortex_ratio)
            for (const auto &[i, gradient] : patch.gradients)
              if (i < is_stiff.size())
                (elastic <= viscous ? is_stiff : is_viscous)[i] = true;
        }
      for (unsigned int i = 0; i < is_stiff.size(); ++i)
        if (is_stiff[i])
          result.stiff_volumes.push_back(i);
        else if (is_viscous[i])
          result.viscous_volumes.push_back(i);
    }
  } // namespace



  template <int dim, int n_components>
  ElasticMatrices<n_components>
  assemble_elastic_matrices(const MeshLevel<dim>              &level,
                            const std::vector<MaterialFields> &materials,
                            const bool                         with_mass)
  {
    // Displacements out of the plane change no volume.
    const std::vector<PatchVolume<dim>> patches =
      n_components == dim ? patch_volumes(level, materials) :
                            std::vector<PatchVolume<dim>>();
    const auto sparsity     = make_sparsity(level, patches);
    bool       with_damping = false;
    for (unsigned int b = 0; b < materials.size(); ++b)
      with_damping |= !level.bodies[b]->is_rigid() && materials[b].is_viscous();
    // Masses of all components are the same: a number a pair of nodes.
    BlockMatrix<1>            masses;
    BlockMatrix<n_components> stiffnesses(sparsity), dampings;
    if (with_mass)
      masses = BlockMatrix<1>(sparsity);
    if (with_damping)
      dampings = BlockMatrix<n_components>(sparsity);
    MaterialsOfCell<dim> at(materials);
    std::vector<Moduli>  moduli_at;
    for_each_cell(
      level,
      with_points((with_mass ? update_values : update_default) |
                    update_gradients,
                  materials),
      [&](const unsigned int           body,
          const FEValues<dim>         &fe_values,
          const std::vector<LocalRow> &rows) {
        at.reinit(body, fe_values);
        moduli_at.clear();
        for (const unsigned int q : fe_values.quadrature_point_indices())
          moduli_at.push_back(moduli(at[q]));

        for (unsigned int i = 0; i < rows.size(); ++i)
          for (unsigned int j = 0; j < rows.size(); ++j)
            {
              Tensor<2, 1>            mass;
              Tensor<2, n_components> stiffness, damping;
              for (const unsigned int q : fe_values.quadrature_point_indices())
                {
                  const double          JxW = fe_values.JxW(q);
                  const Tensor<1, dim> &gi  = fe_values.shape_grad(i, q);
                  const Tensor<1, dim> &gj  = fe_values.shape_grad(j, q);
                  const Moduli         &m   = moduli_at[q];
                  stiffness +=
                    JxW * isotropic_block<n_components>(m.lambda, m.mu, gi, gj);
                  if (with_mass)
                    mass[0][0] += at[q].density * fe_values.shape_value(i, q) *
                                  fe_values.shape_value(j, q) * JxW;
                  if (with_damping)
                    damping += JxW * isotropic_block<n_components>(
                                       m.viscous_lambda, m.eta, gi, gj);
                }
              add(stiffnesses, rows[i], rows[j], stiffness);
              if (with_mass)
                add(masses, rows[i], rows[j], mass);
              if (with_damping)
                add(dampings, rows[i], rows[j], damping);
            }
      });
    ElasticMatrices<n_components> result;
    if constexpr (n_components == dim)
      add_patch_volumes(patches, stiffnesses, dampings, result);
    result.stiffness = std::move(stiffnesses);
    if (with_mass)
      result.mass = TermMatrix<n_components>::of_numbers(std::move(masses));
    if (with_damping)
      result.damping = std::move(dampings);
    return result;
  }



  template <int dim>
  NodalVector
  assemble_gravity(const MeshLevel<dim>              &level,
                   const std::vector<MaterialFields> &materials,
                   const Tensor<1, dim>              &acceleration)
  {
    NodalVector          load = level.nodes.make_vector();
    MaterialsOfCell<dim> at(materials);
    for_each_cell(level,
                  with_points(update_values, materials),
                  [&](const unsigned int           body,
                      const FEValues<dim>         &fe_values,
                      const std::vector<LocalRow> &rows) {
                    at.reinit(body, fe_values);
                    const double density = at.varies() ? 1. : at[0].density;
                    for (unsigned int i = 0; i < rows.size(); ++i)
                      {
                        // Factor of the density over the one above.
                        double integral = 0;
                        for (const unsigned int q :
                             fe_values.quadrature_point_indices())
                          integral += (at.varies() ? at[q].density : 1.) *
                                      fe_values.shape_value(i, q) *
                                      fe_values.JxW(q);
                        for (const auto &node : rows[i])
                          if (node.first < level.nodes.n_owned())
                            for (unsigned int c = 0; c < dim; ++c)
                              load.local_element(node.first * dim + c) +=
                                node.second * density * acceleration[c] *
                                integral;
                      }
                  });
    return load;
  }



  template <int dim>
  void
  check_materials(const MeshLevel<dim>              &level,
                  const std::vector<MaterialFields> &materials)
  {
    const UpdateFlags flags = with_points(update_default, materials);
    if (flags == update_default)
      return;
    MaterialsOfCell<dim>                                     at(materials);
    std::vector<std::function<Material(const Point<dim> &)>> functions;
    for (const MaterialFields &material : materials)
      functions.push_back(material.function<dim>());
    for_each_cell(level,
                  flags,
                  [&](const unsigned int   body,
                      const FEValues<dim> &fe_values,
                      const std::vector<LocalRow> &) {
                    at.reinit(body, fe_values);
                    if (at.varies())
                      functions[body](fe_values.get_cell()->center());
                  });
  }



#define STICKSLIP_INSTANTIATE(dim)                                            \
  template struct ElasticMatrices<dim>;                                       \
  template ElasticMatrices<dim> assemble_elastic_matrices<dim>(               \
    const MeshLevel<dim> &, const std::vector<MaterialFields> &, const bool); \
  template NodalVector assemble_gravity<dim>(                                 \
    const MeshLevel<dim> &,                                                   \
    const std::vector<MaterialFields> &,                                      \
    const Tensor<1, dim> &);                                                  \
  template void check_materials<dim>(const MeshLevel<dim> &,                  \
                                     const std::vector<MaterialFields> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
  template struct ElasticMatrices<1>;
  template decltype(assemble_elastic_matrices<2, 1>)
    assemble_elastic_matrices<2, 1>;
} // namespace StickSlip
