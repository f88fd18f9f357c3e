// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <numeric>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // The creeping bodies at a thousandfold speed: the upper body slides off by
  // 0.47 m, several faces.
  const std::vector<std::string> fast = {
    "Boundary conditions/upper top/x value=0.25",
    "Boundary conditions/upper top/Ramp length=0.2",
    "Faults/fault/Reference slip rate=0.25",
    "Faults/fault/Characteristic slip=0.25",
    "Faults/fault/Normal stress function=1e3",
    "Time/End time=1.98",
    "Time/Largest step=0.05",
    "Time/Tolerance=1e-3"};

  // Displacement of the top side: the ramp costs half of its length.
  constexpr double imposed = 0.25 * (1.98 - 0.1);



  SceneParameters<2>
  sliding_scene(const std::vector<std::string> &more = {})
  {
    return read_scene(creeping_bodies, fast + more);
  }



  double
  sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }



  // Run to the end with a check after each advance. No step may fail, so
  // that there are as many solves as steps and rejections by the estimate.
  template <typename Check>
  void
  run(Simulation<2> &simulation, const Check &check)
  {
    simulation.set_up();
    while (!simulation.is_finished())
      {
        ASSERT_NO_THROW(simulation.advance());
        check();
      }
  }



  void
  expect_overlap_in_contact(const std::vector<std::string> &overrides)
  {
    Simulation<2> simulation(sliding_scene(overrides), MPI_COMM_WORLD);
    unsigned int  builds = 1, n_rebuilt = 0;
    run(simulation, [&]() {
      const FaultSnapshot<2> fault = snapshots(simulation).front();
      double                 area  = 0;
      for (const FaultContact<2> &contact :
           simulation.spatial_problem().jump_basis().faults())
        area += contact.coupling.covered_area;
      EXPECT_NEAR(sum(fault.weights), area, 1e-12);
      for (unsigned int k = 0; k < fault.weights.size(); ++k)
        if (fault.weights[k] == 0.)
          {
            EXPECT_EQ(fault.shear_traction[k][0], 0.);
            EXPECT_EQ(fault.normal_stress[k], 0.);
            EXPECT_EQ(fault.slip_rate[k][0], 0.);
          }

      if (simulation.counts().contact_mappings > builds)
        {
          builds = simulation.counts().contact_mappings;
          ++n_rebuilt;
          // The ends of the two sides now, from their end nodes: what they
          // have in common half way to the next mapping, an eighth of a face
          // further on, is in contact but for what is lost for good.
          const FaultContact<2> &contact =
            simulation.spatial_problem().jump_basis().faults().front();
          const auto &level = simulation.meshes().finest();
          const auto  ends  = [&](const unsigned int       body,
                                const types::boundary_id side) {
            const FaultSurface<2> surface = level.bodies[body]->surface(side);
            const auto            place   = [&](const unsigned int k) {
              return surface.points[k][0] +
                     simulation.state().displacement.local_element(
                       level.node(body, surface.nodes[k]) * 2);
            };
            return std::make_pair(place(0), place(surface.points.size() - 1));
          };
          const auto   lower   = ends(0, BodyMesh<2>::upper_side);
          const auto   upper   = ends(1, BodyMesh<2>::lower_side);
          const double overlap = std::min(lower.second, upper.second) -
                                 std::max(lower.first, upper.first);
          EXPECT_NEAR(area + contact.coupling.lost_area,
                      overlap - 0.125 * contact.smallest_face,
                      2e-5);
          EXPECT_LE(contact.coupling.lost_area, 0.25 * contact.smallest_face);
        }
    });

    EXPECT_GT(n_rebuilt, 5u);
    const FaultSnapshot<2> fault = snapshots(simulation).front();
    EXPECT_NEAR(sum(fault.weights), 2. - imposed, 0.05);
    EXPECT_GE(std::count(fault.weights.begin(), fault.weights.end(), 0.), 2);
    for (unsigned int k = 0; k < fault.slip.size(); ++k)
      if (fault.weights[k] > 0.)
        {
          EXPECT_NEAR(fault.slip[k][0], imposed, 0.01 * imposed)
            << "x = " << fault.points[k][0];
          EXPECT_GT(fault.shear_traction[k][0], 0.);
        }
  }
} // namespace



TEST(LargeSliding, ContactFollowsTheOverlap)
{
  expect_overlap_in_contact({});
}



TEST(LargeSliding, ContactFollowsTheOverlapOfNonmatchingMeshes)
{
  // The lower side is the finer one, and the slave.
  expect_overlap_in_contact({"Bodies/lower/Coarse cells=7, 2"});
}



TEST(LargeSliding, IsNotFollowedIfSwitchedOff)
{
  Simulation<2> simulation(sliding_scene({"Contact/Follow slip=false"}),
                           MPI_COMM_WORLD);
  run(simulation, []() {});
  EXPECT_EQ(simulation.counts().contact_mappings, 1u);
  const FaultSnapshot<2> fault = snapshots(simulation).front();
  EXPECT_NEAR(sum(fault.weights), 2., 1e-12);
  for (const auto &slip : fault.slip)
    EXPECT_NEAR(slip[0], imposed, 0.01 * imposed);
}



TEST(LargeSliding, RebuildsMoreOftenWithASmallerFraction)
{
  unsigned int builds[2];
  for (const unsigned int i : {0, 1})
    {
      Simulation<2> simulation(sliding_scene(
                                 {i == 0 ? "Contact/Rebuild fraction=0.1" :
                                           "Contact/Rebuild fraction=0.5"}),
                               MPI_COMM_WORLD);
      run(simulation, []() {});
      builds[i] = simulation.counts().contact_mappings;
    }
  EXPECT_GT(builds[0], builds[1]);
}



TEST(LargeSliding, ContactGainedDoesNotHoldUpTheSteps)
{
  // The lower side is the slave and reaches farther than the upper body, so
  // that nodes come into contact and meet friction all at once.
  SceneParameters<2> scene =
    sliding_scene({"Bodies/lower/Coarse cells=7, 2",
                   "Bodies/upper/Upper lateral corner=0.5",
                   "Bodies/upper/Coarse cells=3, 1",
                   "Faults/fault/Reference friction coefficient=0.6",
                   "Time/Tolerance=1e-4"});
  Simulation<2> simulation(scene, MPI_COMM_WORLD);
  unsigned int  n_steps = 0;
  double        time    = 0;
  simulation.set_up();
  while (!simulation.is_finished())
    {
      ASSERT_NO_THROW(simulation.advance());
      // The start of the loading needs small steps for itself.
      if (time > 0.3)
        {
          ++n_steps;
          EXPECT_GT(simulation.state().time - time, 5e-4) << "t = " << time;
        }
      time = simulation.state().time;
    }
  EXPECT_GE(simulation.counts().contact_mappings, 10u);
  EXPECT_LT(n_steps, 500u);
  double area = 0;
  for (const double weight : simulation.fault_nodes().weights())
    area += weight;
  EXPECT_NEAR(area, 1.5, 1e-3);
}
