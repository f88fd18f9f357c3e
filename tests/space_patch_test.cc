// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <sstream>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  std::string
  text(const double value)
  {
    std::ostringstream out;
    out.precision(17);
    out << '(' << value << ')';
    return out.str();
  }



  template <int dim>
  SymmetricTensor<2, dim>
  stress(const Material &material, const Tensor<2, dim> &G)
  {
    const SymmetricTensor<2, dim> eps = symmetrize(G);
    return 2. * material.shear_modulus() * eps +
           material.lame_lambda() * trace(eps) * unit_symmetric_tensor<dim>();
  }



  /** The largest deviation of the stress at any quadrature point from the
   * expected one of each body, relative to the largest of these. */
  template <int dim>
  double
  stress_error(const SpatialScene<dim>                    &scene,
               NodalVector                                 u,
               const std::vector<SymmetricTensor<2, dim>> &expected)
  {
    const MeshLevel<dim> &level = scene.meshes.finest();
    fill_hanging_nodes(level, u);
    double error = 0., scale = 0.;
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        scale                       = std::max(scale, expected[b].norm());
        const DoFHandler<dim> &dofs = level.bodies[b]->dof_handler();
        const QGauss<dim>      quadrature(2);
        FEValues<dim> fe_values(dofs.get_fe(), quadrature, update_gradients);
        std::vector<types::global_dof_index> indices(fe_values.dofs_per_cell);
        for (const auto &cell : dofs.active_cell_iterators())
          {
            fe_values.reinit(cell);
            cell->get_dof_indices(indices);
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                Tensor<2, dim> G;
                for (unsigned int i = 0; i < indices.size(); ++i)
                  for (unsigned int c = 0; c < dim; ++c)
                    G[c] +=
                      u.local_element(level.node(b, indices[i]) * dim + c) *
                      fe_values.shape_grad(i, q);
                error = std::max(
                  error, (stress(scene.materials[b], G) - expected[b]).norm());
              }
          }
      }
    return error / scale;
  }



  template <int dim>
  void
  solve_static(SpatialScene<dim> &scene, NodalVector &w)
  {
    solve_linear(scene.problem,
                 {0., 0., 1.},
                 stuck_mask(scene.problem.hierarchy()),
                 scene.problem.load(0.),
                 w);
  }



  /** A gradient with all kinds of strain, and rotation. */
  template <int dim>
  Tensor<2, dim>
  some_gradient()
  {
    Tensor<2, dim> G;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        G[c][d] = 1e-4 * (std::sin(1. + 3. * c + 5. * d) + (c == d ? 0.5 : 0.));
    return G;
  }



  /** All outer sides are held at a linear displacement. */
  template <int dim>
  void
  expect_patch_test_with_held_sides(
    const std::vector<BodyGeometry<dim>> &bodies)
  {
    std::array<BoundaryType, dim> held;
    held.fill(BoundaryType::velocity);
    std::vector<BoundaryCondition<dim>> conditions;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (unsigned int side = 0; side < 2 * dim; ++side)
        if (side < 2 * (dim - 1) ||
            (side == BodyMesh<dim>::lower_side && b == 0) ||
            (side == BodyMesh<dim>::upper_side && b + 1 == bodies.size()))
          conditions.push_back(make_side<dim>(std::to_string(b), side, held));
    SpatialScene<dim> scene(bodies,
                            conditions,
                            std::vector<Material>(bodies.size()),
                            0.);

    const auto     G = some_gradient<dim>();
    const NodeMask dirichlet =
      scene.boundary.dirichlet_mask(scene.meshes.n_levels() - 1);
    NodalVector       u     = interpolate(scene.meshes.finest(),
                                [&](const unsigned int, const Point<dim> &x) {
                                  return Tensor<1, dim>(G * x);
                                });
    const NodalVector exact = u;
    // Nothing is known inside.
    for (unsigned int i = 0; i < dirichlet.n_nodes(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        if (dirichlet.is_active(i, c))
          u.local_element(i * dim + c) = 0.;
    NodalVector w = scene.problem.make_vector();
    scene.problem.to_jumps(w, u);
    // No jump at the slave nodes, whatever side their masters are held at.
    for (const unsigned int p : scene.problem.jump_basis().contact_nodes())
      for (unsigned int c = 0; c < dim; ++c)
        w.local_element(p * dim + c) = 0.;
    solve_static(scene, w);
    scene.problem.to_nodal(u, w);

    const double error =
      stress_error<dim>(scene,
                        u,
                        std::vector<SymmetricTensor<2, dim>>(
                          bodies.size(), stress(Material(), G)));
    EXPECT_LT(error, 1e-10);
    u -= exact;
    EXPECT_LT(u.linfty_norm(), 1e-11 * exact.linfty_norm());
  }



  /**
   * Layers of different stiffness under a uniform traction on top. The lowest
   * side is fixed and strain along the layers is held back by the traction on
   * their lateral sides; no side but the lowest is held, so that the faults
   * reach from end to end.
   */
  template <int dim>
  void
  expect_patch_test_with_tractions(const std::vector<BodyGeometry<dim>> &bodies)
  {
    constexpr unsigned int normal = dim - 1;
    Tensor<1, dim>         on_top;
    for (unsigned int c = 0; c < dim; ++c)
      on_top[c] = 1e3 * (c + 1.);
    on_top[normal] = -4e3;

    std::vector<Material>                materials(bodies.size());
    std::vector<SymmetricTensor<2, dim>> stresses;
    std::vector<BoundaryCondition<dim>>  conditions;
    std::array<BoundaryType, dim>        fixed, traction;
    fixed.fill(BoundaryType::fixed);
    traction.fill(BoundaryType::traction);
    const auto add_traction = [&](const unsigned int    b,
                                  const unsigned int    side,
                                  const Tensor<1, dim> &value) {
      std::array<std::string, dim> expression;
      for (unsigned int c = 0; c < dim; ++c)
        expression[c] = text(value[c]);
      conditions.push_back(
        make_side<dim>(std::to_string(b), side, traction, expression));
    };
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        materials[b].youngs_modulus *= 1. + 2. * b;
        materials[b].poissons_ratio = 0.1 + 0.08 * b;
        Tensor<2, dim> G;
        for (unsigned int c = 0; c + 1 < dim; ++c)
          G[c][normal] = on_top[c] / materials[b].shear_modulus();
        G[normal][normal] =
          on_top[normal] /
          (materials[b].lame_lambda() + 2. * materials[b].shear_modulus());
        stresses.push_back(stress(materials[b], G));
        for (unsigned int side = 0; side < 2 * (dim - 1); ++side)
          add_traction(b,
                       side,
                       (side % 2 == 0 ? -1. : 1.) *
                         Tensor<1, dim>(
                           stresses[b] *
                           Tensor<1, dim>(Point<dim>::unit_vector(side / 2))));
      }
    add_traction(bodies.size() - 1, BodyMesh<dim>::upper_side, on_top);
    conditions.push_back(make_side<dim>("0", BodyMesh<dim>::lower_side, fixed));

    SpatialScene<dim> scene(bodies, conditions, materials, 0.);
    NodalVector       w = scene.problem.make_vector(), u = w;
    solve_static(scene, w);
    scene.problem.to_nodal(u, w);
    const double error = stress_error<dim>(scene, u, stresses);
    EXPECT_LT(error, 1e-10);
  }



  /** The finer body below, above, and equal bodies. */
  std::vector<BodyGeometry<2>>
  two_bodies(const unsigned int cells_below, const unsigned int cells_above)
  {
    return stack<2>({make_body<2>(1., {{cells_below, 2}}, 2),
                     make_body<2>(0.7, {{cells_above, 2}}, 2)});
  }
} // namespace



TEST(PatchTest, TwoBodiesEitherSideFiner)
{
  expect_patch_test_with_held_sides<2>(two_bodies(10, 10));
  expect_patch_test_with_held_sides<2>(two_bodies(10, 7));
  expect_patch_test_with_held_sides<2>(two_bodies(7, 10));
  expect_patch_test_with_tractions<2>(two_bodies(10, 10));
  expect_patch_test_with_tractions<2>(two_bodies(10, 7));
  expect_patch_test_with_tractions<2>(two_bodies(7, 10));
}



TEST(PatchTest, ThreeBodies)
{
  expect_patch_test_with_held_sides<2>(nonmatching_bodies());
  expect_patch_test_with_tractions<2>(nonmatching_bodies());
}



TEST(PatchTest, FiveLayers)
{
  expect_patch_test_with_held_sides<2>(layered_bodies());
  expect_patch_test_with_tractions<2>(layered_bodies());
}



TEST(PatchTest, ThreeDimensions)
{
  const auto below = nonmatching_blocks();
  expect_patch_test_with_held_sides<3>(below);
  expect_patch_test_with_tractions<3>(below);
  const auto above = stack<3>({below[1], below[0]});
  expect_patch_test_with_held_sides<3>(above);
  expect_patch_test_with_tractions<3>(above);
}
