// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_falling_block_h
#define stickslip_tests_falling_block_h

#include "opening_scene.h"

namespace StickSlip::Tests
{
  /** A block above an elastic foundation, with meshes that do not match and a
   * gap that is a wedge. */
  inline const char *const falling_block = R"(
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



  /** The velocity of the block, m/s; the foundation rests. */
  inline std::function<Tensor<1, 2>(const unsigned int, const Point<2> &)>
  thrown(const double v_x, const double v_y)
  {
    return [v_x, v_y](const unsigned int body, const Point<2> &) {
      Tensor<1, 2> v;
      if (body == 1)
        v[0] = v_x, v[1] = v_y;
      return v;
    };
  }
} // namespace StickSlip::Tests

#endif
