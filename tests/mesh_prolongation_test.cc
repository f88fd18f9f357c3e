// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_point_value.h>

#include <gtest/gtest.h>

#include "serial_matrices.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  unsigned int
  n_hanging(const MeshLevel<dim> &level)
  {
    unsigned int n = 0;
    for (const auto &body : level.bodies)
      n += body->bound_nodes().n_constraints();
    return n;
  }



  /**
   * The values at the coarse nodes of a linear function of each body go to
   * those at the fine nodes. What stands at hanging nodes must not be read.
   */
  template <int dim>
  void
  expect_linear_functions_reproduced(const MeshHierarchy<dim> &meshes)
  {
    const auto function = [](const unsigned int body, const Point<dim> &x) {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          value[c] += 0.3 * (c + 1.) - body + (0.7 * c - 0.4 * d + 0.1) * x[d];
      return 0.1 * value;
    };
    for (unsigned int l = 1; l < meshes.n_levels(); ++l)
      {
        NodalVector coarse = interpolate(meshes.level(l - 1), function);
        for_each_node(meshes.level(l - 1),
                      [&](const unsigned int,
                          const unsigned int,
                          const unsigned int node,
                          const Point<dim> &,
                          const bool hanging) {
                        if (hanging)
                          coarse.local_element(node * dim) = 1e6;
                      });
        NodalVector fine = meshes.level(l).nodes.make_vector();
        prolongation_matrix(meshes, l).prolongate(fine, coarse, dim);
        // At hanging nodes both are zero.
        fine -= interpolate(meshes.level(l), function);
        EXPECT_LT(fine.linfty_norm(), 1e-13) << "on level " << l;
      }
  }



  /** Prolongated values are those of the coarse function, evaluated by the
   * library. */
  template <int dim>
  void
  expect_functions_reproduced(const MeshHierarchy<dim> &meshes)
  {
    std::mt19937 random(3);
    for (unsigned int l = 1; l < meshes.n_levels(); ++l)
      {
        const MeshLevel<dim> &level  = meshes.level(l - 1);
        NodalVector           coarse = random_values(level, random);
        NodalVector           fine   = meshes.level(l).nodes.make_vector();
        prolongation_matrix(meshes, l).prolongate(fine, coarse, dim);
        fill_hanging_nodes(level, coarse);

        std::vector<Vector<double>> of_body;
        for (unsigned int b = 0; b < level.bodies.size(); ++b)
          {
            const DoFHandler<dim> &dofs = level.bodies[b]->dof_handler();
            of_body.emplace_back(dofs.n_dofs());
            for (unsigned int dof = 0; dof < dofs.n_dofs(); ++dof)
              of_body[b][dof] =
                coarse.local_element(level.node(b, dof) * dim + dim - 1);
          }
        double error = 0.;
        for_each_node(meshes.level(l),
                      [&](const unsigned int b,
                          const unsigned int,
                          const unsigned int node,
                          const Point<dim>  &x,
                          const bool         hanging) {
                        const double expected =
                          hanging ?
                            0. :
                            VectorTools::point_value(
                              level.bodies[b]->dof_handler(), of_body[b], x);
                        const double value =
                          fine.local_element(node * dim + dim - 1);
                        error = std::max(error, std::abs(value - expected));
                      });
        EXPECT_LT(error, 1e-12) << "on level " << l;
      }
  }



  template <int dim>
  void
  expect_rows_sum_to_one(const MeshHierarchy<dim> &meshes)
  {
    for (unsigned int l = 1; l < meshes.n_levels(); ++l)
      {
        const TransferMatrix P = prolongation_matrix(meshes, l);
        ASSERT_EQ(P.n_rows(), meshes.level(l).nodes.n_local());
        ASSERT_EQ(P.n_columns(), meshes.level(l - 1).nodes.n_local());
        for_each_node(meshes.level(l),
                      [&](const unsigned int,
                          const unsigned int,
                          const unsigned int node,
                          const Point<dim> &,
                          const bool hanging) {
                        const auto  &rows = P.matrix();
                        unsigned int k    = rows.row_start[node];
                        double       sum  = 0.;
                        for (; k < rows.row_start[node + 1]; ++k)
                          {
                            EXPECT_GT(rows.value[k], 0.);
                            sum += rows.value[k];
                          }
                        EXPECT_NEAR(sum, hanging ? 0. : 1., 1e-14);
                      });
        // No coarse hanging node has a say.
        for_each_node(meshes.level(l - 1),
                      [&](const unsigned int,
                          const unsigned int,
                          const unsigned int node,
                          const Point<dim> &,
                          const bool hanging) {
                        const auto &columns = P.transpose();
                        EXPECT_EQ(hanging,
                                  columns.row_start[node] ==
                                    columns.row_start[node + 1]);
                      });
      }
  }



  template <int dim>
  void
  for_each_scene(void (*check)(const MeshHierarchy<dim> &))
  {
    for (const auto &bodies : scenes<dim>())
      for (const unsigned int times : {0, 1})
        {
          const MeshHierarchy<dim> meshes(halved(bodies, times),
                                          MPI_COMM_WORLD);
          ASSERT_GT(n_hanging(meshes.finest()), 0u);
          check(meshes);
        }
  }
} // namespace



TEST(MeshProlongation, ReproducesLinearFunctions)
{
  for_each_scene<2>(expect_linear_functions_reproduced<2>);
  for_each_scene<3>(expect_linear_functions_reproduced<3>);
}



TEST(MeshProlongation, ReproducesEveryCoarseFunction)
{
  for_each_scene<2>(expect_functions_reproduced<2>);
  for_each_scene<3>(expect_functions_reproduced<3>);
}



TEST(MeshProlongation, RowsSumToOneExceptAtHangingNodes)
{
  for_each_scene<2>(expect_rows_sum_to_one<2>);
  for_each_scene<3>(expect_rows_sum_to_one<3>);
}
