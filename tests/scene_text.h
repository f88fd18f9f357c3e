// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_scene_text_h
#define stickslip_tests_scene_text_h

#include <string>

namespace StickSlip::Tests
{
  /**
   * A small scene of two bodies and one fault.
   */
  inline const std::string two_bodies = R"(set Dimension = 2
subsection Bodies
  set Names = lower, upper   # from below
  set Base elevation = -0.3
  subsection lower
    set Thickness = 0.3
    set Coarse cells = 16, 1
    subsection Material
      set Young modulus = 1e7
    end
  end
  subsection upper
    set Lower lateral corner = -1
  end
end
subsection Faults
  set Names = main
  subsection main
    set b = 0.02
    set State law = slip
    set Regularisation = arcsinh
    set Initial state = 3 + x^2
    set Normal stress = function
    set Normal stress function = 1e4 * \
      (3 + x)
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
    set x value = -2e-4 * (1 + 0.5 * sin(t))
    set y condition = traction
    set y value = -100
    set Ramp length = 0.1
  end
end
subsection Time
  set End time = 7
  set Rate-state method = nested
end
)";

  /**
   * A scene of one body in three dimensions.
   */
  inline const std::string one_body_3d = R"(set Dimension = 3
subsection Bodies
  set Names = block
  subsection block
    set Lower lateral corner = -1, -2
    set Upper lateral corner = 1, 2
    set Coarse cells = 2, 4, 1
  end
end
subsection Boundary conditions
  set Sides = block bottom, block front
  subsection block bottom
    set x condition = fixed
    set z condition = fixed
  end
  subsection block front
    set y condition = velocity
    set y value = 1e-3 * z
  end
end
)";
} // namespace StickSlip::Tests

#endif
