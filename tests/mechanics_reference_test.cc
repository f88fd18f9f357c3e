// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/integrators/elasticity.h>
#include <deal.II/integrators/grad_div.h>
#include <deal.II/integrators/l2.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  /** The matrices of one body made by the library alone: its vector elements,
   * its local integrators, its treatment of hanging nodes. */
  template <int dim>
  struct Reference
  {
    DoFHandler<dim>           dofs;
    AffineConstraints<double> constraints;
    SparsityPattern           pattern;
    SparseMatrix<double>      mass, stiffness, damping;

    /** For each degree of freedom, that of the scalar DoFHandler and the
     * component. */
    std::vector<std::pair<types::global_dof_index, unsigned int>> place;

    Reference(const BodyMesh<dim> &body, const Material &material)
      : dofs(body.triangulation())
    {
      const FESystem<dim> fe(FE_Q<dim>(1), dim);
      dofs.distribute_dofs(fe);
      DoFTools::make_hanging_node_constraints(dofs, constraints);
      constraints.close();
      DynamicSparsityPattern dsp(dofs.n_dofs());
      DoFTools::make_sparsity_pattern(dofs, dsp, constraints);
      pattern.copy_from(dsp);
      mass.reinit(pattern);
      stiffness.reinit(pattern);
      damping.reinit(pattern);

      place.resize(dofs.n_dofs());
      auto scalar_cell = body.dof_handler().begin_active();
      for (auto cell = dofs.begin_active(); cell != dofs.end();
           ++cell, ++scalar_cell)
        for (const auto v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            place[cell->vertex_dof_index(v, c)] = {
              scalar_cell->vertex_dof_index(v, 0), c};

      const QGauss<dim> quadrature(3);
      FEValues<dim>     fe_values(
        fe, quadrature, update_values | update_gradients | update_JxW_values);
      const unsigned int                   n = fe.n_dofs_per_cell();
      FullMatrix<double>                   cell_matrix(n, n);
      std::vector<types::global_dof_index> indices(n);
      const double                         eta = material.shear_viscosity;
      const double                         bulk_lambda =
        material.bulk_viscosity - 2. * eta / dim_of_space;
      for (const auto &cell : dofs.active_cell_iterators())
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(indices);
          cell_matrix = 0.;
          LocalIntegrators::L2::mass_matrix(cell_matrix,
                                            fe_values,
                                            material.density);
          constraints.distribute_local_to_global(cell_matrix, indices, mass);
          add_isotropic(cell_matrix,
                        fe_values,
                        material.shear_modulus(),
                        material.lame_lambda());
          constraints.distribute_local_to_global(cell_matrix,
                                                 indices,
                                                 stiffness);
          add_isotropic(cell_matrix, fe_values, eta, bulk_lambda);
          constraints.distribute_local_to_global(cell_matrix, indices, damping);
        }
    }

    /** Whatever the dimension of the scene, bodies live in three. */
    static constexpr double dim_of_space = 3.;

    static void
    add_isotropic(FullMatrix<double>  &cell_matrix,
                  const FEValues<dim> &fe_values,
                  const double         mu,
                  const double         lambda)
    {
      cell_matrix = 0.;
      LocalIntegrators::Elasticity::cell_matrix(cell_matrix,
                                                fe_values,
                                                2. * mu);
      LocalIntegrators::GradDiv::cell_matrix(cell_matrix, fe_values, lambda);
    }



    /** The largest difference of entries relative to the largest entry, over
     * the rows and columns of nodes that are not hanging. */
    double
    difference(const SparseMatrix<double> &expected,
               const TermMatrix<dim>      &matrix,
               const MeshLevel<dim>       &level,
               const unsigned int          body) const
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      double               largest = 0., error = 0.;
      for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
        {
          if (constraints.is_constrained(i))
            continue;
          const unsigned int row = level.node(body, place[i].first);
          // The entries of the matrix in row i by columns.
          std::vector<double> values(dofs.n_dofs() / dim * dim, 0.);
          for (unsigned int k = sparsity.row_start[row];
               k < sparsity.row_start[row + 1];
               ++k)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int column =
                  sparsity.column[k] - level.node(body, 0);
                AssertIndexRange(column, dofs.n_dofs() / dim);
                values[column * dim + d] =
                  matrix.entry(row, k)[place[i].second][d];
              }
          for (auto entry = expected.begin(i); entry != expected.end(i);
               ++entry)
            if (!constraints.is_constrained(entry->column()))
              {
                const auto [dof, component] = place[entry->column()];
                values[dof * dim + component] -= entry->value();
                largest = std::max(largest, std::abs(entry->value()));
              }
          for (const double value : values)
            error = std::max(error, std::abs(value));
        }
      return error / largest;
    }
  };



  template <int dim>
  void
  expect_reference_matrices(const std::vector<BodyGeometry<dim>> &bodies)
  {
    const MeshHierarchy<dim> meshes(bodies, MPI_COMM_WORLD);
    std::vector<Material>    materials(bodies.size());
    materials[1].youngs_modulus  = 2e7;
    materials[1].poissons_ratio  = 0.1;
    materials[1].shear_viscosity = 7e3;
    for (const MeshLevel<dim> *level : {&meshes.level(1), &meshes.finest()})
      {
        const auto matrices =
          assemble_elastic_matrices(*level,
                                    {materials.begin(), materials.end()});
        for (unsigned int b = 0; b < bodies.size(); ++b)
          {
            const Reference<dim> reference(*level->bodies[b], materials[b]);
            EXPECT_LT(
              reference.difference(reference.mass, matrices.mass, *level, b),
              1e-13);
            EXPECT_LT(reference.difference(
                        reference.stiffness, matrices.stiffness, *level, b),
                      1e-13);
            EXPECT_LT(reference.difference(
                        reference.damping, matrices.damping, *level, b),
                      1e-13);
          }
      }
  }
} // namespace



TEST(ElasticMatrices, AreThoseOfTheLibrary)
{
  expect_reference_matrices<2>(nonmatching_bodies());
  expect_reference_matrices<3>(nonmatching_blocks());
}



TEST(ElasticMatrices, HangingNodesHaveEmptyRowsAndColumns)
{
  const MeshHierarchy<2> meshes(spring_slider_bodies(), MPI_COMM_WORLD);
  const MeshLevel<2>    &level = meshes.finest();
  const auto             matrices =
    assemble_elastic_matrices(level, std::vector<MaterialFields>(2));
  NodalVector hanging_nodes = level.nodes.make_vector(),
              product       = hanging_nodes;
  unsigned int n_hanging    = 0;
  for_each_node(level,
                [&](const unsigned int,
                    const unsigned int,
                    const unsigned int node,
                    const Point<2> &,
                    const bool hanging) {
                  n_hanging += hanging;
                  for (unsigned int c = 0; c < 2; ++c)
                    hanging_nodes.local_element(node * 2 + c) =
                      hanging ? 1. + c : 0.;
                });
  EXPECT_GT(n_hanging, 0u);
  for (const TermMatrix<2> *A :
       {&matrices.mass, &matrices.damping, &matrices.stiffness})
    {
      A->vmult(product, hanging_nodes);
      EXPECT_EQ(product.linfty_norm(), 0.);
    }
}
