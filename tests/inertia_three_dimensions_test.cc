// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>

#include "creeping_of_any_dimension.h"
#include "fault_snapshots.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Settings = std::vector<std::string>;

  /** Settings with equal steps, and so with equal errors in time. */
  const Settings common = {"Boundary conditions/Periodic along x=true",
                           "Bodies/lower/Refinement passes=0",
                           "Bodies/upper/Refinement passes=0",
                           "Bodies/lower/Uniform refinements=1",
                           "Bodies/upper/Uniform refinements=1",
                           "Faults/fault/Reference friction coefficient=0.02",
                           "TNNMG/Tolerance=1e-11",
                           "Time/Rate-state tolerance=1e-11",
                           "Time/Step size control=constant",
                           "Time/Initial step=0.02",
                           "Time/Largest step=0.02",
                           "Time/End time=1.4"};

  const Settings cells_in_the_plane = {"Bodies/lower/Coarse cells=4, 1",
                                       "Bodies/upper/Coarse cells=3, 1"};

  /** Nothing depends on y. */
  const Settings cells_in_space = {"Boundary conditions/Periodic along y=true",
                                   "Bodies/lower/Coarse cells=4, 2, 1",
                                   "Bodies/upper/Coarse cells=3, 1, 1"};



  template <int dim>
  FaultSnapshot<dim>
  fault_at_end(const std::vector<Settings> &settings)
  {
    Simulation<dim> simulation(creeping_bodies_with<dim>(settings),
                               MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation).front();
  }



  /** The node of a plane fault with the x of a point. */
  unsigned int
  node_at(const FaultSnapshot<2> &fault, const double x)
  {
    for (unsigned int k = 0; k < fault.points.size(); ++k)
      if (std::abs(fault.points[k][0] - x) < 1e-10)
        return k;
    ADD_FAILURE() << "no node at x = " << x;
    return 0;
  }



  class ThreeDimensions : public testing::TestWithParam<std::string>
  {};
} // namespace



TEST_P(ThreeDimensions, ExtendedPlaneSceneIsThePlaneOne)
{
  const Settings         wave = {"Time/Inertia=" + GetParam(),
                                 "Faults/fault/a=0.1",
                                 "Faults/fault/Normal stress function=2e5 * "
                                         "(1 + 0.5 * cos(pi * x))"};
  const FaultSnapshot<2> plane =
    fault_at_end<2>({common, in_the_plane, cells_in_the_plane, wave});
  const FaultSnapshot<3> space =
    fault_at_end<3>({common, in_space, cells_in_space, wave});
  ASSERT_GT(space.points.size(), 2 * plane.points.size());

  double slowest = 1., fastest = 0.;
  for (unsigned int k = 0; k < space.points.size(); ++k)
    {
      const unsigned int p = node_at(plane, space.points[k][0]);
      const double       V = plane.slip_rate[p][0];
      EXPECT_NEAR(space.slip_rate[k][0], V, 1e-8 * V);
      EXPECT_NEAR(space.slip_rate[k][1], 0., 1e-8 * V);
      EXPECT_NEAR(space.slip[k][0], plane.slip[p][0], 1e-8 * plane.slip[p][0]);
      EXPECT_NEAR(space.state[k], plane.state[p], 1e-8 * plane.state[p]);
      EXPECT_NEAR(space.shear_traction[k][0],
                  plane.shear_traction[p][0],
                  1e-7 * plane.shear_traction[p][0]);
      slowest = std::min(slowest, V);
      fastest = std::max(fastest, V);
    }
  // There was something to compare.
  EXPECT_GT(fastest, 1.05 * slowest);
}



TEST_P(ThreeDimensions, SlipHasTheDirectionOfTheLoad)
{
  const Settings         even = {"Time/Inertia=" + GetParam(),
                                 "Faults/fault/Initial state=1"};
  const FaultSnapshot<2> plane =
    fault_at_end<2>({common, in_the_plane, cells_in_the_plane, even});
  const FaultSnapshot<3> space =
    fault_at_end<3>({common,
                     in_space,
                     cells_in_space,
                     even,
                     {"Boundary conditions/upper top/x value=0.6e-3",
                      "Boundary conditions/upper top/y condition=velocity",
                      "Boundary conditions/upper top/y value=-0.8e-3"}});
  const double V = plane.slip_rate.front()[0];
  EXPECT_GT(V, 1e-4);
  for (const auto &slip_rate : space.slip_rate)
    {
      EXPECT_NEAR(slip_rate[0], 0.6 * V, 1e-8 * V);
      EXPECT_NEAR(slip_rate[1], -0.8 * V, 1e-8 * V);
    }
}



INSTANTIATE_TEST_SUITE_P(Inertia,
                         ThreeDimensions,
                         testing::Values("dynamic",
                                         "quasi-dynamic",
                                         "quasi-static"));
