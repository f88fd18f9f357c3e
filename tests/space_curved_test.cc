// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>

#include "curved_bodies.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** One wave of an elevation of 0.05. */
  double
  wave(const double x)
  {
    return 0.05 * std::sin(2. * numbers::PI * x);
  }



  std::shared_ptr<const FaultShape<2>>
  wave_shape()
  {
    return std::make_shared<const GraphShape<2>>(1, [](const Point<2> &x) {
      return wave(x[0]);
    });
  }



  const Material material;



  /** Two bodies with one fault, some of whose sides are held at a displacement
   * that is known everywhere. */
  struct HeldBodies
  {
    using Displacement = std::function<Tensor<1, 2>(const Point<2> &)>;

    SpatialScene<2> scene;
    NodalVector     exact, u, w, force;

    /** @p held: body and side. */
    HeldBodies(const std::vector<CoarseBody<2>> &bodies,
               const FaultTopology              &topology,
               const std::vector<std::pair<unsigned int, unsigned int>> &held,
               const Displacement                                       &value)
      : scene(bodies,
              topology,
              conditions(topology, held),
              {material, material},
              Tensor<1, 2>())
    {
      exact = interpolate(scene.meshes.finest(),
                          [&](const unsigned int, const Point<2> &x) {
                            return value(x);
                          });
    }

    static std::vector<BoundaryCondition<2>>
    conditions(const FaultTopology &topology,
               const std::vector<std::pair<unsigned int, unsigned int>> &held)
    {
      std::vector<BoundaryCondition<2>> result;
      for (const auto &[body, side] : held)
        result.push_back(
          make_side<2>(topology.body_names()[body],
                       side,
                       {{BoundaryType::velocity, BoundaryType::velocity}}));
      return result;
    }

    const FaultContact<2> &
    fault() const
    {
      return scene.problem.jump_basis().faults()[0];
    }

    /** Solve with the fault stuck where @p is_stuck is true, sliding freely
     * elsewhere. Returns the number of iterations. */
    unsigned int
    solve(const double                                 reduction,
          const std::function<bool(const Point<2> &)> &is_stuck)
    {
      SpatialProblem<2> &problem = scene.problem;
      const NodeMask     dirichlet =
        scene.boundary.dirichlet_mask(scene.meshes.n_levels() - 1);
      u = exact;
      for (unsigned int i = 0; i < dirichlet.n_nodes(); ++i)
        for (unsigned int c = 0; c < 2; ++c)
          if (dirichlet.is_active(i, c))
            u.local_element(i * 2 + c) = 0.;
      w     = problem.make_vector();
      force = w;
      problem.to_jumps(w, u);
      NodeMask active = problem.hierarchy().finest().fixed;
      for (unsigned int k = 0; k < fault().slave.nodes.size(); ++k)
        if (fault().coupling.active[k])
          {
            const unsigned int p = fault().slave.nodes[k];
            for (unsigned int c = 0; c < 2; ++c)
              w.local_element(p * 2 + c) = 0.;
            if (is_stuck(fault().slave.points[k]))
              active.mask_node(p);
          }
      const unsigned int iterations = solve_linear(
        problem, {0., 0., 1.}, active, problem.load(0.), w, reduction);
      problem.to_nodal(u, w);
      problem.operators().matrix().residual(force, problem.load(0.), w);
      return iterations;
    }

    /** The largest error of a node over the largest displacement. */
    double
    displacement_error() const
    {
      NodalVector error = u;
      error -= exact;
      for_each_node(scene.meshes.finest(),
                    [&](const unsigned int,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2> &,
                        const bool hanging) {
                      if (hanging)
                        for (unsigned int c = 0; c < 2; ++c)
                          error.local_element(node * 2 + c) = 0.;
                    });
      return error.linfty_norm() / exact.linfty_norm();
    }

    double
    energy_error() const
    {
      const auto energy = [&](const NodalVector &nodal) {
        NodalVector v = scene.problem.make_vector(), f = v;
        scene.problem.to_jumps(v, nodal);
        scene.problem.operators().matrix().vmult(f, v);
        return v * f;
      };
      NodalVector error = u;
      error -= exact;
      return std::sqrt(energy(error) / energy(exact));
    }

    /** Tractions at the k-th slave node on the upper or outer body, Pa, in the
     * axes of space. */
    Tensor<1, 2>
    traction(const unsigned int k) const
    {
      Tensor<1, 2> components;
      for (unsigned int c = 0; c < 2; ++c)
        components[c] = fault().sides.sign() / fault().coupling.weight[k] *
                        force.local_element(fault().slave.nodes[k] * 2 + c);
      return fault().axes.are_those_of_space() ?
               components :
               fault().axes.at(k) * components;
    }
  };



  bool
  everywhere(const Point<2> &)
  {
    return true;
  }



  bool
  on_the_left(const Point<2> &x)
  {
    return x[0] < 0.5;
  }



  /** All sides of two layers but the fault. */
  const std::vector<std::pair<unsigned int, unsigned int>> around =
    {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 3}};

  const Tensor<2, 2> gradient({{1e-4, -3e-4}, {2e-4, -2.5e-4}});

  Tensor<1, 2>
  linear(const Point<2> &x)
  {
    return gradient * x;
  }



  Tensor<2, 2>
  stress()
  {
    const double mu     = material.shear_modulus();
    Tensor<2, 2> result = mu * (gradient + transpose(gradient));
    for (unsigned int d = 0; d < 2; ++d)
      result[d][d] += material.lame_lambda() * trace(gradient);
    return result;
  }



  struct Errors
  {
    double displacement, energy, traction;
  };



  /** Errors of a constant state of stress in two layers that are welded along a
   * wave, with so many coarse faces a wave. */
  Errors
  welded_errors(const unsigned int n_below,
                const unsigned int n_above,
                const unsigned int refinements,
                const bool         of_triangles)
  {
    const ShapedBodies<2> layers =
      two_layers_at(wave, n_below, n_above, n_below / 2, of_triangles);
    HeldBodies held(layers.coarse({wave_shape()}, refinements),
                    layers.topology,
                    around,
                    linear);
    held.solve(1e-12, everywhere);
    Errors errors = {held.displacement_error(), held.energy_error(), 0.};
    for (unsigned int k = 0; k < held.fault().slave.nodes.size(); ++k)
      if (held.fault().coupling.active[k])
        {
          const Point<2> &x = held.fault().slave.points[k];
          Tensor<1, 2>    normal(
            {-0.1 * numbers::PI * std::cos(2. * numbers::PI * x[0]), 1.});
          normal /= normal.norm();
          errors.traction =
            std::max(errors.traction,
                     (held.traction(k) - stress() * normal).norm() /
                       stress().norm());
        }
    return errors;
  }



  class Circle : public FaultShape<2>
  {
  public:
    explicit Circle(const double radius)
      : radius(radius)
    {}

    virtual Point<2>
    place(const Point<2> &x) const override
    {
      return Point<2>(radius / x.norm() * x);
    }

  private:
    double radius;
  };



  /** Rings all of whose sides are circles on all levels. */
  std::vector<CoarseBody<2>>
  round_rings(const ShapedBodies<2>       &rings,
              const std::array<double, 3> &radii,
              const unsigned int           refinements)
  {
    std::vector<CoarseBody<2>> bodies =
      rings.coarse({std::make_shared<Circle>(radii[1])}, refinements);
    for (unsigned int b = 0; b < 2; ++b)
      {
        const auto cells = std::make_shared<Triangulation<2>>();
        cells->copy_triangulation(*bodies[b].cells);
        set_shapes<2>(*cells,
                      {{2, std::make_shared<Circle>(radii[b])},
                       {3, std::make_shared<Circle>(radii[b + 1])}});
        bodies[b].cells = cells;
      }
    return bodies;
  }



  /** The two rings of a disc of radius one in a larger one, the inner one of
   * which is turned at its inner side. */
  struct TurnedRings : HeldBodies
  {
    static constexpr double a = 0.5, c = 2.;

    TurnedRings(const std::vector<CoarseBody<2>> &bodies,
                const FaultTopology              &topology)
      : HeldBodies(bodies, topology, {{0, 2}, {1, 3}}, [](const Point<2> &x) {
        const double B = a * a * c * c / (c * c - a * a);
        return (B / x.norm_square() - B / (c * c)) *
               Tensor<1, 2>({-x[1], x[0]});
      })
    {}

    /** Shear traction at radius one, Pa. */
    static double
    exact_traction()
    {
      return 2. * material.shear_modulus() * a * a * c * c / (c * c - a * a);
    }
  };
} // namespace



TEST(CurvedFault, RotationsHaveNoJump)
{
  for (const auto &n : {std::array<unsigned int, 2>{{40, 30}},
                        std::array<unsigned int, 2>{{30, 40}}})
    for (const bool of_triangles : {false, true})
      {
        const ShapedBodies<2> rings =
          two_rings({{0.5, 1., 2.}}, n[0], n[1], 4, of_triangles);
        const TurnedRings held(rings.smooth(1), rings.topology);
        const auto       &problem = held.scene.problem;
        ASSERT_EQ(std::max(held.fault().slave.nodes.size(),
                           held.fault().master.nodes.size()),
                  80u);
        // Both bodies, then the inner one alone: it slips and does not open.
        for (const bool both : {true, false})
          {
            const NodalVector turned = interpolate(
              held.scene.meshes.finest(),
              [&](const unsigned int b, const Point<2> &x) {
                return (both || b == 0 ? 1. : 0.) * Tensor<1, 2>({-x[1], x[0]});
              });
            NodalVector w = problem.make_vector();
            problem.to_jumps(w, turned);
            double slip = 0., opening = 0.;
            for (const unsigned int p : problem.jump_basis().contact_nodes())
              {
                slip = std::max(slip, std::abs(w.local_element(p * 2)));
                opening =
                  std::max(opening, std::abs(w.local_element(p * 2 + 1)));
              }
            EXPECT_LT(opening, 2e-6);
            if (both)
              EXPECT_LT(slip, 1e-13);
            else
              EXPECT_NEAR(slip, 1., 1e-3);
          }
      }
}



// Rings all of whose nodes are on circles, and such that are refined from 20
// faces: nodes inside are not on circles then.
TEST(CurvedFault, TractionBetweenRingsIsUniform)
{
  const std::array<double, 3> radii = {{0.5, 1., 2.}};
  for (const bool of_triangles : {false, true})
    for (const unsigned int refinements : {0, 2})
      {
        const unsigned int    n = 80 >> refinements;
        const ShapedBodies<2> rings =
          two_rings(radii, n, n / 4 * 3, 16 >> refinements, of_triangles);
        TurnedRings held(round_rings(rings, radii, refinements),
                         rings.topology);
        held.solve(1e-12, everywhere);
        double least = 1e300, most = 0.;
        for (unsigned int k = 0; k < held.fault().slave.nodes.size(); ++k)
          {
            const Point<2> x = held.fault().slave.points[k];
            const double   tau =
              std::abs(held.traction(k) * Tensor<1, 2>({-x[1], x[0]})) /
              x.norm();
            least = std::min(least, tau);
            most  = std::max(most, tau);
          }
        const double mean =
          0.5 * (least + most) / TurnedRings::exact_traction();
        std::cout << (of_triangles ? "triangles" : "quadrilaterals")
                  << ", refined " << refinements << " times: spread "
                  << most / least - 1. << ", mean off by " << mean - 1. << '\n';
        EXPECT_LT(most / least - 1., refinements == 0 ? 4e-4 : 0.03);
        EXPECT_NEAR(mean, 1., 0.01);
      }
}



TEST(CurvedFault, OrdersOfAWeldedWave)
{
  struct Case
  {
    unsigned int n_below, n_above;
    double       most_traction;
  };
  for (const bool of_triangles : {false, true})
    for (const Case &c : {Case{8, 6, 1.4e-2}, Case{8, 4, 0.12}})
      {
        std::vector<Errors> errors;
        for (unsigned int r = 1; r <= 5; ++r)
          {
            errors.push_back(
              welded_errors(c.n_below, c.n_above, r, of_triangles));
            std::cout << c.n_below << ':' << c.n_above
                      << (of_triangles ? " triangles " : " quadrilaterals ")
                      << (c.n_below << r) << " a wave: displacement "
                      << errors.back().displacement << ", energy "
                      << errors.back().energy << ", traction "
                      << errors.back().traction << '\n';
          }
        const auto order = [&](const auto error) {
          return std::log2(errors[1].*error / errors[4].*error) / 3.;
        };
        const auto last_order = [&](const unsigned int r) {
          return std::log2(errors[r - 1].traction / errors[r].traction);
        };
        std::cout << "orders of the traction: " << last_order(2) << ", "
                  << last_order(3) << ", " << last_order(4) << '\n';
        EXPECT_GT(order(&Errors::displacement), 1.9);
        EXPECT_GT(order(&Errors::energy), 1.5);
        EXPECT_GT(order(&Errors::traction), 0.99);
        EXPECT_LT(errors[1].traction, c.most_traction);
      }
}



TEST(CurvedFault, AWeldedWaveOfMatchingMeshesIsExact)
{
  for (const bool of_triangles : {false, true})
    {
      const Errors errors = welded_errors(8, 8, 2, of_triangles);
      EXPECT_LT(errors.displacement, 1e-11);
      EXPECT_LT(errors.energy, 1e-10);
    }
}



// Built-in bodies, whose cells grow with the distance from the fault.
TEST(CurvedFault, AWeldedWaveOfGradedBricksIsExact)
{
  std::vector<CoarseBody<2>> bodies;
  for (const unsigned int b : {0, 1})
    {
      BodyGeometry<2> brick;
      brick.lateral_lower[0]  = 0.;
      brick.lateral_upper[0]  = 1.;
      brick.base              = b == 0 ? -0.5 : 0.;
      brick.thickness         = 0.5;
      brick.coarse_cells      = {{8, 4}};
      brick.refinement_passes = 3;
      (b == 0 ? brick.upper_elevation : brick.lower_elevation) =
        [](const Point<2> &x) { return wave(x[0]); };
      bodies.push_back(coarse_brick(brick));
    }
  HeldBodies held(bodies,
                  stack_topology<2>({"lower", "upper"}, {"main"}),
                  around,
                  linear);
  held.solve(1e-13, everywhere);
  EXPECT_LT(held.displacement_error(), 1e-11);
  EXPECT_LT(held.energy_error(), 1e-10);
}



namespace
{
  /** Iterations over one to five refinements beside a fault on a curve. */
  std::vector<unsigned int>
  iterations_over_refinements(const std::function<double(double)> &curve,
                              std::shared_ptr<const FaultShape<2>> shape,
                              const bool                           of_triangles)
  {
    const ShapedBodies<2> layers = two_layers_at(curve, 8, 6, 3, of_triangles);
    std::vector<unsigned int> result;
    for (unsigned int r = 1; r <= 5; ++r)
      {
        HeldBodies held(layers.coarse({shape}, r),
                        layers.topology,
                        around,
                        linear);
        result.push_back(held.solve(1e-8, on_the_left));
        std::cout << ' ' << result.back();
      }
    std::cout << '\n';
    return result;
  }
} // namespace



// Half of the fault is stuck, the other slides freely.
TEST(CurvedFault, IterationsAreThoseOfALevelFault)
{
  for (const bool of_triangles : {false, true})
    {
      std::cout << (of_triangles ? "triangles" : "quadrilaterals")
                << ", level, dipping, curved:\n";
      const auto of_level =
                   iterations_over_refinements([](const double) { return 0.; },
                                               nullptr,
                                               of_triangles),
                 of_dip = iterations_over_refinements(
                   [](const double x) { return 0.314 * (x - 0.5); },
                   nullptr,
                   of_triangles),
                 of_wave = iterations_over_refinements(wave,
                                                       wave_shape(),
                                                       of_triangles);
      for (unsigned int i = 0; i < 5; ++i)
        {
          EXPECT_LE(of_wave[i], of_level[i] + 1);
          EXPECT_LE(of_dip[i], of_level[i] + 2);
        }
      EXPECT_LE(of_wave[4], of_wave[2] + 1);
    }
}
