// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "simulation_scenes.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Bodies that slide by half a metre over two bends. */
  SceneParameters<2>
  sliding_over_bends(const Settings &settings)
  {
    const Settings wavy = {"Faults/fault/Elevation=0.005 * sin(3 * x)",
                           "Bodies/lower/Coarse cells=7, 2",
                           "Time/Step size control=constant",
                           "Time/Largest step=0.02",
                           "Time/Rate-state tolerance=1e-10",
                           "TNNMG/Tolerance=1e-11"};
    return fast_sliding_scene(wavy + settings);
  }



  void
  slide(Simulation<2> &simulation)
  {
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
  }



  /** The bodies at the end of sliding. */
  FaultSnapshot<2>
  end_of_sliding(const Settings &settings, unsigned int &mappings)
  {
    Simulation<2> simulation(sliding_over_bends(settings), MPI_COMM_WORLD);
    slide(simulation);
    mappings = simulation.counts().contact_mappings;
    return snapshots(simulation).front();
  }



  class SlidingOverBends : public ::testing::TestWithParam<const char *>
  {};
} // namespace



TEST_P(SlidingOverBends, IsTheSameWhateverTheSolver)
{
  const Settings     inertia = {std::string("Time/Inertia=") + GetParam()};
  unsigned int       mappings;
  const auto         fault = end_of_sliding(inertia, mappings);
  const unsigned int n     = mappings;
  EXPECT_GT(n, 20u);
  double largest = 0.;
  for (const auto &slip : fault.slip)
    largest = std::max(largest, slip.norm());
  EXPECT_GT(largest, 0.4);
  for (const std::string solver : {"Time/Rate solver=condensed Newton",
                                   "TNNMG/Linear correction=UMFPACK",
                                   "Time/Rate-state method=nested"})
    {
      SCOPED_TRACE(solver);
      const auto other = end_of_sliding(inertia + Settings{solver}, mappings);
      EXPECT_EQ(mappings, n);
      ASSERT_EQ(other.slip.size(), fault.slip.size());
      for (unsigned int k = 0; k < fault.slip.size(); ++k)
        {
          EXPECT_LT((other.slip[k] - fault.slip[k]).norm(), 1e-7 * largest);
          EXPECT_NEAR(other.state[k], fault.state[k], 1e-6 * fault.state[k]);
          EXPECT_LT((other.shear_traction[k] - fault.shear_traction[k]).norm(),
                    1e-6 * fault.shear_traction[k].norm() + 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Inertia,
                         SlidingOverBends,
                         ::testing::Values("dynamic",
                                           "quasi-dynamic",
                                           "quasi-static"),
                         [](const auto &info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });



// Bodies that slide, or are held, over bends: the traction is that of the law
// at the slip rate, state and normal stress of each node.
TEST(FrictionOverBends, IsWhatTheLawSays)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic"})
    {
      double missing_without_friction = 0.;
      for (const std::string kind : {"frictionless",
                                     "rate and state",
                                     "velocity strengthening",
                                     "Coulomb",
                                     "welded",
                                     "prescribed slip rate"})
        {
          SCOPED_TRACE(kind + ", " + inertia);
          Simulation<2> simulation(
            sliding_over_bends(
              {"Faults/fault/Friction=" + kind,
               "Faults/fault/Reference friction coefficient=0.1",
               "Faults/fault/Slip rate along x=0.2",
               "Faults/fault/Slip rate ramp length=0.2",
               "Time/Inertia=" + inertia}),
            MPI_COMM_WORLD);
          slide(simulation);
          const FaultSnapshot<2> fault   = snapshots(simulation).front();
          const auto            &balance = *simulation.energy_balance();
          const double           missing = balance.defect(simulation.state());
          // New mappings take it, most where sides are driven along the bend.
          EXPECT_LT(std::abs(missing), 0.025 * balance.work().driven_sides);
          if (kind == "welded")
            {
              EXPECT_LT(std::abs(missing), 1e-12 * balance.work().driven_sides);
            }
          if (kind == "frictionless")
            missing_without_friction = missing;
          else if (kind != "welded" && kind != "prescribed slip rate")
            {
              EXPECT_GT(balance.work().friction, 80.);
              EXPECT_NEAR(missing,
                          missing_without_friction,
                          0.01 * balance.work().friction);
            }
          double largest_slip = 0.;
          for (unsigned int k = 0; k < fault.slip.size(); ++k)
            {
              const double slip = fault.slip[k][0],
                           rate = fault.slip_rate[k][0];
              largest_slip      = std::max(largest_slip, std::abs(slip));
              if (fault.weights[k] == 0.)
                continue;
              if (kind == "welded")
                {
                  EXPECT_EQ(slip, 0.);
                }
              else if (kind == "prescribed slip rate")
                {
                  EXPECT_NEAR(rate, 0.2, 1e-9);
                }
              else
                {
                  const FrictionLaw &law = *simulation.node_laws()[k].friction;
                  const double       data =
                    law.node_data(simulation.state().alpha[k]);
                  EXPECT_GT(std::abs(rate), 0.);
                  EXPECT_NEAR(
                    fault.shear_traction[k][0],
                    std::copysign(1e3 * law.coefficient(std::abs(rate), data),
                                  rate),
                    1e-6);
                }
            }
          if (kind != "welded")
            {
              EXPECT_GT(largest_slip, 0.3);
              EXPECT_GT(simulation.counts().contact_mappings, 20u);
            }
        }
    }
}
