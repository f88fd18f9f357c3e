// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_antiplane_scenes_h
#define stickslip_tests_antiplane_scenes_h

#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include "fault_snapshots.h"
#include "stepping_scene.h"

namespace StickSlip::Tests
{
  /**
   * Two bodies of 2 m x 0.5 m that slide past each other out of the plane, with
   * friction that makes them stick and slip.
   */
  inline const std::string antiplane_bodies = R"(
set Deformation = antiplane
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -0.5
  subsection lower
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 8, 2
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
  subsection upper
    set Lower lateral corner = -1
    set Upper lateral corner = 1
    set Thickness            = 0.5
    set Coarse cells         = 8, 2
    set Refinement passes    = 0
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set a                              = 0.01 + 0.005 * x^2
    set b                              = 0.015
    set Characteristic slip            = 2e-5
    set Regularisation                 = arcsinh
    set Initial state                  = 0.2 + 0.1 * x
    set Normal stress                  = function
    set Normal stress function         = 2e4 * (1 + 0.2 * x)
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set z condition = fixed
  end
  subsection upper top
    set z condition = velocity
    set z value     = 4e-4
    set Ramp length = 0.5
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia  = quasi-dynamic
  set End time = 4
end
)";



  /** The fault "fault" at the end of a run in which it slips out of the
   * plane. */
  inline FaultSnapshot<2>
  end_of_antiplane_run(const std::string              &text,
                       const std::vector<std::string> &overrides = {},
                       const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    Simulation<2, 1> simulation(read_scene(text, overrides), communicator);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation).front();
  }



  /** Largest difference of slip and of slip rate of two faults, over the
   * largest slip and slip rate; component @p d of the second one. */
  template <int dim>
  std::pair<double, double>
  difference(const FaultSnapshot<2>   &ours,
             const FaultSnapshot<dim> &other,
             const unsigned int        d = 0)
  {
    double slip = 0, rate = 0, largest_slip = 0, largest_rate = 0;
    for (unsigned int k = 0; k < ours.points.size(); ++k)
      {
        unsigned int same = 0;
        while (std::abs(other.points[same][0] - ours.points[k][0]) > 1e-9)
          ++same;
        slip = std::max(slip, std::abs(ours.slip[k][0] - other.slip[same][d]));
        rate =
          std::max(rate,
                   std::abs(ours.slip_rate[k][0] - other.slip_rate[same][d]));
        largest_slip = std::max(largest_slip, std::abs(ours.slip[k][0]));
        largest_rate = std::max(largest_rate, std::abs(ours.slip_rate[k][0]));
      }
    return {slip / largest_slip, rate / largest_rate};
  }
} // namespace StickSlip::Tests

#endif
