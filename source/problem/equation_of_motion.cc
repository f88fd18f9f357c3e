// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/equation_of_motion.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** The sums of the rows of a matrix for the first component. */
    template <int n_components>
    std::vector<double>
    row_sums(const BlockMatrix<n_components> &matrix)
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      std::vector<double>  sums(matrix.n_rows(), 0.);
      for (unsigned int row = 0; row < sums.size(); ++row)
        for (unsigned int position = sparsity.row_start[row];
             position < sparsity.row_start[row + 1];
             ++position)
          sums[row] += matrix.block(position)[0];
      return sums;
    }
  } // namespace



  template <int dim, int n_components>
  EquationOfMotion<dim, n_components>::EquationOfMotion(
    const ContactSpace<dim, n_components> &space,
    const std::vector<MaterialFields>     &materials,
    BoundaryValues<dim, n_components>     &boundary_values,
    const Tensor<1, dim>                  &gravity,
    const bool                             with_inertia)
    : space(space)
    , boundary(boundary_values)
  {
    const MeshLevel<dim>         &finest = space.meshes().finest();
    ElasticMatrices<n_components> matrices =
      assemble_elastic_matrices<dim, n_components>(finest,
                                                   materials,
                                                   with_inertia);
    const auto add = [&](const Term term, BlockMatrix<n_components> &matrix) {
      if (matrix.shared_sparsity() == nullptr)
        return;
      terms.push_back(term);
      nodal_terms.push_back(std::move(matrix));
    };
    add(mass, matrices.mass);
    if (has(mass))
      masses = row_sums(nodal_terms.back());
    add(damping, matrices.damping);
    add(stiffness, matrices.stiffness);
    // Gravity acts in the plane.
    if (n_components == dim && gravity.norm_square() > 0.)
      gravity_load = assemble_gravity(finest, materials, gravity);
  }



  template <int dim, int n_components>
  const BlockMatrix<n_components> &
  EquationOfMotion<dim, n_components>::term(const Term term) const
  {
    const auto position = std::find(terms.begin(), terms.end(), term);
    AssertThrow(position != terms.end(),
                ExcMessage("The equation has no such term."));
    return operator_sum->terms()[position - terms.begin()];
  }



  template <int dim, int n_components>
  void
  EquationOfMotion<dim, n_components>::combine(
    const std::vector<double> &coefficients)
  {
    std::vector<double> present;
    for (const Term term : terms)
      present.push_back(coefficients[term]);
    operator_sum->combine(present);
  }



  template <int dim, int n_components>
  NodalVector
  EquationOfMotion<dim, n_components>::load(const double time)
  {
    if (constant_load)
      return *constant_load;
    const bool  has_gravity = gravity_load.size() > 0;
    NodalVector dual;
    if (has_gravity || !has_constant_load())
      {
        NodalVector nodal =
          has_gravity ? gravity_load : space.make_nodal_vector();
        boundary.add_tractions(time, nodal);
        dual = space.to_dual(nodal);
      }
    else
      dual = space.make_vector();
    if (fault_load.size() > 0)
      dual += fault_load;
    if (has_constant_load())
      constant_load = std::make_unique<const NodalVector>(dual);
    return dual;
  }



  template <int dim, int n_components>
  void
  EquationOfMotion<dim, n_components>::make_operator(
    GalerkinProduct<n_components>              &product,
    const RotationCoupling<dim, n_components>  &rotation,
    std::vector<LevelDescription<n_components>> descriptions)
  {
    constant_load.reset();
    const NodeMask all(space.meshes().finest().nodes.n_local(), n_components);
    std::vector<BlockMatrix<n_components>> jump_terms;
    for (const BlockMatrix<n_components> &term : nodal_terms)
      {
        jump_terms.emplace_back(product.coarse_sparsity());
        product.compute(term, all, jump_terms.back());
        rotation.transform(jump_terms.back());
      }
    operator_sum =
      std::make_unique<OperatorSum<n_components>>(descriptions.back(),
                                                  std::move(jump_terms));
    levels =
      std::make_unique<LevelHierarchy<n_components>>(*operator_sum,
                                                     std::move(descriptions));
  }



  template class EquationOfMotion<2>;
  template class EquationOfMotion<3>;
  template class EquationOfMotion<2, 1>;
} // namespace StickSlip
