// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/problem/shear_traction.h>

#include <random>

#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A block above an elastic foundation, with meshes that do not match. */
  const char *const falling_block = R"(
subsection Bodies
  set Names          = foundation, block
  set Base elevation = -1
  subsection foundation
    set Lower lateral corner = -1.5
    set Upper lateral corner = 1.5
    set Thickness            = 1
    set Coarse cells         = 3, 1
    set Uniform refinements  = 3
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
  subsection block
    set Lower lateral corner = -1
    set Upper lateral corner = 0.9
    set Thickness            = 0.8
    set Coarse cells         = 3, 1
    set Uniform refinements  = 3
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Contact     = unilateral
    set Initial gap = 0.001 + 0.0005 * x
    set Reference slip rate = 0.01
    set Characteristic slip = 1e-3
  end
end
subsection Boundary conditions
  set Sides = foundation bottom
  subsection foundation bottom
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Gravity
  set Acceleration = 9.81
end
subsection Time
  set End time = 1
  set Rate-state tolerance = 1e-11
end
subsection TNNMG
  set Tolerance = 1e-11
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** Forces of the terms of energy at one state, and what they are conjugate
   * to, in the jump basis. */
  struct Forces
  {
    NodalVector         load, u;
    std::vector<double> friction;
  };



  Forces
  forces(OpeningScene<2> &scene, const SystemState<2> &state)
  {
    Forces result;
    result.load = scene.problem.load(state.time);
    result.u    = scene.problem.make_vector();
    scene.problem.to_jumps(result.u, state.displacement);
    for (unsigned int k = 0; k < scene.faults.size(); ++k)
      result.friction.push_back(
        scene.faults.weights()[k] *
        shear_traction(scene.faults, scene.laws, state, k)[0]);
    return result;
  }
} // namespace



TEST(OpeningEnergy, NeverRisesWithRandomSteps)
{
  OpeningScene<2> scene(falling_block);
  scene.start_free([](const unsigned int body, const Point<2> &) {
    Tensor<1, 2> v;
    if (body == 1)
      v[0] = 0.3, v[1] = -0.5;
    return v;
  });
  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> exponent(-1.5, 1.5);
  double       work = 0, worst = 0, lost = 0, fric = 0;
  unsigned int changes = 0, its = 0, n = 0;
  const double start = scene.total_energy();
  while (scene.state.time < 0.3)
    {
      const SystemState<2> before        = scene.state;
      const double         energy_before = scene.total_energy();
      const Forces         f0            = forces(scene, before);
      const double         tau    = 1e-3 * std::exp2(exponent(generator));
      const auto           result = scene.advance(tau);
      ASSERT_TRUE(result.converged) << result.failure;
      const Forces f1 = forces(scene, scene.state);
      NodalVector  du = f1.u, load = f0.load;
      du -= f0.u;
      load += f1.load;
      double step_work = 0.5 * (load * du), friction = 0.;
      for (unsigned int k = 0; k < scene.faults.size(); ++k)
        friction += 0.5 * (f0.friction[k] + f1.friction[k]) *
                    (scene.state.slip[k] - before.slip[k])[0];
      const double defect = scene.total_energy() - energy_before - step_work +
                            friction + result.contact_energy.lost;
      EXPECT_GE(result.contact_energy.lost, -1e-12 * start);
      lost += result.contact_energy.lost;
      fric += friction;
      work += std::abs(step_work);
      worst = std::max(worst, std::abs(defect));
      its += result.counts.tnnmg_iterations;
      ++n;
      unsigned int open = 0;
      for (unsigned int k = 0; k < scene.faults.size(); ++k)
        {
          changes += (before.gap[k] > 0.) != (scene.state.gap[k] > 0.);
          open += scene.state.gap[k] > 0.;
        }
      if (std::getenv("TALK"))
        std::cout << scene.state.time << ' ' << tau << " open " << open << '/'
                  << scene.faults.size() << " defect " << defect << " lost "
                  << result.contact_energy.lost << " friction " << friction
                  << " E " << scene.total_energy() << " its "
                  << result.counts.tnnmg_iterations << '\n';
    }
  std::cout << "work " << work << " worst " << worst << " lost " << lost
            << " friction " << fric << " start " << start << " changes "
            << changes << " its " << double(its) / n << '\n';
}
