// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "geometric_multigrid.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/multigrid/mg_tools.h>

namespace Measure
{
  template <int dim>
  GeometricMultigrid<dim>::GeometricMultigrid(WeldedProblem<dim> &problem)
    : problem(problem)
  {
    DoFHandler<dim> &dof_handler = problem.dof_handler;
    dof_handler.distribute_mg_dofs();
    mg_constrained_dofs.initialize(dof_handler);
    for (const auto &side : problem.held_sides())
      mg_constrained_dofs.make_zero_boundary_constraints(dof_handler,
                                                         {side.first},
                                                         side.second);
  }



  template <int dim>
  void
  GeometricMultigrid<dim>::assemble_levels()
  {
    const DoFHandler<dim> &dof_handler = problem.dof_handler;
    const unsigned int     finest = problem.triangulation.n_global_levels() - 1;
    sparsities.resize(0, finest);
    interface_sparsities.resize(0, finest);
    matrices.resize(0, finest);
    interface_matrices.resize(0, finest);
    std::vector<AffineConstraints<double>> constraints(finest + 1);
    for (unsigned int l = 0; l <= finest; ++l)
      {
        constraints[l].add_lines(
          mg_constrained_dofs.get_refinement_edge_indices(l));
        constraints[l].add_lines(mg_constrained_dofs.get_boundary_indices(l));
        constraints[l].close();
        {
          DynamicSparsityPattern dynamic(dof_handler.n_dofs(l));
          MGTools::make_sparsity_pattern(dof_handler, dynamic, l);
          sparsities[l].copy_from(dynamic);
        }
        matrices[l].reinit(sparsities[l]);
        {
          DynamicSparsityPattern dynamic(dof_handler.n_dofs(l));
          MGTools::make_interface_sparsity_pattern(dof_handler,
                                                   mg_constrained_dofs,
                                                   dynamic,
                                                   l);
          interface_sparsities[l].copy_from(dynamic);
        }
        interface_matrices[l].reinit(interface_sparsities[l]);
      }

    std::vector<types::global_dof_index> dofs(
      dof_handler.get_fe().n_dofs_per_cell());
    problem.for_each_cell_matrix(
      true, [&](const auto &cell, const FullMatrix<double> &matrix) {
        const unsigned int l = cell->level();
        cell->get_mg_dof_indices(dofs);
        constraints[l].distribute_local_to_global(matrix, dofs, matrices[l]);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (mg_constrained_dofs.at_refinement_edge(l, dofs[i]))
            for (unsigned int j = 0; j < dofs.size(); ++j)
              if (mg_constrained_dofs.is_interface_matrix_entry(l,
                                                                dofs[i],
                                                                dofs[j]))
                interface_matrices[l].add(dofs[i], dofs[j], matrix(i, j));
      });
  }



  template <int dim>
  void
  GeometricMultigrid<dim>::set_up()
  {
    preconditioner.reset();
    multigrid.reset();
    coarse.factorisation.initialize(matrices[0]);
    transfer.initialize_constraints(mg_constrained_dofs);
    transfer.build(problem.dof_handler);
    pre_smoother.initialize(matrices);
    post_smoother.initialize(matrices);
    post_smoother.set_transpose(true);
    mg_matrix.initialize(matrices);
    mg_interface.initialize(interface_matrices);
    multigrid = std::make_unique<Multigrid<Vector<double>>>(
      mg_matrix, coarse, transfer, pre_smoother, post_smoother);
    multigrid->set_edge_matrices(mg_interface, mg_interface);
    preconditioner =
      std::make_unique<PreconditionMG<dim, Vector<double>, Transfer>>(
        problem.dof_handler, *multigrid, transfer);
  }



  template class GeometricMultigrid<2>;
  template class GeometricMultigrid<3>;
} // namespace Measure
