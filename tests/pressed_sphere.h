// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_pressed_sphere_h
#define stickslip_tests_pressed_sphere_h

#include <gtest/gtest.h>

#include <cmath>

#include "contact_closed_forms.h"
#include "opening_scene.h"

namespace StickSlip::Tests
{
  /** A quarter of an elastic body of 2 m by 2 m by 1 m on a rigid one, without
   * mass and friction, whose lower side is that of a sphere. */
  inline const char *const pressed_sphere = R"(
set Dimension = 3
subsection Bodies
  set Names          = wall, body
  set Base elevation = -1
  subsection wall
    set Lower lateral corner = -3, -3
    set Upper lateral corner = 3, 3
    set Thickness            = 1
    set Rigid                = true
  end
  subsection body
    set Lower lateral corner = 0, 0
    set Upper lateral corner = 1, 1
    set Thickness            = 1
    set Coarse cells         = 4, 4, 4
    set Refinement passes    = 0
    subsection Material
      set Young modulus   = 1e7
      set Poisson ratio   = 0.3
      set Density         = 1000
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Friction    = frictionless
    set Contact     = unilateral
    set Initial gap = 0.5 * (x^2 + y^2)
  end
end
subsection Boundary conditions
  set Sides = body left, body front, body top
  subsection body left
    set x condition = fixed
  end
  subsection body front
    set y condition = fixed
  end
  subsection body top
    set x condition = fixed
    set y condition = fixed
    set z condition = velocity
    set z value     = -0.018
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 10
  set Inertia  = quasi-static
end
subsection TNNMG
  set Tolerance = 1e-9
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** Expect contact radius and largest pressure of Hertz, up to this part:
   * those of the straight line between square of the distance from the axis and
   * square of the pressure, since nodes on the planes of symmetry are no
   * contact nodes. */
  inline void
  expect_hertz_sphere(const unsigned int refinements, const double tolerance)
  {
    OpeningScene<3> scene(pressed_sphere,
                          {"Bodies/body/Uniform refinements=" +
                           std::to_string(refinements)});
    for (unsigned int i = 0; i < 3; ++i)
      {
        const StepResult<3> step = scene.advance(1.);
        ASSERT_TRUE(step.converged) << step.failure;
      }
    const auto &points =
      scene.problem.jump_basis().faults().front().slave.points;
    double load = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      if (scene.faults.in_contact(k))
        load +=
          4. * scene.faults.weights()[k] * scene.state.contact_pressure[k];
    const HertzSphere hertz = {load, 1., contact_modulus(1e7, 0.3, 1e300, 0.)};
    const double      a     = hertz.contact_radius();
    EXPECT_NEAR(a, 0.22, 0.02);

    double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const double r_square =
          points[k][0] * points[k][0] + points[k][1] * points[k][1];
        if (!scene.faults.in_contact(k) || r_square > 0.72 * a * a)
          continue;
        const double p = scene.state.contact_pressure[k];
        n += 1.;
        x += r_square;
        y += p * p;
        xx += r_square * r_square;
        xy += r_square * p * p;
      }
    const double slope  = (n * xy - x * y) / (n * xx - x * x);
    const double square = (y - slope * x) / n;
    EXPECT_NEAR(std::sqrt(-square / slope), a, tolerance * a);
    EXPECT_NEAR(std::sqrt(square),
                hertz.pressure(0.),
                tolerance * hertz.pressure(0.));
  }
} // namespace StickSlip::Tests

#endif
