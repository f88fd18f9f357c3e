// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/spatial_problem.h>

namespace StickSlip
{
  template <int dim>
  SpatialProblem<dim>::SpatialProblem(
    const MeshHierarchy<dim>             &meshes,
    const std::vector<MaterialFields>    &materials,
    BoundaryValues<dim>                  &boundary_values,
    const Tensor<1, dim>                 &gravity,
    const bool                            with_inertia,
    const std::vector<SlipRates<dim>>    &slip_rates,
    const BackgroundStress<dim>          &background_stress,
    const std::vector<OpeningParts<dim>> &opening)
    : ContactSpace<dim>(meshes, materials, boundary_values, slip_rates, opening)
    , EquationOfMotion<dim>(*this,
                            materials,
                            boundary_values,
                            gravity,
                            with_inertia)
    , background(background_stress)
  {
    build_contact(this->make_nodal_vector());
  }



  template <int dim>
  void
  SpatialProblem<dim>::build_contact(
    const NodalVector                     &displacement,
    const std::vector<Tensor<1, dim - 1>> &expected_slip)
  {
    auto mapping = this->make_mapping(displacement, expected_slip);
    // Memory of the old levels is needed for the new ones.
    this->clear_operator();
    this->set_mapping(std::move(mapping), this->nodal_sparsity());
    this->make_operator(this->jump_product(),
                        this->rotation_coupling(),
                        this->descriptions());
    if (background.is_needed())
      this->set_fault_load(
        background.load(this->jump_basis(), this->descriptions().back().nodes));
  }



  template class SpatialProblem<2>;
  template class SpatialProblem<3>;
} // namespace StickSlip
