// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>

#include <algorithm>
#include <cmath>

#include "falling_block.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Problem = SpatialProblem<2>;

  /** One in a direction at the nodes of a body, zero at the others, in the jump
   * basis. */
  NodalVector
  translation(OpeningScene<2>   &scene,
              const unsigned int body,
              const unsigned int direction)
  {
    const MeshLevel<2> &level = scene.meshes.finest();
    NodalVector         e     = scene.problem.make_nodal_vector();
    for (unsigned int i = 0; i < level.bodies[body]->node_positions().size();
         ++i)
      e.local_element(level.nodes.local_index(level.global_node(body, i)) * 2 +
                      direction) = 1.;
    NodalVector jumps = scene.problem.make_vector();
    scene.problem.to_jumps(jumps, e);
    return jumps;
  }



  NodalVector
  in_jumps(OpeningScene<2> &scene, const NodalVector &nodal)
  {
    NodalVector w = scene.problem.make_vector();
    scene.problem.to_jumps(w, nodal);
    return w;
  }



  NodalVector
  times_mass(OpeningScene<2> &scene, const NodalVector &w)
  {
    NodalVector product = scene.problem.make_vector();
    scene.problem.term(Problem::mass).vmult(product, w);
    return product;
  }



  bool
  is_open(const SystemState<2> &state)
  {
    return *std::min_element(state.gap.begin(), state.gap.end()) > 0.;
  }
} // namespace



TEST(OpeningImpact, AThrownBodyFallsAndComesToRest)
{
  OpeningScene<2>      scene(falling_block,
                        {"Bodies/block/Uniform refinements=2",
                              "Bodies/foundation/Uniform refinements=2",
                              "Bodies/foundation/Material/Shear viscosity=3e5",
                              "Bodies/foundation/Material/Bulk viscosity=3e5",
                              "Bodies/block/Material/Shear viscosity=3e5",
                              "Bodies/block/Material/Bulk viscosity=3e5"});
  const SystemState<2> at_rest = scene.state;
  scene.start_free(thrown(0., 1.));
  const NodalVector e = translation(scene, 1, 1), M_e = times_mass(scene, e);
  const double      mass = e * M_e;
  EXPECT_NEAR(mass, 5000. * 1.9 * 0.8, 1e-9 * mass);

  // Velocity and height of the centre of mass.
  const double tau         = 2e-3;
  bool         flies       = true;
  double       last_impact = 0.;
  while (scene.state.time < 1.2)
    {
      const StepResult<2> step = scene.advance(tau);
      ASSERT_TRUE(step.converged) << step.failure;
      const double t = scene.state.time;
      flies          = flies && is_open(scene.state);
      if (flies)
        {
          const double v = (M_e * in_jumps(scene, scene.state.velocity)) / mass,
                       u = (M_e * in_jumps(scene, scene.state.displacement)) /
                           mass;
          EXPECT_NEAR((1. - v) / t, 9.81, 1e-6 * 9.81);
          EXPECT_NEAR(2. * (t - u) / (t * t), 9.81, 1e-6 * 9.81);
        }
      else if (step.contact_energy.lost > 0.)
        last_impact = t;
    }
  // The block is away for 2 v / g, and a little for the gap.
  EXPECT_FALSE(flies);
  EXPECT_LT(last_impact, 1.);
  EXPECT_EQ(*std::max_element(scene.state.gap.begin(), scene.state.gap.end()),
            0.);
  EXPECT_LT(scene.energy->kinetic_energy(scene.state), 1e-6 * mass / 2.);

  // Pressures carry the weight.
  double force = 0.;
  for (unsigned int k = 0; k < scene.faults.size(); ++k)
    force += scene.faults.weights()[k] * scene.state.contact_pressure[k];
  EXPECT_NEAR(force, mass * 9.81, 1e-3 * mass * 9.81);
}



TEST(OpeningImpact, ChangesTheMomentumByItsImpulse)
{
  OpeningScene<2> scene(falling_block,
                        {"Bodies/block/Uniform refinements=2",
                         "Bodies/foundation/Uniform refinements=2"});
  scene.start_free(thrown(0.2, -1.));
  const NodalVector e        = translation(scene, 1, 1);
  const double      weight   = (e * times_mass(scene, e)) * 9.81;
  const auto        momentum = [&](const NodalVector &w) {
    return e * times_mass(scene, w);
  };
  const double start    = momentum(in_jumps(scene, scene.state.velocity));
  double       of_steps = 0., of_impacts = 0., worst = 0., elsewhere = 0.;
  unsigned int n_impacts = 0;
  const double tau       = 1e-3;
  while (scene.state.time < 0.1)
    {
      const SystemState<2> before = scene.state;
      const StepResult<2>  step   = scene.advance(tau);
      ASSERT_TRUE(step.converged) << step.failure;
      const NodalVector v0 = in_jumps(scene, before.velocity),
                        v1 = in_jumps(scene, scene.state.velocity);
      // The velocity before sides that touch have stopped: u1 - u0 = tau/2 (v0
      // + w).
      NodalVector w = in_jumps(scene, scene.state.displacement);
      w -= in_jumps(scene, before.displacement);
      w *= 2. / tau;
      w -= v0;
      double impulse = 0.;
      for (unsigned int k = 0; k < scene.faults.size(); ++k)
        {
          EXPECT_GE(scene.state.contact_pressure[k], -1e-6);
          impulse +=
            tau * scene.faults.weights()[k] * scene.state.contact_pressure[k];
        }
      worst =
        std::max(worst,
                 std::abs(momentum(w) - momentum(v0) + weight * tau - impulse) /
                   std::abs(start));
      of_steps += impulse;

      // Impacts act along the normal at what touches, and nowhere else.
      NodalVector stopped = v1;
      stopped -= w;
      NodalVector impact = times_mass(scene, stopped);
      scene.problem.hierarchy().finest().fixed.apply(impact);
      of_impacts += e * impact;
      for (unsigned int k = 0; k < scene.faults.size(); ++k)
        if (scene.state.gap[k] == 0. && scene.faults.in_contact(k))
          {
            double &entry = impact.local_element(scene.faults.node(k) * 2 + 1);
            n_impacts += std::abs(entry) > 1e-9 * std::abs(start);
            entry = 0.;
          }
      elsewhere = std::max(elsewhere, impact.linfty_norm() / std::abs(start));
    }
  const double end = momentum(in_jumps(scene, scene.state.velocity));
  EXPECT_GT(end, 0.);
  EXPECT_GT(n_impacts, 10u);
  EXPECT_GT(std::abs(of_impacts), 1e-4 * std::abs(start));
  EXPECT_LE(worst, 1e-10);
  EXPECT_LE(elsewhere, 1e-10);
  EXPECT_NEAR(end - start + weight * scene.state.time,
              of_steps + of_impacts,
              1e-9 * std::abs(start));
}



namespace
{
  /** Slip, slip rate, state and velocity after a number of steps of a block
   * that is drawn along while it is pressed down. */
  SystemState<2>
  drawn_block(const bool is_unilateral, const std::string &inertia)
  {
    OpeningScene<2> scene(
      falling_block,
      {"Bodies/block/Uniform refinements=2",
       "Bodies/foundation/Uniform refinements=2",
       "Faults/contact/Contact=" +
         std::string(is_unilateral ? "unilateral" : "bilateral"),
       "Faults/contact/Initial gap=0",
       "Faults/contact/Normal stress=function",
       "Faults/contact/Normal stress function=1e5 * (1 + 0.2 * x)",
       "Faults/contact/Characteristic slip=1e-5",
       "Boundary conditions/Sides=foundation bottom, block top",
       "Boundary conditions/block top/x condition=velocity",
       "Boundary conditions/block top/x value=4 * t",
       "Boundary conditions/block top/Ramp length=1e-3",
       "Boundary conditions/block top/y condition=traction",
       "Boundary conditions/block top/y value=-1e6",
       "Time/Inertia=" + inertia,
       "Time/Rate-state tolerance=1e-14",
       "TNNMG/Tolerance=1e-14"});
    // One normal stress for both, whatever the contact does.
    scene.step = std::make_unique<RateStateStep<2>>(scene.problem,
                                                    scene.faults,
                                                    scene.laws,
                                                    scene.scene.time,
                                                    scene.scene.tnnmg,
                                                    FollowingStress<2>(),
                                                    scene.contact);
    for (unsigned int i = 0; i < 60; ++i)
      {
        const StepResult<2> step = scene.advance(i % 3 == 0 ? 2e-3 : 1e-3);
        EXPECT_TRUE(step.converged) << step.failure;
        EXPECT_EQ(step.contact_energy.lost, 0.);
        for (const double gap : scene.state.gap)
          EXPECT_EQ(gap, 0.);
      }
    return scene.state;
  }



  void
  expect_equal(const NodalVector &a, const NodalVector &b)
  {
    NodalVector difference = a;
    difference -= b;
    EXPECT_LE(difference.linfty_norm(), 1e-12 * b.linfty_norm());
  }
} // namespace



TEST(OpeningImpact, WithoutOpeningIsBilateral)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic"})
    {
      SCOPED_TRACE(inertia);
      const SystemState<2> opens = drawn_block(true, inertia),
                           stays = drawn_block(false, inertia);
      expect_equal(opens.displacement, stays.displacement);
      expect_equal(opens.velocity, stays.velocity);
      double slip = 0., rate = 0., fastest = 0., farthest = 0.;
      for (unsigned int k = 0; k < opens.slip.size(); ++k)
        {
          slip = std::max(slip, std::abs((opens.slip[k] - stays.slip[k])[0]));
          rate =
            std::max(rate,
                     std::abs((opens.slip_rate[k] - stays.slip_rate[k])[0]));
          farthest = std::max(farthest, std::abs(stays.slip[k][0]));
          fastest  = std::max(fastest, std::abs(stays.slip_rate[k][0]));
          EXPECT_NEAR(opens.alpha[k], stays.alpha[k], 1e-10);
        }
      EXPECT_GT(farthest, 1e-5);
      EXPECT_LE(slip, 1e-12 * farthest);
      EXPECT_LE(rate, 1e-12 * fastest);
    }
}
