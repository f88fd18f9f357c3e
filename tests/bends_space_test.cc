// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>
#include <complex>

#include "fault_snapshots.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /**
   * Two layers without ends slide without friction over the waves of a sine,
   * along x; they also slide along y, the crests, as fast.
   */
  const std::string layers = R"(
set Dimension = 3
subsection Bodies
  set Names          = lower, upper
  set Base elevation = -1
  subsection lower
    set Lower lateral corner = 0, 0
    set Upper lateral corner = 1, 0.25
    set Thickness            = 1
    set Coarse cells         = 12, 2, 6
    set Refinement passes    = 1
    subsection Material
      set Young modulus   = 1e6
      set Poisson ratio   = 0.25
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
  subsection upper
    set Lower lateral corner = 0, 0
    set Upper lateral corner = 1, 0.25
    set Thickness            = 1
    set Coarse cells         = 16, 3, 6
    set Refinement passes    = 1
    subsection Material
      set Young modulus   = 1e6
      set Poisson ratio   = 0.25
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Friction               = frictionless
    set Elevation              = 0.01 * sin(2 * pi * x)
    set Normal stress          = function
    set Normal stress function = 1
  end
end
subsection Boundary conditions
  set Sides            = lower bottom, upper top
  set Periodic along x = true
  set Periodic along y = true
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1
    set y condition = velocity
    set y value     = 1
    set z condition = fixed
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Contact
  set Rebuild fraction = 0.25
end
subsection Time
  set Inertia           = quasi-static
  set End time          = 0.5
  set Step size control = constant
  set Largest step      = 0.00390625
end
subsection Output
  set Fault fields = contact_pressure
end
)";
} // namespace



// The closed form of bends_sine_test.cc: pressure E* k A sin(ks/2) cos(kX +
// ks/2) whatever the slip along the crests.
TEST(SlidingOverWavesInSpace, HasThePressureOfHalfSpaces)
{
  constexpr double k             = 2. * numbers::PI;
  constexpr double most_pressure = 1e6 / (2. * (1. - 0.25 * 0.25)) * k * 0.01;
  const TemporaryFolder folder;
  Simulation<3>         simulation(
    SceneReader(folder.write("layers.prm", layers)).read<3>(), MPI_COMM_WORLD);
  simulation.set_up();
  double error = 0., across = 0., gap = 0., slip_error = 0.;
  while (!simulation.is_finished())
    {
      simulation.advance();
      const FaultSnapshot<3> fault = snapshots(simulation).front();
      std::complex<double>   wave;
      double                 area = 0, slip = 0, along_crests = 0;
      for (unsigned int p = 0; p < fault.points.size(); ++p)
        {
          wave += 2. * fault.weights[p] * fault.contact_pressure[p] *
                  std::polar(1., -k * fault.points[p][0]);
          slip += fault.weights[p] * fault.slip[p][0];
          along_crests += fault.weights[p] * fault.slip[p][1];
          area += fault.weights[p];
        }
      wave /= area;
      slip /= area;
      error = std::max(error,
                       std::abs(wave - most_pressure * std::sin(k * slip / 2.) *
                                         std::polar(1., k * slip / 2.)) /
                         most_pressure);
      // All nodes of a crest bear the same.
      for (unsigned int p = 0; p < fault.points.size(); ++p)
        for (unsigned int q = 0; q < p; ++q)
          if (std::abs(fault.points[p][0] - fault.points[q][0]) < 1e-10)
            across = std::max(across,
                              std::abs(fault.contact_pressure[p] -
                                       fault.contact_pressure[q]) /
                                most_pressure);
      slip_error =
        std::max(slip_error,
                 std::abs(along_crests / area - simulation.state().time));
      gap =
        std::max(gap,
                 simulation.spatial_problem().gaps().front()->absolute / 0.01);
    }
  std::cout << "pressure " << error << ", along crests " << across << ", gap "
            << gap << ", slip along crests " << slip_error << ", mappings "
            << simulation.counts().contact_mappings << ", nodes "
            << simulation.spatial_problem().meshes().finest().n_nodes() << '\n';
  EXPECT_LT(error, 0.05);
  EXPECT_LT(across, 1e-6);
  EXPECT_LT(gap, 3e-3);
  EXPECT_LT(slip_error, 5e-3);
}
