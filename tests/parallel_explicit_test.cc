// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "antiplane_scenes.h"
#include "parallel_comparison.h"
#include "shared_and_alone.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const Settings explicit_steps = {"Bodies/lower/Material/Shear viscosity=0",
                                   "Bodies/lower/Material/Bulk viscosity=0",
                                   "Bodies/upper/Material/Shear viscosity=0",
                                   "Bodies/upper/Material/Bulk viscosity=0",
                                   "Time/Inertia=quasi-dynamic",
                                   "Time/Step size control=Runge-Kutta"};



  /** Times at which the largest slip rate passes twice that of the driven side,
   * s. */
  std::vector<double>
  event_times(const MPI_Comm communicator)
  {
    const TemporaryFolder folder;
    Simulation<2, 1>      simulation(
      SceneReader(folder.write("scene.prm", antiplane_bodies),
                  {"Time/Step size control=Runge-Kutta", "Time/End time=3"})
        .read<2>(),
      communicator);
    simulation.set_up();
    const double        threshold = 8e-4;
    std::vector<double> times;
    double              time_before = 0., rate_before = 0.;
    while (!simulation.is_finished())
      {
        simulation.advance();
        double rate = 0.;
        for (const auto &v : simulation.state().slip_rate)
          rate = std::max(rate, std::abs(v[0]));
        const double time = simulation.state().time;
        if (rate_before > 0. && rate_before <= threshold && rate > threshold)
          times.push_back(time_before + std::log(threshold / rate_before) /
                                          std::log(rate / rate_before) *
                                          (time - time_before));
        time_before = time;
        rate_before = rate;
      }
    return times;
  }
} // namespace



TEST(ParallelExplicit, EventsComeAtTheSameTime)
{
  const std::vector<double> shared = event_times(MPI_COMM_WORLD),
                            alone  = event_times(MPI_COMM_SELF);
  ASSERT_GE(alone.size(), 1u);
  ASSERT_EQ(shared.size(), alone.size());
  for (unsigned int i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(shared[i], alone[i], 1e-6 * alone[i]);
}



// Prescribed slip and a normal stress that follows.
TEST(ParallelExplicit, FaultsAndBodiesAreTheSame)
{
  SharedAndAlone runs(
    read_scene(creeping_bodies,
               explicit_steps +
                 Settings{"Faults/fault/Normal stress follows=true",
                          "Faults/fault/Regions/Names=part",
                          "Faults/fault/Regions/part/Where=x - 0.3",
                          "Faults/fault/Regions/part/"
                          "Friction=prescribed slip rate",
                          "Faults/fault/Regions/part/Slip rate along x=5e-4",
                          "Output/Energy balance=false"}),
    {1e-12, 1e-10, 1e-8});
  double largest = 0.;
  for (unsigned int k = 0; k < runs.one.slip.size(); ++k)
    {
      largest = std::max(largest, std::abs(runs.one.shear_traction[k][0]));
      EXPECT_NEAR(runs.ours.shear_traction[k][0],
                  runs.one.shear_traction[k][0],
                  1e-8 * std::abs(runs.one.shear_traction[k][0]));
      EXPECT_NEAR(runs.ours.normal_stress[k],
                  runs.one.normal_stress[k],
                  1e-9 * runs.one.normal_stress[k]);
    }
  EXPECT_GT(largest, 0.);
  runs.shared.complete_state();
  runs.alone.complete_state();
  EXPECT_LT(difference(runs.shared.state().displacement,
                       runs.shared.meshes().finest().nodes,
                       runs.alone.state().displacement,
                       numbers_on_one(runs.shared.meshes().finest())),
            1e-10);
}



// Past nodes and parts of others, with a viscosity that the steps see late.
TEST(ParallelExplicit, CentralDifferencesAreTheSame)
{
  SharedAndAlone runs(fast_sliding_scene(
                        {"Time/Step size control=central differences",
                         "Bodies/upper/Coarse cells=3, 1",
                         "Time/End time=1"}),
                      {1e-10, 1e-8, 1e-6});
  EXPECT_GT(runs.alone.counts().contact_mappings, 2u);
  EXPECT_LT(difference(runs.shared.state().displacement,
                       runs.shared.meshes().finest().nodes,
                       runs.alone.state().displacement,
                       numbers_on_one(runs.shared.meshes().finest())),
            1e-8);
}



// Cells on the fault have two sizes, so that nodes on it hang.
TEST(ParallelExplicit, GradedFaultsInSpaceAreTheSame)
{
  const std::string        body = R"(
    set Lower lateral corner = -1, 0
    set Upper lateral corner = 1, 1
    set Thickness            = 0.5
    set Coarse cells         = 8, 4, 2
    set Refinement passes    = 1
    set Refine where         = 0.3 - abs(x)
    subsection Material
      set Shear viscosity = 0
      set Bulk viscosity  = 0
    end
  end
)";
  const TemporaryFolder    folder;
  const SceneParameters<3> scene =
    SceneReader(
      folder.write(
        "scene.prm",
        "set Dimension = 3\nsubsection Bodies\n  set Names = lower, upper\n"
        "  set Base elevation = -0.5\n  subsection lower\n" +
          body + "  subsection upper\n" + body + R"(end
subsection Faults
  set Names = fault
  subsection fault
    set a                              = 0.02
    set b                              = 0.01
    set Reference friction coefficient = 0.1
    set Reference slip rate            = 1e-3
    set Characteristic slip            = 1e-3
    set Regularisation                 = arcsinh
    set Initial state                  = 1 + 0.2 * x
    set Normal stress                  = function
    set Normal stress function         = 2e4
    subsection Regions
      set Names = outside
      subsection outside
        set Where             = abs(x) - 0.6
        set Friction          = prescribed slip rate
        set Slip rate along x = 1e-3
      end
    end
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
    set x value     = 1e-3
    set y condition = velocity
    set y value     = 5e-4 * t
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia           = quasi-dynamic
  set Step size control = Runge-Kutta
  set End time          = 0.5
end
subsection Output
  set Energy balance = false
end
)"))
      .read<3>();
  Simulation<3> shared(scene, MPI_COMM_WORLD), alone(scene, MPI_COMM_SELF);
  for (Simulation<3> *simulation : {&shared, &alone})
    {
      simulation->set_up();
      while (!simulation->is_finished())
        simulation->advance();
    }
  double largest = 0.;
  for (unsigned int k = 0; k < alone.state().slip.size(); ++k)
    {
      largest = std::max(largest, std::abs(alone.state().slip[k][0]));
      EXPECT_LT((shared.state().slip[k] - alone.state().slip[k]).norm(), 1e-11);
      EXPECT_NEAR(shared.state().alpha[k], alone.state().alpha[k], 1e-8);
    }
  EXPECT_GT(largest, 1e-4);
}



TEST(ParallelExplicit, ContactFollowsTheSlip)
{
  const SharedAndAlone runs(
    fast_sliding_scene(explicit_steps + Settings{"Time/End time=0.3"}));
  EXPECT_GT(runs.alone.counts().contact_mappings, 1u);
  EXPECT_EQ(runs.shared.counts().contact_mappings,
            runs.alone.counts().contact_mappings);
}
