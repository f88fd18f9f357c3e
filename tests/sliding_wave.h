// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_sliding_wave_h
#define stickslip_tests_sliding_wave_h

#include <array>
#include <complex>

#include "steady_sliding.h"
#include "stepping_scene.h"

namespace StickSlip::Tests
{
  /**
   * Set displacement, velocity and acceleration of two layers that slide
   * steadily under @p shear_stress (Pa), with a wave on top that goes as
   * exp(st): @p wave(body, point) is its displacement (m), of which the real
   * part counts.
   */
  template <typename Wave>
  void
  set_sliding_bodies(SteppingScene             &scene,
                     const SteadySliding       &theory,
                     const double               shear_stress,
                     const std::complex<double> s,
                     const Wave                &wave)
  {
    SystemState<2>     &state = scene.state;
    const MeshLevel<2> &level = scene.meshes.finest();
    for (unsigned int b = 0; b < 2; ++b)
      {
        const std::vector<Point<2>> points = level.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const unsigned int node                     = level.node(b, i) * 2;
            const std::array<std::complex<double>, 2> u = wave(b, points[i]);
            for (unsigned int d = 0; d < 2; ++d)
              {
                state.displacement.local_element(node + d) = u[d].real();
                state.velocity.local_element(node + d)     = (s * u[d]).real();
                if (state.acceleration.size() > 0)
                  state.acceleration.local_element(node + d) =
                    (s * s * u[d]).real();
              }
            state.displacement.local_element(node) +=
              shear_stress / theory.material[b].shear_modulus() * points[i][1];
            if (b == 1)
              state.velocity.local_element(node) += theory.slip_rate;
          }
      }
  }
} // namespace StickSlip::Tests

#endif
