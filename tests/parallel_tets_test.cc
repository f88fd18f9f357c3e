// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>

#include "box_layers.h"
#include "fault_snapshots.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string layers = R"(
set Dimension = 3
subsection Bodies
  set Names     = lower, upper
  set Mesh file = layers.msh
  subsection lower
    set Uniform refinements = 1
  end
  subsection upper
    set Uniform refinements = 1
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Between                        = lower, upper
    set Shape                          = 0.05 * sin(2 * x) * cos(y)
    set Reference friction coefficient = 0.01
    set Reference slip rate            = 1e-3
    set Characteristic slip            = 1e-3
    set Regularisation                 = arcsinh
    set Normal stress                  = function
    set Normal stress function         = 2e4 + 1e3 * x
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 2e-3
    set y condition = velocity
    set y value     = 1e-3
    set z condition = fixed
    set Ramp length = 0.1
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time             = 0.1
  set Step size control    = constant
  set Largest step         = 0.02
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
subsection Output
  set Event start slip rate = 1
end
)";



  FaultSnapshot<3>
  end_of_run(const std::string &inertia, const MPI_Comm communicator)
  {
    const TemporaryFolder folder;
    folder.write("layers.msh",
                 box_layers(SolidCells::tetrahedra,
                            [](const double x, const double y, const double z)
                              -> std::array<double, 3> {
                              return {{x,
                                       y,
                                       z + 0.1 * (0.5 - std::abs(z)) *
                                             std::sin(2. * x) * std::cos(y)}};
                            })
                   .text());
    Simulation<3> simulation(SceneReader(folder.write("layers.prm", layers),
                                         {"Time/Inertia=" + inertia})
                               .read<3>(),
                             communicator);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation).front();
  }
} // namespace



// Tetrahedra beside a curved fault, whose nodes belong to several processes.
TEST(ParallelTetrahedra, SlipAsOnOneProcess)
{
  for (const std::string inertia : {"dynamic", "quasi-static"})
    {
      SCOPED_TRACE(inertia);
      const FaultSnapshot<3> ours = end_of_run(inertia, MPI_COMM_WORLD),
                             one  = end_of_run(inertia, MPI_COMM_SELF);
      ASSERT_EQ(ours.slip.size(), one.slip.size());
      double largest = 0., slip = 0., traction = 0., most_traction = 0.;
      for (unsigned int k = 0; k < one.slip.size(); ++k)
        {
          EXPECT_EQ(ours.points[k], one.points[k]);
          largest       = std::max(largest, one.slip[k].norm());
          slip          = std::max(slip, (ours.slip[k] - one.slip[k]).norm());
          most_traction = std::max(most_traction, one.shear_traction[k].norm());
          traction =
            std::max(traction,
                     (ours.shear_traction[k] - one.shear_traction[k]).norm());
        }
      EXPECT_GT(largest, 1e-5);
      EXPECT_LE(slip, 1e-6 * largest);
      EXPECT_LE(traction, 1e-6 * most_traction);
    }
}
