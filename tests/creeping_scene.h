// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_creeping_scene_h
#define stickslip_tests_creeping_scene_h

#include <string>

namespace StickSlip::Tests
{
  /**
   * Two small bodies whose fault creeps smoothly: its strength grows with the
   * slip rate and is zero at rest, so that it never sticks, and viscosity
   * damps the waves.
   */
  inline const std::string creeping_bodies = R"(
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -0.5
  subsection lower
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 4, 1
    set Refinement passes    = 2
    subsection Material
      set Shear viscosity = 2e5
      set Bulk viscosity  = 2e5
    end
  end
  subsection upper
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 4, 1
    set Refinement passes    = 2
    subsection Material
      set Shear viscosity = 2e5
      set Bulk viscosity  = 2e5
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set a                              = 0.02
    set b                              = 0.01
    set Reference friction coefficient = 0
    set Reference slip rate            = 1e-3
    set Characteristic slip            = 1e-3
    set Regularisation                 = arcsinh
    set Initial state                  = 1 + 0.2 * x
    set Normal stress                  = function
    set Normal stress function         = 2e4
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1e-3
    set Ramp length = 1
  end
end
subsection Gravity
  # The stress under weight is not that of a fault without strength.
  set Acceleration = 0
end
subsection Time
  set End time = 2
end
)";

} // namespace StickSlip::Tests

#endif
