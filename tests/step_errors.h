// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_step_errors_h
#define stickslip_tests_step_errors_h

#include <gtest/gtest.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stepping_scene.h"

namespace StickSlip::Tests
{
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
    // The velocity at which waves carry the strength, or that of slip if that
    // is more; the least of all faults.
    double velocity_scale = std::numeric_limits<double>::max();
    for (unsigned int f = 0; f + 1 < scene.faults.first_of_fault().size(); ++f)
      {
        const unsigned int begin = scene.faults.first_of_fault()[f],
                           end   = scene.faults.first_of_fault()[f + 1];
        double fastest           = 0.;
        for (unsigned int k = begin; k < end; ++k)
          fastest = std::max({fastest,
                              magnitude(ours.slip_rate[k]),
                              magnitude(before.slip_rate[k])});
        double area = 0., squares = 0., strength = 0.;
        for (unsigned int k = begin; k < end; ++k)
          {
            const FaultLaw &law = scene.laws[k];
            const double
              scale       = law.friction->rate_scale(),
              error_of_V  = magnitude(ours.slip_rate[k] - exact.slip_rate[k]),
              in_friction = magnitude(
                directed_friction(scene.faults, scene.laws, ours, k) -
                directed_friction(scene.faults, scene.laws, exact, k)),
              of_motion =
                std::min(error_of_V /
                           std::max(fastest, law.characteristic_slip / tau),
                         in_friction * stress[k] / scale),
              of_state = ours.alpha[k] - exact.alpha[k];
            area += areas[k];
            squares += areas[k] * (of_state * of_state + of_motion * of_motion);
            strength +=
              areas[k] * scale * ours.normal_stress[k] / law.shear_impedance;
          }
        error.faults = std::hypot(error.faults, std::sqrt(squares / area));
        velocity_scale =
          std::min(velocity_scale, std::max(strength / area, fastest));
      }

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
    error.bodies = squares / sum / velocity_scale;
    return error;
  }
} // namespace StickSlip::Tests

#endif
