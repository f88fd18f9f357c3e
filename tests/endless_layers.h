// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_endless_layers_h
#define stickslip_tests_endless_layers_h

#include <stickslip/friction/rate_and_state.h>
#include <stickslip/mechanics/material.h>

#include <array>
#include <sstream>
#include <string>

namespace StickSlip::Tests
{
  /**
   * Two layers without ends, the lower one held at its bottom, the upper one
   * moved at its top, both without vertical displacement there; no gravity, and
   * a given normal stress on the fault at y = 0. SI units.
   */
  struct EndlessLayers
  {
    /** Lower and upper layer. */
    std::array<Material, 2>                    material;
    std::array<double, 2>                      thickness;
    std::array<std::array<unsigned int, 2>, 2> coarse_cells;
    double                                     length              = 0;
    unsigned int                               uniform_refinements = 0;
    RateAndStateParameters                     friction;
    double                                     normal_stress = 0;
    double                                     velocity = 0, ramp_length = 0;

    /** The parameter file. */
    std::string
    text() const
    {
      std::ostringstream text;
      text.precision(17);
      text << "subsection Bodies\n set Names = lower, upper\n"
           << " set Base elevation = " << -thickness[0] << "\n";
      for (unsigned int layer = 0; layer < 2; ++layer)
        {
          const Material &solid = material[layer];
          text << " subsection " << (layer == 0 ? "lower" : "upper")
               << "\n  set Lower lateral corner = 0\n"
               << "  set Upper lateral corner = " << length
               << "\n  set Thickness = " << thickness[layer]
               << "\n  set Coarse cells = " << coarse_cells[layer][0] << ", "
               << coarse_cells[layer][1]
               << "\n  set Uniform refinements = " << uniform_refinements
               << "\n  set Refinement passes = 0\n  subsection Material\n"
               << "   set Young modulus = " << solid.youngs_modulus
               << "\n   set Poisson ratio = " << solid.poissons_ratio
               << "\n   set Density = " << solid.density
               << "\n   set Shear viscosity = " << solid.shear_viscosity
               << "\n   set Bulk viscosity = " << solid.bulk_viscosity
               << "\n  end\n end\n";
        }
      text << "end\nsubsection Faults\n set Names = fault\n subsection fault\n"
           << "  set a = " << friction.a << "\n  set b = " << friction.b
           << "\n  set Reference friction coefficient = "
           << friction.reference_friction
           << "\n  set Reference slip rate = " << friction.reference_slip_rate
           << "\n  set Characteristic slip = " << friction.characteristic_slip
           << "\n  set Normal stress = function\n"
           << "  set Normal stress function = " << normal_stress
           << "\n end\nend\n"
           << "subsection Boundary conditions\n"
           << " set Periodic along x = true\n"
           << " set Sides = lower bottom, upper top\n"
           << " subsection lower bottom\n"
           << "  set x condition = fixed\n  set y condition = fixed\n end\n"
           << " subsection upper top\n  set x condition = velocity\n"
           << "  set x value = " << velocity
           << "\n  set y condition = fixed\n  set Ramp length = " << ramp_length
           << "\n end\nend\n"
           << "subsection Gravity\n set Acceleration = 0\nend\n";
      return text.str();
    }
  };
} // namespace StickSlip::Tests

#endif
