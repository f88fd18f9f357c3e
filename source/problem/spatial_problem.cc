// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/freed_memory.h>
#include <stickslip/problem/spatial_problem.h>

namespace StickSlip
{
  template <int dim, int n_components>
  SpatialProblem<dim, n_components>::SpatialProblem(
    const MeshHierarchy<dim>             &meshes,
    const std::vector<MaterialFields>    &materials,
    BoundaryValues<dim, n_components>    &boundary_values,
    const Tensor<1, dim>                 &gravity,
    const bool                            with_inertia,
    const std::vector<SlipRates<dim>>    &slip_rates,
    const BackgroundStress<dim>          &background_stress,
    const std::vector<OpeningParts<dim>> &opening)
    : ContactSpace<dim, n_components>(meshes,
                                      materials,
                                      boundary_values,
                                      slip_rates,
                                      opening)
    , EquationOfMotion<dim, n_components>(*this,
                                          materials,
                                          boundary_values,
                                          gravity,
                                          with_inertia)
    , background(background_stress)
  {
    build_contact(this->make_nodal_vector());
  }



  template <int dim, int n_components>
  void
  SpatialProblem<dim, n_components>::build_contact(
    const NodalVector                     &displacement,
    const std::vector<Tensor<1, dim - 1>> &expected_slip)
  {
    auto mapping = this->make_mapping(displacement, expected_slip);
    // Memory of the old levels is needed for the new ones.
    this->clear_operator();
    this->set_mapping(std::move(mapping), this->nodal_sparsity());
    // Small blocks that rows of transfers have left between others.
    if (Utilities::MPI::n_mpi_processes(displacement.get_mpi_communicator()) >
        1)
      give_back_freed_memory();
    this->make_operator(this->jump_product(),
                        this->rotation_coupling(),
                        this->descriptions());
    load_faults();
  }



  template <int dim, int n_components>
  void
  SpatialProblem<dim, n_components>::set_prestress(
    const std::vector<Tensor<1, dim - 1>> &shear_stress)
  {
    prestress = shear_stress;
    load_faults();
  }



  template <int dim, int n_components>
  void
  SpatialProblem<dim, n_components>::load_faults()
  {
    if (!background.is_needed() && prestress.empty())
      return;
    const NodePartition &nodes = this->descriptions().back().nodes;
    NodalVector          load  = background.is_needed() ?
                                   background.load(this->jump_basis(), nodes) :
                                   nodes.make_vector();
    if (!prestress.empty())
      add_prestress(this->jump_basis(), nodes, prestress, load);
    this->set_fault_load(std::move(load));
  }



  template class SpatialProblem<2>;
  template class SpatialProblem<3>;
  template class SpatialProblem<2, 1>;
} // namespace StickSlip
