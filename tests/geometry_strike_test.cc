// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>

#include "box_layers.h"
#include "error_message.h"
#include "fault_snapshots.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * Faults in three dimensions that are normal to x, and meshes of tetrahedra.
 */

namespace
{
  using Settings = std::vector<std::string>;

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
    set Between                = lower, upper
    set Characteristic slip    = 1e-3
    set Normal stress          = function
    set Normal stress function = 2e4
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
    set y condition = velocity
    set z condition = velocity
    set Ramp length = 0.1
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Tolerance = 1e-3
  set Initial step         = 1e-2
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
subsection Output
  set Event start slip rate = 1
end
)";



  struct Outcome
  {
    FaultSnapshot<3> fault;
    unsigned int     steps, iterations, most_iterations;
    double           time;
  };



  Outcome
  run(const MeshText &mesh, const Settings &settings)
  {
    const TemporaryFolder folder;
    folder.write("layers.msh", mesh.text());
    const SceneParameters<3> scene =
      SceneReader(folder.write("layers.prm", layers), settings).read<3>();
    Simulation<3> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    Outcome      result{};
    unsigned int before = 0;
    while (!simulation.is_finished())
      {
        simulation.advance();
        const unsigned int now = simulation.counts().work.tnnmg_iterations;
        result.most_iterations = std::max(result.most_iterations, now - before);
        before                 = now;
      }
    result.fault      = snapshots(simulation).front();
    result.steps      = simulation.counts().accepted;
    result.iterations = simulation.counts().work.tnnmg_iterations;
    result.time       = simulation.state().time;
    return result;
  }



  std::array<double, 3>
  level(const double x, const double y, const double z)
  {
    return {{x, y, z}};
  }



  /** Turned about the y axis: the normal along x. */
  std::array<double, 3>
  upright(const double x, const double y, const double z)
  {
    return {{z, y, -x}};
  }



  Settings
  driven(const std::string &x, const std::string &y, const std::string &z)
  {
    const std::string side = "Boundary conditions/upper top/";
    return {side + "x value=" + x,
            side + "y value=" + y,
            side + "z value=" + z,
            "Time/End time=0.6"};
  }
} // namespace



TEST(Strike, AFaultNormalToXSlipsAsTheLevelOne)
{
  const Settings creep = {"Faults/fault/Friction=velocity strengthening"};
  const auto     with  = [&creep](Settings settings) {
    settings.insert(settings.end(), creep.begin(), creep.end());
    return settings;
  };
  const Outcome a = run(box_layers(SolidCells::hexahedra, level),
                        with(driven("2e-3", "1e-3", "0")));
  // The directions of slip are y and z without an entry, -z and y with this.
  for (const bool with_strike : {false, true})
    {
      const Outcome b = run(box_layers(SolidCells::hexahedra, upright), [&]() {
        Settings settings = with(driven("0", "1e-3", "-2e-3"));
        if (with_strike)
          settings.push_back("Faults/fault/Strike=0.1, 0, -2");
        return settings;
      }());
      ASSERT_EQ(a.steps, b.steps);
      ASSERT_EQ(a.fault.points.size(), b.fault.points.size());
      double slip = 0, traction = 0, slip_error = 0, traction_error = 0;
      for (unsigned int k = 0; k < a.fault.points.size(); ++k)
        {
          const Point<3> &x = a.fault.points[k];
          const Point<3>  turned(0., x[1], -x[0]);
          unsigned int    m = 0;
          while (b.fault.points[m].distance(turned) > 1e-10)
            ASSERT_LT(++m, b.fault.points.size());
          const auto to_level = [&](const Tensor<1, 2> &t) {
            return with_strike ? t : Tensor<1, 2>({-t[1], t[0]});
          };
          slip     = std::max(slip, a.fault.slip[k].norm());
          traction = std::max(traction, a.fault.shear_traction[k].norm());
          slip_error =
            std::max(slip_error,
                     (to_level(b.fault.slip[m]) - a.fault.slip[k]).norm());
          traction_error = std::max(traction_error,
                                    (to_level(b.fault.shear_traction[m]) -
                                     a.fault.shear_traction[k])
                                      .norm());
        }
      EXPECT_GT(slip, 1e-6);
      EXPECT_LT(slip_error, 1e-8 * slip);
      EXPECT_LT(traction_error, 1e-8 * traction);
    }
}



TEST(Strike, NearTheNormalIsAnError)
{
  Settings settings = driven("0", "0", "1e-4");
  settings.push_back("Faults/fault/Strike=1, 0, 0.2");
  expect_one_sentence_with(
    message_of(
      [&]() { run(box_layers(SolidCells::hexahedra, upright), settings); }),
    {"'fault'", "within 15 degrees of its normal", "'Strike'"});
}



// Shapes of cells change the work by little, and the motion by the error of the
// mesh.
TEST(Tetrahedra, SlipAsHexahedraDo)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic", "quasi-static"})
    {
      Settings settings = driven("2e-3", "1e-3", "0");
      settings.push_back("Time/Inertia=" + inertia);
      settings.push_back("TNNMG/Tolerance=1e-8");
      const Outcome hexahedra =
                      run(box_layers(SolidCells::hexahedra, level), settings),
                    tetrahedra =
                      run(box_layers(SolidCells::tetrahedra, level), settings);
      const auto mean_slip = [](const FaultSnapshot<3> &fault) {
        Tensor<1, 2> sum;
        double       weights = 0;
        for (unsigned int k = 0; k < fault.slip.size(); ++k)
          {
            sum += fault.weights[k] * fault.slip[k];
            weights += fault.weights[k];
          }
        return sum / weights;
      };
      const Tensor<1, 2> a  = mean_slip(hexahedra.fault),
                         b  = mean_slip(tetrahedra.fault);
      const double per_step = double(hexahedra.iterations) / hexahedra.steps,
                   per_step_of_tetrahedra =
                     double(tetrahedra.iterations) / tetrahedra.steps;
      std::cout << inertia << ": slip " << a << " and " << b << " m, "
                << per_step << " and " << per_step_of_tetrahedra
                << " iterations a step, at most " << hexahedra.most_iterations
                << " and " << tetrahedra.most_iterations << '\n';
      EXPECT_LT((a - b).norm(), 0.1 * a.norm());
      EXPECT_LT(per_step_of_tetrahedra, 1.5 * per_step);
      EXPECT_LE(tetrahedra.most_iterations, 1.5 * hexahedra.most_iterations);
    }
}
