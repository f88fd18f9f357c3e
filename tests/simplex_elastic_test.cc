// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <cmath>

#include "simplex_bodies.h"
#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  /** A displacement that is a quadratic function of the position. */
  template <int dim>
  struct QuadraticDisplacement
  {
    /** u_c = linear_cd x_d + quadratic_cde x_d x_e. */
    Tensor<2, dim> linear;
    Tensor<3, dim> quadratic;

    explicit QuadraticDisplacement(const double size_of_quadratic)
    {
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            linear[c][d] = 1e-4 * std::sin(1. + 3. * c + 5. * d);
            for (unsigned int e = 0; e <= d; ++e)
              quadratic[c][d][e] = quadratic[c][e][d] =
                size_of_quadratic * 1e-4 * std::cos(1. + c + 2. * d + 3. * e);
          }
    }

    Tensor<1, dim>
    value(const Point<dim> &x) const
    {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            result[c] += linear[c][d] * x[d];
            for (unsigned int e = 0; e < dim; ++e)
              result[c] += quadratic[c][d][e] * x[d] * x[e];
          }
      return result;
    }

    Tensor<2, dim>
    gradient(const Point<dim> &x) const
    {
      Tensor<2, dim> result = linear;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            result[c][d] += 2. * quadratic[c][d][e] * x[e];
      return result;
    }

    /** The acceleration that keeps a body in this shape: -div sigma / rho. */
    Tensor<1, dim>
    acceleration(const Material &material) const
    {
      const double   mu = material.shear_modulus();
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          result[c] -= 2. *
                       (mu * quadratic[c][d][d] +
                        (mu + material.lame_lambda()) * quadratic[d][d][c]) /
                       material.density;
      return result;
    }
  };



  /** Errors of displacement and gradient in the mean square over the bodies. */
  template <int dim>
  std::array<double, 2>
  errors(const MeshLevel<dim>             &level,
         NodalVector                       u,
         const QuadraticDisplacement<dim> &exact)
  {
    fill_hanging_nodes(level, u);
    std::array<double, 2> squares = {{0., 0.}};
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const auto &fe = level.bodies[b]->dof_handler().get_fe();
        const auto  quadrature =
          fe.reference_cell().template get_gauss_type_quadrature<dim>(3);
        FEValues<dim>                        fe_values(fe,
                                quadrature,
                                update_values | update_gradients |
                                  update_quadrature_points | update_JxW_values);
        std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
        for (const auto &cell :
             level.bodies[b]->dof_handler().active_cell_iterators())
          {
            fe_values.reinit(cell);
            cell->get_dof_indices(dofs);
            for (const unsigned int q : fe_values.quadrature_point_indices())
              {
                Tensor<1, dim> value =
                  -exact.value(fe_values.quadrature_point(q));
                Tensor<2, dim> gradient =
                  -exact.gradient(fe_values.quadrature_point(q));
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  for (unsigned int c = 0; c < dim; ++c)
                    {
                      const double nodal =
                        u.local_element(level.node(b, dofs[i]) * dim + c);
                      value[c] += nodal * fe_values.shape_value(i, q);
                      gradient[c] += nodal * fe_values.shape_grad(i, q);
                    }
                squares[0] += value.norm_square() * fe_values.JxW(q);
                squares[1] += gradient.norm_square() * fe_values.JxW(q);
              }
          }
      }
    return {{std::sqrt(squares[0]), std::sqrt(squares[1])}};
  }



  struct Solution
  {
    std::array<double, 2> errors;
    unsigned int          n_iterations;
    unsigned int          n_nodes;
  };



  /** Solve for the displacement in bodies whose outer sides are held at it, the
   * faults stuck. */
  template <int dim>
  Solution
  solve(const std::vector<CoarseBody<dim>> &bodies,
        const QuadraticDisplacement<dim>   &exact,
        const double                        reduction)
  {
    std::array<BoundaryType, dim> held;
    held.fill(BoundaryType::velocity);
    std::vector<BoundaryCondition<dim>> conditions;
    const FaultTopology topology = numbered_stack<dim>(bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (unsigned int side = 0; side < 2 * dim; ++side)
        if (!topology.is_at_fault(b, side))
          conditions.push_back(
            make_side<dim>(topology.body_names()[b], side, held));
    const std::vector<Material> materials(bodies.size());
    SpatialScene<dim>           scene(bodies,
                            topology,
                            conditions,
                            materials,
                            exact.acceleration(materials[0]));

    const MeshLevel<dim> &level = scene.meshes.finest();
    const NodeMask        dirichlet =
      scene.boundary.dirichlet_mask(scene.meshes.n_levels() - 1);
    NodalVector u =
      interpolate(level, [&](const unsigned int, const Point<dim> &x) {
        return exact.value(x);
      });
    for (unsigned int i = 0; i < dirichlet.n_nodes(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        if (dirichlet.is_active(i, c))
          u.local_element(i * dim + c) = 0.;
    NodalVector w = scene.problem.make_vector();
    scene.problem.to_jumps(w, u);
    for (const unsigned int p : scene.problem.jump_basis().contact_nodes())
      for (unsigned int c = 0; c < dim; ++c)
        w.local_element(p * dim + c) = 0.;
    const unsigned int n_iterations =
      solve_linear(scene.problem,
                   {0., 0., 1.},
                   stuck_mask(scene.problem.hierarchy()),
                   scene.problem.load(0.),
                   w,
                   reduction);
    scene.problem.to_nodal(u, w);
    return {errors(level, u, exact),
            n_iterations,
            static_cast<unsigned int>(level.n_nodes())};
  }



  template <int dim>
  BodyGeometry<dim>
  cube(const unsigned int n_cells, const unsigned int n_refinements)
  {
    BodyGeometry<dim> body;
    body.thickness = 5.;
    body.coarse_cells.fill(n_cells);
    body.uniform_refinements = n_refinements;
    body.refinement_passes   = 0;
    return body;
  }



  /** Errors fall as the square of the cell size, those of the gradient as the
   * size, once the coarsest meshes are left behind, and iterations are level.
   */
  template <int dim>
  void
  expect_orders(const unsigned int n_cells,
                const unsigned int last_refinements,
                const unsigned int order_after,
                const unsigned int most_iterations)
  {
    const QuadraticDisplacement<dim> exact(0.2);
    std::array<double, 2>            coarser = {{0., 0.}};
    for (unsigned int r = 1; r <= last_refinements; ++r)
      {
        const Solution found =
          solve<dim>({simplex_brick(cube<dim>(n_cells, r))}, exact, 1e-8);
        if (r > order_after)
          {
            EXPECT_GT(coarser[0] / found.errors[0], std::pow(2., 1.9)) << r;
            EXPECT_GT(coarser[1] / found.errors[1], std::pow(2., 0.98)) << r;
          }
        EXPECT_LE(found.n_iterations, most_iterations) << r;
        coarser = found.errors;
        std::cout << dim << " dimensions, " << found.n_nodes
                  << " nodes: errors " << found.errors[0] << " and "
                  << found.errors[1] << ", " << found.n_iterations
                  << " iterations\n";
      }
  }
} // namespace



TEST(SimplexElastic, OrdersAndIterationsOfTriangles)
{
  expect_orders<2>(2, 6, 2, 14);
}



TEST(SimplexElastic, OrdersAndIterationsOfTetrahedra)
{
  expect_orders<3>(1, 4, 1, 12);
}



// Hanging nodes, and a fault between meshes that do not match.
TEST(SimplexElastic, PatchTestOfTriangles)
{
  const QuadraticDisplacement<2> exact(0.);
  for (const unsigned int n : {10u, 7u})
    {
      const Solution found =
        solve<2>(simplex_bricks(stack<2>({make_body<2>(1., {{n, 2}}, 2),
                                          make_body<2>(0.7, {{8, 2}}, 2)})),
                 exact,
                 1e-14);
      EXPECT_LT(found.errors[0], 1e-14);
      EXPECT_LT(found.errors[1], 1e-13);
    }
}



TEST(SimplexElastic, PatchTestOfTetrahedra)
{
  const QuadraticDisplacement<3> exact(0.);
  const Solution found = solve<3>({simplex_brick(cube<3>(1, 2))}, exact, 1e-14);
  EXPECT_LT(found.errors[0], 1e-13);
  EXPECT_LT(found.errors[1], 1e-13);
}



// Triangles and quadrilaterals as neighbours.
TEST(SimplexElastic, PatchTestOfBodiesOfDifferentCells)
{
  const auto geometries =
    stack<2>({make_body<2>(1., {{7, 2}}, 2), make_body<2>(0.7, {{8, 2}}, 2)});
  const Solution found =
    solve<2>({simplex_brick(geometries[0]), coarse_brick(geometries[1])},
             QuadraticDisplacement<2>(0.),
             1e-14);
  EXPECT_LT(found.errors[0], 1e-14);
  EXPECT_LT(found.errors[1], 1e-13);
}
