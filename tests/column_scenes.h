// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_column_scenes_h
#define stickslip_tests_column_scenes_h

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "endless_layers.h"
#include "wave_column.h"

namespace StickSlip::Tests
{
  /** A velocity that is reached from zero over a ramp, m/s. */
  inline std::function<double(double)>
  reached_smoothly(const double velocity, const double ramp)
  {
    return [velocity, ramp](const double t) {
      return velocity * (1. - std::cos(numbers::PI * std::min(t / ramp, 1.))) /
             2.;
    };
  }



  constexpr double slider_loading_rate = 2e-4;

  /** The spring slider without ends and without viscosity. */
  inline WaveColumn
  spring_slider()
  {
    WaveColumn column;
    column.shear_modulus   = 4.12e7 / 2.6;
    column.density         = 5e3;
    column.height          = 1.;
    column.a               = 0.010;
    column.b               = 0.015;
    column.mu0             = 0.6;
    column.V0              = 1e-6;
    column.L               = 2e-5;
    column.normal_stress   = 5e3 * 9.81;
    column.velocity_of_top = reached_smoothly(slider_loading_rate, 1.);
    return column;
  }



  /** Slides smoothly and ever faster as the pull sets in, over @p ramp, s. */
  inline WaveColumn
  strengthening_column(const double ramp = 1.)
  {
    WaveColumn column      = spring_slider();
    column.is_arcsinh      = true;
    column.a               = 0.02;
    column.b               = 0.01;
    column.mu0             = 0.;
    column.V0              = 1e-3;
    column.L               = 1e-3;
    column.normal_stress   = 2e4;
    column.velocity_of_top = reached_smoothly(1e-2, ramp);
    return column;
  }



  /** Scene of a column, one cell wide, whose pull is complete after 1 s;
   * regularisation of friction is not in it. */
  inline std::string
  scene_of(const WaveColumn &column, const unsigned int n_cells)
  {
    EndlessLayers layers;
    for (Material &material : layers.material)
      {
        material.poissons_ratio  = 0.3;
        material.youngs_modulus  = 2.6 * column.shear_modulus;
        material.density         = column.density;
        material.shear_viscosity = material.bulk_viscosity = 0.;
      }
    layers.thickness.fill(column.height);
    layers.coarse_cells.fill({{1, n_cells}});
    layers.length                       = column.height / n_cells;
    layers.friction.a                   = column.a;
    layers.friction.b                   = column.b;
    layers.friction.reference_friction  = column.mu0;
    layers.friction.reference_slip_rate = column.V0;
    layers.friction.characteristic_slip = column.L;
    layers.normal_stress                = column.normal_stress;
    layers.velocity                     = column.velocity_of_top(1.);
    layers.ramp_length                  = 1.;
    return layers.text();
  }
} // namespace StickSlip::Tests

#endif
