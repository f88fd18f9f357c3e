// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>

#include <algorithm>
#include <cmath>

#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** An elastic body without mass, 1 m thick, glued to a rigid one; stretching
   * it by 1 m takes 1e7 Pa. */
  const char *const glued_body = R"(
subsection Bodies
  set Names          = wall, body
  set Base elevation = -1
  subsection wall
    set Lower lateral corner = -10
    set Upper lateral corner = 10
    set Thickness            = 1
    set Rigid                = true
  end
  subsection body
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 1
    set Coarse cells         = 2, 1
    set Uniform refinements  = 3
    set Refinement passes    = 0
    subsection Material
      set Young modulus   = 1e7
      set Poisson ratio   = 0
      set Density         = 1000
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Friction         = frictionless
    set Contact          = unilateral
    set Tensile strength = 2e4
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 100
  set Inertia = quasi-static
end
subsection TNNMG
  set Tolerance = 1e-8
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** The conditions of the top as entries, with others. */
  std::vector<std::string>
  top(const std::string              &x,
      const std::string              &y,
      const std::vector<std::string> &others)
  {
    const std::string        side = "Boundary conditions/body top/";
    std::vector<std::string> all  = {"Boundary conditions/Sides=body top",
                                     side + "Ramp length=0",
                                     side + "x condition=" + x,
                                     side + "y condition=" + y};
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }



  double
  largest_gap(const SystemState<2> &state)
  {
    return *std::max_element(state.gap.begin(), state.gap.end());
  }



  /** Pull at 1e-3 m/s, push back from the fourth second on, and pull again from
   * the ninth. Times at which the fault opens, closes and opens again, s. */
  std::vector<double>
  times_of_change(const std::vector<std::string> &overrides, const double tau)
  {
    std::vector<std::string> all =
      top("fixed",
          "velocity",
          {"Boundary conditions/body top/y value="
           "if(t < 4, 1e-3, if(t < 9, -1e-3, 1e-3))"});
    all.insert(all.end(), overrides.begin(), overrides.end());
    OpeningScene<2>     scene(glued_body, all);
    std::vector<double> times;
    bool                is_open = false;
    while (scene.state.time < 15.)
      {
        const StepResult<2> step = scene.advance(tau);
        EXPECT_TRUE(step.converged) << step.failure;
        if (!step.converged)
          break;
        const unsigned int n_open =
          std::count_if(scene.state.gap.begin(),
                        scene.state.gap.end(),
                        [](const double gap) { return gap > 0.; });
        // A fault that is pulled evenly opens everywhere at once.
        EXPECT_TRUE(n_open == 0 || n_open == scene.state.gap.size()) << n_open;
        if (is_open != (n_open > 0))
          times.push_back(scene.state.time);
        is_open = n_open > 0;
      }
    return times;
  }
} // namespace



TEST(OpeningBonds, BreakAtTheirStrengthAndStayBroken)
{
  // 2e4 Pa take 2 s. The body is unloaded then, and touches again as the top is
  // back at t = 8; from -1 mm at 9 s on it is back at 10 s.
  for (const double tau : {0.03, 0.11})
    {
      const std::vector<double> times = times_of_change({}, tau);
      ASSERT_EQ(times.size(), 3u);
      EXPECT_NEAR(times[0], 2., 1.5 * tau);
      EXPECT_NEAR(times[1], 8., 1.5 * tau);
      EXPECT_NEAR(times[2], 10., 1.5 * tau);
    }
}



TEST(OpeningBonds, HealAfterTheirTime)
{
  // Contact lasts two seconds: enough for one bond, too short for the other.
  const double tau = 0.03;
  const std::vector<double>
    heals   = times_of_change({"Faults/contact/Bond healing time=1"}, tau),
    is_late = times_of_change({"Faults/contact/Bond healing time=4"}, tau);
  ASSERT_EQ(heals.size(), 3u);
  EXPECT_NEAR(heals[2], 12., 1.5 * tau);
  ASSERT_EQ(is_late.size(), 3u);
  EXPECT_NEAR(is_late[2], 10., 1.5 * tau);
}



TEST(OpeningBonds, BreakInARow)
{
  // A beam whose end is lifted and let down again.
  OpeningScene<2> scene(
    glued_body,
    {"Bodies/body/Lower lateral corner=0",
     "Bodies/body/Upper lateral corner=2",
     "Bodies/body/Thickness=0.1",
     "Bodies/body/Coarse cells=20, 1",
     "Bodies/body/Uniform refinements=1",
     "Faults/contact/Tensile strength=1e4",
     "TNNMG/Tolerance=1e-11",
     "Boundary conditions/Sides=body left, body right",
     "Boundary conditions/body left/x condition=fixed",
     "Boundary conditions/body right/y condition=velocity",
     "Boundary conditions/body right/Ramp length=0",
     "Boundary conditions/body right/y value=if(t < 2, 0.01, -0.01)",
     "Gravity/Acceleration=9.81"});
  const auto &points = scene.problem.jump_basis().faults().front().slave.points;
  double      front = 2.1, most = 0., missing = 0.;
  unsigned int n_breaks = 0;
  scene.energy->start(scene.state);
  const double tau = 0.02;
  while (scene.state.time < 4.)
    {
      const std::vector<char> before = scene.state.is_bonded;
      const StepResult<2>     step   = scene.advance(tau);
      ASSERT_TRUE(step.converged) << step.failure;
      scene.energy->add(step,
                        shear_tractions(scene.faults, scene.laws, step.state));
      missing = std::max(missing, std::abs(scene.energy->defect(scene.state)));
      double bonded = 0., broken = 2.1;
      for (unsigned int k = 0; k < points.size(); ++k)
        {
          // The last one is on the side that is lifted.
          if (!scene.faults.in_contact(k))
            continue;
          EXPECT_LE(scene.state.is_bonded[k], before[k]);
          if (before[k] && !scene.state.is_bonded[k])
            ++n_breaks;
          if (scene.state.is_bonded[k])
            {
              bonded = std::max(bonded, points[k][0]);
              EXPECT_EQ(scene.state.gap[k], 0.);
              EXPECT_GE(scene.state.contact_pressure[k], -1e4 * (1. + 1e-9));
            }
          else
            broken = std::min(broken, points[k][0]);
        }
      // One front, which never goes back.
      EXPECT_LT(bonded, broken);
      EXPECT_LE(broken, front);
      front = broken;
      most  = std::max(most, largest_gap(scene.state));
    }
  EXPECT_GT(n_breaks, 8u);
  EXPECT_LT(n_breaks, points.size());
  // The first node beside the side that is lifted, by 0.02 m.
  EXPECT_GT(most, 0.016);
  EXPECT_LT(most, 0.02);
  EXPECT_LT(largest_gap(scene.state), 1e-3);
  // Bonds pull to the end of the step in which they break.
  EXPECT_LE(missing, 1e-8 * scene.energy->work().largest());
}



TEST(OpeningBonds, CohesionForbidsSlipUntilItIsBroken)
{
  const double mu = 0.4, cohesion = 5e3;
  for (const std::string friction : {"Coulomb", "velocity strengthening"})
    {
      SCOPED_TRACE(friction);
      OpeningScene<2> scene(
        glued_body,
        top("velocity",
            "traction",
            {"Faults/contact/Friction=" + friction,
             "Faults/contact/Reference friction coefficient=0.4",
             "Faults/contact/a=0.01",
             "Faults/contact/Reference slip rate=1e-3",
             "Faults/contact/Characteristic slip=1e-3",
             "Faults/contact/Tensile strength=0",
             "Faults/contact/Cohesion=5e3",
             "Boundary conditions/body top/x value=1e-3",
             "Boundary conditions/body top/y value=-2e4",
             "Time/Rate-state tolerance=1e-7"}));
      unsigned int n_broken = 0, n_together = 0;
      double       largest = 0.;
      while (scene.state.time < 6.)
        {
          const SystemState<2> before = scene.state;
          const StepResult<2>  step   = scene.advance(0.05);
          ASSERT_TRUE(step.converged) << step.failure;
          const SystemState<2> &now = scene.state;
          n_broken                  = 0;
          for (unsigned int k = 0; k < scene.faults.size(); ++k)
            {
              const double traction =
                shear_traction(scene.faults, scene.laws, now, k).norm();
              if (now.is_bonded[k])
                {
                  EXPECT_EQ(now.slip[k][0], 0.);
                  ++n_together;
                  largest =
                    std::max(largest, traction - mu * now.normal_stress[k]);
                  if (friction == "Coulomb")
                    {
                      EXPECT_LE(traction,
                                mu * now.normal_stress[k] + cohesion + 1.);
                    }
                  continue;
                }
              ++n_broken;
              EXPECT_TRUE(!before.is_bonded[k] || now.slip_rate[k][0] != 0. ||
                          now.gap[k] > 0.);
              // Without cohesion from the next step on.
              if (!before.is_bonded[k] && friction == "Coulomb")
                {
                  EXPECT_LE(traction, mu * now.normal_stress[k] + 1.);
                }
            }
        }
      EXPECT_EQ(n_broken, scene.faults.size());
      EXPECT_GT(n_together, scene.faults.size());
      // Friction at rest is less than mu0 where it grows with the slip rate.
      EXPECT_GT(largest, (friction == "Coulomb" ? 0.9 : 0.5) * cohesion);
    }
}
