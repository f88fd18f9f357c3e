// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>

#include <cmath>
#include <sstream>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  /**
   * A standing wave, half of it a gradient and half of it a curl, without shear
   * stress at x = -2.5 and x = 2.5:
   *
   *   u = cos(omega t + phase) (sin(kx) (A sin(ky + p) + B sin(ky + q)),
   *                             cos(kx) (-A cos(ky + p) + B cos(ky + q))),
   *
   * with the body force that keeps it going in a Kelvin-Voigt solid.
   */
  struct StandingWave
  {
    static constexpr double k = 2. * numbers::PI / 5., omega = 60., phase = 0.4,
                            p = 0.3, B = 0.7, q = 1.1;

    const Material material;
    const double   A = 1.;

    Tensor<1, 2>
    gradient_part(const Point<2> &x) const
    {
      return Tensor<1, 2>({A * std::sin(k * x[0]) * std::sin(k * x[1] + p),
                           -A * std::cos(k * x[0]) * std::cos(k * x[1] + p)});
    }

    Tensor<1, 2>
    curl_part(const Point<2> &x) const
    {
      return Tensor<1, 2>({B * std::sin(k * x[0]) * std::sin(k * x[1] + q),
                           B * std::cos(k * x[0]) * std::cos(k * x[1] + q)});
    }

    /** The derivative of that order in time. */
    double
    factor(const double time, const unsigned int order) const
    {
      return std::pow(omega, order) *
             std::cos(omega * time + phase + order * numbers::PI_2);
    }

    Tensor<1, 2>
    value(const Point<2>    &x,
          const double       time,
          const unsigned int order = 0) const
    {
      return factor(time, order) * (gradient_part(x) + curl_part(x));
    }

    Tensor<2, 2>
    gradient(const Point<2> &x, const double time) const
    {
      const double sx = std::sin(k * x[0]), cx = std::cos(k * x[0]),
                   sp = std::sin(k * x[1] + p), cp = std::cos(k * x[1] + p),
                   sq = std::sin(k * x[1] + q), cq = std::cos(k * x[1] + q);
      Tensor<2, 2> result;
      result[0][0] = k * cx * (A * sp + B * sq);
      result[0][1] = k * sx * (A * cp + B * cq);
      result[1][0] = -k * sx * (-A * cp + B * cq);
      result[1][1] = k * cx * (A * sp - B * sq);
      return factor(time, 0) * result;
    }

    /** Both parts are eigenfunctions of the Laplacian, for -2 k^2. */
    Tensor<1, 2>
    body_force(const Point<2> &x, const double time) const
    {
      const double mu       = material.shear_modulus(),
                   lambda   = material.lame_lambda(),
                   eta      = material.shear_viscosity,
                   lambda_v = material.bulk_viscosity - 2. / 3. * eta;
      const auto stress     = [&](const double along, const double across) {
        return 2. * k * k * (along * gradient_part(x) + across * curl_part(x));
      };
      return material.density * value(x, time, 2) +
             factor(time, 0) * stress(lambda + 2. * mu, mu) +
             factor(time, 1) * stress(lambda_v + 2. * eta, eta);
    }

    /** The velocity as expressions in x, y and t. */
    std::array<std::string, 2>
    velocity() const
    {
      std::ostringstream common, ky, u, v;
      common.precision(17), ky.precision(17), u.precision(17), v.precision(17);
      ky << k << "*y+";
      common << -omega << "*sin(" << omega << "*t+" << phase << ")*";
      u << common.str() << "sin(" << k << "*x)*(" << A << "*sin(" << ky.str()
        << p << ")+" << B << "*sin(" << ky.str() << q << "))";
      v << common.str() << "cos(" << k << "*x)*(" << -A << "*cos(" << ky.str()
        << p << ")+" << B << "*cos(" << ky.str() << q << "))";
      return {{u.str(), v.str()}};
    }

    /** The traction on the sides x = -2.5 and x = 2.5 in the same form. */
    std::array<std::string, 2>
    traction(const bool is_upper_side) const
    {
      const double mu       = material.shear_modulus(),
                   lambda   = material.lame_lambda(),
                   eta      = material.shear_viscosity,
                   lambda_v = material.bulk_viscosity - 2. / 3. * eta;
      std::ostringstream sp, sq, stress;
      sp.precision(17), sq.precision(17), stress.precision(17);
      sp << "sin(" << k << "*y+" << p << ')';
      sq << "sin(" << k << "*y+" << q << ')';
      // The cosine of kx is -1 on both sides.
      const auto part = [&](const double first, const double second) {
        std::ostringstream text;
        text.precision(17);
        text << '(' << -2. * k * A * (first + second) << '*' << sp.str() << '+'
             << -2. * k * B * second << '*' << sq.str() << ')';
        return text.str();
      };
      stress << (is_upper_side ? 1. : -1.) << "*(cos(" << omega << "*t+"
             << phase << ")*" << part(lambda, mu) << '-' << omega << "*sin("
             << omega << "*t+" << phase << ")*" << part(lambda_v, eta) << ')';
      return {{stress.str(), ""}};
    }
  };



  /** Material in which viscosity and inertia matter alike. */
  Material
  thick()
  {
    Material material;
    material.shear_viscosity = 1e5;
    material.bulk_viscosity  = 2e5;
    return material;
  }



  /** Bodies in the standing wave, faults welded. */
  struct Wave
  {
    static constexpr double end_time = 0.05;

    const StandingWave exact;
    SpatialScene<2>    scene;
    SystemState<2>     state;

    explicit Wave(const std::vector<BodyGeometry<2>> &bodies,
                  const StandingWave                 &exact = {thick()})
      : exact(exact)
      , scene(bodies,
              conditions(exact, bodies.size()),
              std::vector<Material>(bodies.size(), exact.material),
              0.)
    {
      state.displacement = nodal_values(0);
      state.velocity     = nodal_values(1);
      state.acceleration = nodal_values(2);
    }

    void
    run(const unsigned int n_steps)
    {
      SpatialProblem<2> &problem = scene.problem;
      LevelHierarchy<2> &levels  = problem.hierarchy();
      const double       tau     = end_time / n_steps;
      for (unsigned int n = 0; n < n_steps; ++n)
        {
          SystemState<2> to = state;
          to.time           = state.time + tau;
          NodalVector rhs   = Newmark<2>().right_hand_side(problem, state, tau);
          rhs += problem.to_dual(body_force(to.time));
          scene.boundary.set_velocities(to.time, to.velocity);
          NodalVector w = problem.make_vector();
          problem.to_jumps(w, to.velocity);
          for (const unsigned int p : levels.finest().nonsmooth_nodes)
            for (unsigned int c = 0; c < 2; ++c)
              w.local_element(p * 2 + c) = 0.;
          solve_linear(problem,
                       Newmark<2>().operator_coefficients(tau),
                       stuck_mask(levels),
                       rhs,
                       w);
          problem.to_nodal(to.velocity, w);
          Newmark<2>().complete(to, state, tau);
          state = to;
        }
    }

    /** Errors of the displacement in L2 and of its gradient. */
    std::array<double, 2>
    errors() const
    {
      // Of hanging nodes vectors know nothing.
      NodalVector         displacement = state.displacement;
      const MeshLevel<2> &level        = scene.meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
          for (unsigned int c = 0; c < 2; ++c)
            {
              double &value =
                displacement.local_element(level.node(b, line.index) * 2 + c);
              value = 0.;
              for (const auto &entry : line.entries)
                value += entry.second * displacement.local_element(
                                          level.node(b, entry.first) * 2 + c);
            }

      double values = 0, gradients = 0;
      for_each_point([&](const FEValues<2>           &fe_values,
                         const unsigned int           q,
                         const std::vector<unsigned> &nodes) {
        const Point<2> x = fe_values.quadrature_point(q);
        Tensor<1, 2>   u = -exact.value(x, state.time);
        Tensor<2, 2>   g = -exact.gradient(x, state.time);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int c = 0; c < 2; ++c)
            {
              const double coefficient =
                displacement.local_element(nodes[i] * 2 + c);
              u[c] += coefficient * fe_values.shape_value(i, q);
              g[c] += coefficient * fe_values.shape_grad(i, q);
            }
        values += u.norm_square() * fe_values.JxW(q);
        gradients += g.norm_square() * fe_values.JxW(q);
      });
      return {{std::sqrt(values), std::sqrt(gradients)}};
    }

  private:
    static std::vector<BoundaryCondition<2>>
    conditions(const StandingWave &wave, const unsigned int n_bodies)
    {
      const std::array<BoundaryType, 2> moved = {
        {BoundaryType::velocity, BoundaryType::velocity}};
      const std::array<BoundaryType, 2> pulled = {
        {BoundaryType::traction, BoundaryType::free}};
      std::vector<BoundaryCondition<2>> result = {
        make_side<2>("0", 2, moved, wave.velocity()),
        make_side<2>(std::to_string(n_bodies - 1), 3, moved, wave.velocity())};
      for (unsigned int b = 0; b < n_bodies; ++b)
        for (const unsigned int side : {0, 1})
          result.push_back(make_side<2>(
            std::to_string(b), side, pulled, wave.traction(side == 1)));
      return result;
    }

    NodalVector
    nodal_values(const unsigned int order)
    {
      NodalVector         result = scene.problem.make_nodal_vector();
      const MeshLevel<2> &level  = scene.meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const std::vector<Point<2>> points =
            level.bodies[b]->node_positions();
          for (unsigned int i = 0; i < points.size(); ++i)
            for (unsigned int c = 0; c < 2; ++c)
              result.local_element(level.node(b, i) * 2 + c) =
                exact.value(points[i], 0., order)[c];
        }
      return result;
    }

    NodalVector
    body_force(const double time)
    {
      NodalVector raw = scene.problem.make_nodal_vector();
      for_each_point([&](const FEValues<2>           &fe_values,
                         const unsigned int           q,
                         const std::vector<unsigned> &nodes) {
        const Tensor<1, 2> f =
          exact.body_force(fe_values.quadrature_point(q), time);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int c = 0; c < 2; ++c)
            raw.local_element(nodes[i] * 2 + c) +=
              f[c] * fe_values.shape_value(i, q) * fe_values.JxW(q);
      });
      // The force on a hanging node acts on those that carry it.
      const MeshLevel<2> &level = scene.meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
          for (unsigned int c = 0; c < 2; ++c)
            {
              double &load =
                raw.local_element(level.node(b, line.index) * 2 + c);
              for (const auto &entry : line.entries)
                raw.local_element(level.node(b, entry.first) * 2 + c) +=
                  entry.second * load;
              load = 0.;
            }
      return raw;
    }

    template <typename Action>
    void
    for_each_point(const Action &action) const
    {
      const QGauss<2>     quadrature(4);
      const MeshLevel<2> &level = scene.meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const DoFHandler<2> &dofs = level.bodies[b]->dof_handler();
          FEValues<2>          fe_values(dofs.get_fe(),
                                quadrature,
                                update_values | update_gradients |
                                  update_quadrature_points | update_JxW_values);
          std::vector<types::global_dof_index> indices(
            dofs.get_fe().n_dofs_per_cell());
          std::vector<unsigned> nodes(indices.size());
          for (const auto &cell : dofs.active_cell_iterators())
            {
              fe_values.reinit(cell);
              cell->get_dof_indices(indices);
              for (unsigned int i = 0; i < nodes.size(); ++i)
                nodes[i] = level.node(b, indices[i]);
              for (const unsigned int q : fe_values.quadrature_point_indices())
                action(fe_values, q, nodes);
            }
        }
    }
  };



  /** Orders in h of the errors, with steps as fine as the mesh. */
  void
  expect_orders(const std::vector<BodyGeometry<2>> &bodies,
                const unsigned int                  first)
  {
    std::vector<std::array<double, 2>> errors;
    for (const unsigned int refinements : {first, first + 1, first + 2})
      {
        Wave wave(halved<2>(bodies, refinements));
        wave.run(10u << refinements);
        errors.push_back(wave.errors());
        std::cout << "errors " << errors.back()[0] << ' ' << errors.back()[1]
                  << '\n';
      }
    for (unsigned int n = 1; n < errors.size(); ++n)
      {
        EXPECT_NEAR(std::log2(errors[n - 1][0] / errors[n][0]), 2., 0.15);
        EXPECT_NEAR(std::log2(errors[n - 1][1] / errors[n][1]), 1., 0.1);
      }
  }
} // namespace



TEST(ManufacturedSolution, OneBody)
{
  expect_orders(stack<2>({make_body<2>(1., {{10, 2}}, 0)}), 1);
}



TEST(ManufacturedSolution, AcrossAWeldedFault)
{
  // Meshes that do not match, with hanging nodes next to the fault; the strip
  // of smaller cells takes up less and less of the bodies.
  expect_orders(stack<2>({make_body<2>(0.5, {{10, 1}}, 1),
                          make_body<2>(0.5, {{14, 1}}, 1)}),
                2);
}



TEST(ManufacturedSolution, NearlyIncompressible)
{
  // The curl alone, which changes no volume, with hanging nodes and a fault.
  const auto errors = [](const VolumetricStrain strain, const double nu) {
    Material material          = thick();
    material.poissons_ratio    = nu;
    material.volumetric_strain = strain;
    Wave wave(halved<2>(stack<2>({make_body<2>(0.5, {{10, 1}}, 1),
                                  make_body<2>(0.5, {{14, 1}}, 1)}),
                        2),
              {material, 0.});
    wave.run(40);
    return wave.errors();
  };
  const auto compressible = errors(VolumetricStrain::full, 0.3);
  const auto locked       = errors(VolumetricStrain::full, 0.4999);
  const auto cured        = errors(VolumetricStrain::patch_mean, 0.4999);
  const auto mean         = errors(VolumetricStrain::patch_mean, 0.3);
  for (const auto &e : {compressible, locked, cured, mean})
    std::cout << "errors " << e[0] << ' ' << e[1] << '\n';
  for (const unsigned int k : {0, 1})
    {
      EXPECT_GT(locked[k], 1.5 * compressible[k]);
      EXPECT_LT(cured[k], 1.2 * compressible[k]);
      EXPECT_LT(mean[k], 1.2 * compressible[k]);
    }
}



TEST(ManufacturedSolution, SecondOrderInTime)
{
  std::vector<NodalVector> solutions;
  for (const unsigned int n_steps : {10, 20, 40})
    {
      Wave wave(stack<2>(
        {make_body<2>(0.5, {{10, 1}}, 1), make_body<2>(0.5, {{14, 1}}, 1)}));
      wave.run(n_steps);
      solutions.push_back(wave.state.displacement);
    }
  solutions[0] -= solutions[1];
  solutions[1] -= solutions[2];
  EXPECT_NEAR(std::log2(solutions[0].l2_norm() / solutions[1].l2_norm()),
              2.,
              0.15);
}
