// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_step_errors_h
#define stickslip_tests_step_errors_h

#include <gtest/gtest.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stepping_scene.h"

namespace StickSlip::Tests
{
  /** The velocity scale of the bodies of a scene with one fault in full contact,
   * as StepHistory has it but for slip rates, m/s. */
  inline double
  velocity_scale(const SteppingScene &scene)
  {
    const std::vector<double> &areas = scene.faults.weights();
    double                     sum = 0., area = 0.;
    for (unsigned int k = 0; k < scene.faults.size(); ++k)
      {
        const FaultLaw &law = scene.laws[k];
        sum += areas[k] * law.friction->rate_scale() *
               scene.state.normal_stress[k] / law.shear_impedance;
        area += areas[k];
      }
    return sum / area;
  }



  /** The error of the last step of @p scene from @p before, found by steps of a
   * sixteenth, in the measures of StepHistory. */
  inline StepError
  error_of_last_step(SteppingScene        &scene,
                     const SystemState<2> &before,
                     const double          tau)
  {
    constexpr unsigned int n_parts = 16;

    SystemState<2> exact = before;
    for (unsigned int i = 0; i < n_parts; ++i)
      {
        const StepResult<2> part = scene.step->take(exact, tau / n_parts);
        EXPECT_TRUE(part.converged);
        exact = part.state;
      }
    StepError                  error;
    const SystemState<2>      &ours  = scene.state;
    const std::vector<double> &areas = scene.faults.weights();
    const std::vector<double>  stress =
      scene.faults.over_mean(ours.normal_stress);
    double area = 0., of_state = 0., of_motion = 0., fastest = 0.;
    for (unsigned int k = 0; k < scene.faults.size(); ++k)
      fastest = std::max({fastest,
                          magnitude(ours.slip_rate[k]),
                          magnitude(before.slip_rate[k])});
    for (unsigned int k = 0; k < scene.faults.size(); ++k)
      {
        const FaultLaw &law = scene.laws[k];
        const double    error_of_V =
                       magnitude(ours.slip_rate[k] - exact.slip_rate[k]),
                     in_friction = magnitude(
                       directed_friction(scene.faults, scene.laws, ours, k) -
                       directed_friction(scene.faults, scene.laws, exact, k)),
                     motion = std::min(
                       error_of_V /
                         std::max(fastest, law.characteristic_slip / tau),
                       in_friction * stress[k] / law.friction->rate_scale());
        area += areas[k];
        of_state += areas[k] * std::pow(ours.alpha[k] - exact.alpha[k], 2);
        of_motion += areas[k] * motion * motion;
      }
    error.faults = std::sqrt((of_state + of_motion) / area);

    const std::vector<double> &masses = scene.problem.nodal_masses();
    double                     sum = 0., squares = 0.;
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const double e = std::hypot(ours.velocity.local_element(2 * i) -
                                      exact.velocity.local_element(2 * i),
                                    ours.velocity.local_element(2 * i + 1) -
                                      exact.velocity.local_element(2 * i + 1));
        sum += masses[i] * e;
        squares += masses[i] * e * e;
      }
    error.bodies =
      squares / sum / std::max(velocity_scale(scene), fastest);
    return error;
  }
} // namespace StickSlip::Tests

#endif
