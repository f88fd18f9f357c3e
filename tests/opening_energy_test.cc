// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>

#include <random>

#include "falling_block.h"
#include "shaken_block.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Load, friction and displacement at one state, in the jump basis. */
  struct Forces
  {
    NodalVector         load, u;
    std::vector<double> friction;

    Forces(OpeningScene<2> &scene, const SystemState<2> &state)
      : load(scene.problem.load(state.time))
      , u(scene.problem.make_vector())
    {
      scene.problem.to_jumps(u, state.displacement);
      for (unsigned int k = 0; k < scene.faults.size(); ++k)
        friction.push_back(
          scene.faults.weights()[k] *
          shear_traction(scene.faults, scene.laws, state, k)[0]);
    }
  };



  /** Energy never rises by more than the work, with steps that change at random
   * by a factor of eight, while the block lands and bounces. */
  void
  expect_balance(const std::vector<std::string> &overrides)
  {
    OpeningScene<2> scene(falling_block, overrides);
    scene.start_free(thrown(0.3, -0.5));
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> exponent(-1.5, 1.5);
    const double                           start   = scene.total_energy();
    double                                 lost    = 0.;
    unsigned int                           changes = 0;
    while (scene.state.time < 0.2)
      {
        const SystemState<2> before        = scene.state;
        const double         energy_before = scene.total_energy();
        const Forces         f0(scene, before);
        const double         tau    = 1e-3 * std::exp2(exponent(generator));
        const StepResult<2>  result = scene.advance(tau);
        ASSERT_TRUE(result.converged) << result.failure;
        const Forces f1(scene, scene.state);
        NodalVector  du = f1.u, sum = f0.load;
        du -= f0.u;
        sum += f1.load;
        const double of_loads    = 0.5 * (sum * du);
        double       of_friction = 0.;
        for (unsigned int k = 0; k < scene.faults.size(); ++k)
          of_friction += 0.5 * (f0.friction[k] + f1.friction[k]) *
                         (scene.state.slip[k] - before.slip[k])[0];
        // The mean velocity of the step is that of the mean viscous force.
        double dissipated = 0.;
        if (scene.problem.has(SpatialProblem<2>::damping))
          {
            scene.problem.term(SpatialProblem<2>::damping).vmult(sum, du);
            dissipated = (sum * du) / tau;
          }
        EXPECT_GE(dissipated, -1e-12 * start);
        EXPECT_GE(result.contact_energy.lost, 0.);
        const double terms =
          std::abs(of_loads) + std::abs(of_friction) + dissipated;
        lost += result.contact_energy.lost;
        const double defect = scene.total_energy() - energy_before - of_loads +
                              of_friction + dissipated +
                              result.contact_energy.lost;
        EXPECT_LE(std::abs(defect), 1e-8 * terms)
          << "at " << scene.state.time << " s";
        for (unsigned int k = 0; k < scene.faults.size(); ++k)
          changes += (before.gap[k] > 0.) != (scene.state.gap[k] > 0.);
      }
    EXPECT_GE(changes, 100u);
    EXPECT_GT(lost, 1e-4 * start);
    EXPECT_LT(lost, 0.1 * start);
  }
} // namespace



TEST(OpeningEnergy, NeverRisesWithRandomSteps)
{
  expect_balance({});
}



TEST(OpeningEnergy, NeverRisesWithViscosity)
{
  expect_balance({"Bodies/block/Material/Shear viscosity=1e4",
                  "Bodies/block/Material/Bulk viscosity=1e4"});
}



TEST(OpeningEnergy, IsBalancedWithDrivenSides)
{
  // Sides that are held at a velocity do work in impacts, too: through a rigid
  // table all of it, through an elastic one what the mass hands down at once.
  for (const std::string is_rigid : {"true", "false"})
    {
      SCOPED_TRACE(is_rigid);
      OpeningScene<2> scene(shaken_block,
                            {"Bodies/table/Rigid=" + is_rigid,
                             "Bodies/table/Coarse cells=4, 1",
                             "Bodies/table/Uniform refinements=1",
                             "Bodies/table/Refinement passes=0",
                             "Boundary conditions/table bottom/Ramp length=0",
                             "Time/Rate-state tolerance=1e-11",
                             "TNNMG/Tolerance=1e-12"});
      scene.energy->start(scene.state);
      double worst = 0.;
      for (unsigned int i = 0; i < 150; ++i)
        {
          const StepResult<2> step = scene.advance(1e-3 * (1 + i % 3));
          ASSERT_TRUE(step.converged) << step.failure;
          scene.energy->add(
            step, shear_tractions(scene.faults, scene.laws, step.state));
          worst = std::max(worst, std::abs(scene.energy->defect(scene.state)));
        }
      const EnergyTerms &work = scene.energy->work();
      EXPECT_GT(work.contact, 1e-3 * work.largest());
      EXPECT_LE(worst, 1e-9 * work.largest());
    }
}
