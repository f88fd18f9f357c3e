// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_pushed_block_h
#define stickslip_tests_pushed_block_h

#include "falling_block.h"

namespace StickSlip::Tests
{
  /** Density times height of the falling block, kg/m^2, its width, m, and the
   * time for which it is pushed, s. */
  constexpr double mass_of_area = 5000. * 0.8, width_of_block = 1.9,
                   time_of_push = 0.1;



  /** Entries that throw the block upwards and to the right with these
   * accelerations, m/s^2, the former less that of gravity, until the push ends:
   * by tractions on the top and, in equal parts, on both ends, which do not
   * turn it. */
  inline std::vector<std::string>
  pushed_block(const double                    a_x,
               const double                    a_y,
               const std::vector<std::string> &others)
  {
    const auto push = [](const std::string &side,
                         const std::string &axis,
                         const double       traction) {
      const std::string section = "Boundary conditions/block " + side + "/";
      return std::vector<std::string>{section + axis + " condition=traction",
                                      section + axis + " value=if(t < " +
                                        std::to_string(time_of_push) + ", " +
                                        std::to_string(traction) + ", 0)",
                                      section + "Ramp length=0"};
    };
    const double ends = a_x * mass_of_area / 0.8 * width_of_block / 2.;
    std::vector<std::string> all = {
      "Boundary conditions/Sides=foundation bottom, block top, block left, "
      "block right",
      "Faults/contact/Initial gap=0",
      "Bodies/block/Uniform refinements=2",
      "Bodies/foundation/Uniform refinements=2",
      "Bodies/block/Material/Shear viscosity=1e4",
      "Bodies/foundation/Material/Shear viscosity=1e4",
      "Time/Step size control=constant",
      "Time/Initial step=2e-3",
      "Time/Largest step=2e-3",
      "Output/Energy balance=true",
      "TNNMG/Tolerance=1e-9",
      "Time/Rate-state tolerance=1e-7"};
    for (const auto &entries : {push("top", "y", (a_y + 9.81) * mass_of_area),
                                push("left", "x", ends),
                                push("right", "x", ends),
                                others})
      all.insert(all.end(), entries.begin(), entries.end());
    return all;
  }
} // namespace StickSlip::Tests

#endif
