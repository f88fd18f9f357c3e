// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_leaning_rod_h
#define stickslip_tests_leaning_rod_h

#include <deal.II/base/numbers.h>

#include <cmath>
#include <string>

namespace StickSlip::Tests
{
  /** A rod of 1 m by 0.2 m without mass that stands on a floor, leaning to the
   * right by an angle, in degrees; its top is pressed down for half a second,
   * and then drawn to the left, so that its foot goes first. Coulomb friction
   * of 0.8, the tangent of 38.7 degrees. */
  inline std::string
  leaning_rod(const double angle)
  {
    const double shift = std::tan(angle * dealii::numbers::PI / 180.);
    const auto   at    = [](const double x, const double y) {
      return std::to_string(x) + " " + std::to_string(y);
    };
    return R"(
subsection Bodies
  set Names = floor, rod
  subsection floor
    set Corners = -2 -1, 2 -1, 2 0, -2 0
    set Rigid   = true
  end
  subsection rod
    set Coarse cells         = 1, 4
    set Uniform refinements  = 2
    set Corners              = -0.1 0, 0.1 0, )" +
           at(shift + 0.1, 1.) + ", " + at(shift - 0.1, 1.) + R"(
    subsection Material
      set Young modulus   = 1e8
      set Poisson ratio   = 0.3
      set Density         = 2000
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = foot
  subsection foot
    set Between                        = floor top, rod bottom
    set Contact                        = unilateral
    set Friction                       = Coulomb
    set Reference friction coefficient = 0.8
  end
end
subsection Boundary conditions
  set Sides = rod top
  subsection rod top
    set x condition = velocity
    set y condition = velocity
    set x value     = if(t < 0.5, 0, -1e-3)
    set y value     = if(t < 0.5, -1e-3, 0)
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time          = 2
  set Inertia           = quasi-static
  set Step size control = constant
  set Largest step      = 0.05
  set Initial step      = 0.05
  set Smallest step     = 0.01
end
subsection Output
  set Event start slip rate = 1
end
)";
  }
} // namespace StickSlip::Tests

#endif
