// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/equation_of_motion.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The sums of the rows of a matrix for the first component. */
    template <int n_components>
    std::vector<double>
    row_sums(const TermMatrix<n_components> &matrix)
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      std::vector<double>  sums(matrix.n_rows(), 0.);
      for (unsigned int row = 0; row < sums.size(); ++row)
        for (unsigned int position = sparsity.row_start[row];
             position < sparsity.row_start[row + 1];
             ++position)
          sums[row] += matrix.entry(row, position)[0][0];
      return sums;
    }
  } // namespace



  template <int dim, int n_components>
  TermMatrix<n_components> &
  EquationOfMotion<dim, n_components>::matrix_of(
    ElasticMatrices<n_components> &matrices,
    const Term                     term)
  {
    return term == mass    ? matrices.mass :
           term == damping ? matrices.damping :
                             matrices.stiffness;
  }



  template <int dim, int n_components>
  EquationOfMotion<dim, n_components>::EquationOfMotion(
    const ContactSpace<dim, n_components> &space,
    const std::vector<MaterialFields>     &materials,
    BoundaryValues<dim, n_components>     &boundary_values,
    const Tensor<1, dim>                  &gravity,
    const bool                             with_inertia)
    : space(space)
    , boundary(boundary_values)
    , materials(materials)
    , with_inertia(with_inertia)
  {
    assemble();
    for (const Term term : {mass, damping, stiffness})
      if (matrix_of(*nodal_terms, term).shared_sparsity() != nullptr)
        terms.push_back(term);
    if (has(mass))
      masses = row_sums(nodal_terms->mass);
    // Gravity acts in the plane.
    if (n_components == dim && gravity.norm_square() > 0.)
      gravity_load =
        assemble_gravity(space.meshes().finest(), materials, gravity);
  }



  template <int dim, int n_components>
  void
  EquationOfMotion<dim, n_components>::assemble()
  {
    nodal_terms = std::make_unique<ElasticMatrices<n_components>>(
      assemble_elastic_matrices<dim, n_components>(space.meshes().finest(),
                                                   materials,
                                                   with_inertia));
  }



  template <int dim, int n_components>
  const BlockSparsity &
  EquationOfMotion<dim, n_components>::nodal_sparsity()
  {
    if (!nodal_terms)
      assemble();
    return nodal_terms->stiffness.sparsity();
  }



  template <int dim, int n_components>
  StiffVolumes
  EquationOfMotion<dim, n_components>::stiff_volumes() const
  {
    StiffVolumes result;
    // In three dimensions patches have too many nodes to relax them at once.
    if (n_components != 2)
      return result;
    const auto set = [&](const std::vector<unsigned int> &nodes,
                         const Term                       term) {
      if (nodes.empty())
        return;
      result.resize(nodal_terms->stiffness.n_rows(),
                    numbers::invalid_unsigned_int);
      const unsigned int position =
        std::find(terms.begin(), terms.end(), term) - terms.begin();
      for (const unsigned int i : nodes)
        result[i] = position;
    };
    set(nodal_terms->stiff_volumes, stiffness);
    set(nodal_terms->viscous_volumes, damping);
    return result;
  }



  template <int dim, int n_components>
  const TermMatrix<n_components> &
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
    NodalVector result = external_load(time);
    if (partners.is_there())
      partners.add(time, 1., result);
    return result;
  }



  template <int dim, int n_components>
  double
  EquationOfMotion<dim, n_components>::constant_rate_until(
    const double time) const
  {
    if (boundary.has_tractions())
      return time;
    return partners.is_there() && time < partners.end() ?
             partners.end() :
             std::numeric_limits<double>::max();
  }



  template <int dim, int n_components>
  NodalVector
  EquationOfMotion<dim, n_components>::load_rate(const double time) const
  {
    NodalVector result = space.make_vector();
    if (partners.is_there() && time < partners.end())
      result.add(-partners.rate, partners.first, partners.rate, partners.last);
    return result;
  }



  template <int dim, int n_components>
  void
  EquationOfMotion<dim, n_components>::set_partner_force(PartnerForce force)
  {
    partners = std::move(force);
    if (!partners.is_there())
      return;
    // Vectors from a file have other ghosts.
    PartnerForce::for_each_vector(partners, [this](NodalVector &vector) {
      NodalVector own = space.make_vector();
      std::copy_n(vector.begin(), own.locally_owned_size(), own.begin());
      vector.swap(own);
    });
  }



  template <int dim, int n_components>
  NodalVector
  EquationOfMotion<dim, n_components>::external_load(const double time)
  {
    if (constant_load)
      return *constant_load;
    const bool  has_gravity = gravity_load.size() > 0;
    NodalVector dual;
    if (has_gravity || boundary.has_tractions())
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
    if (!boundary.has_tractions())
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
    descriptions.back().stiff_volumes = stiff_volumes();
    const NodeMask all(space.meshes().finest().nodes.n_local(), n_components);
    std::vector<TermMatrix<n_components>> jump_terms;
    for (const Term term : terms)
      {
        BlockMatrix<n_components> in_jumps(product.coarse_sparsity());
        TermMatrix<n_components> &nodal = matrix_of(*nodal_terms, term);
        product.compute(nodal, all, in_jumps);
        nodal = TermMatrix<n_components>();
        rotation.transform(in_jumps);
        jump_terms.push_back(term == mass ?
                               TermMatrix<n_components>::compact(in_jumps) :
                               TermMatrix<n_components>::symmetric(in_jumps));
      }
    nodal_terms.reset();
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
