// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <cmath>

#include "falling_block.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Entries that rock the block and draw it to and fro: its sides lift off in
   * turn. */
  std::vector<std::string>
  rocked_block(const std::vector<std::string> &others)
  {
    const std::string        top        = "block top/";
    const std::string        conditions = "Boundary conditions/";
    std::vector<std::string> all        = {
             "Faults/contact/Initial gap=0",
             "Faults/contact/Characteristic slip=1e-4",
             "Bodies/block/Material/Shear viscosity=1e4",
             "Bodies/block/Material/Bulk viscosity=1e4",
             "Bodies/block/Uniform refinements=2",
             "Bodies/foundation/Uniform refinements=2",
             conditions + "Sides=foundation bottom, block top",
             conditions + top + "y condition=traction",
             conditions + top + "y value=7e4 * x * sin(6 * t)",
             conditions + top + "x condition=traction",
             conditions + top + "x value=1e4 * sin(15 * t)",
             conditions + top + "Ramp length=0.05",
             "Time/End time=0.3",
             // Bodies without mass that move as a whole have no energy to compare
             // with.
             "TNNMG/Tolerance=1e-8",
             "Time/Rate-state tolerance=1e-7",
             "Time/Initial step=1e-3",
             "Time/Largest step=0.01",
             "Time/Tolerance=1e-4",
             "Time/Doubling threshold=1e-4",
             "Output/Energy balance=true"};
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }



  /** The extremes of a run, and its end. */
  template <int dim>
  struct BlockRun
  {
    SystemState<dim> end;
    double           largest_gap = 0., largest_slip = 0.;
    unsigned int     n_changes = 0, n_steps = 0;
    bool             was_all_open = false;

    explicit BlockRun(const std::vector<std::string> &others)
    {
      const SceneParameters<dim> scene =
        read_opening_scene<dim>(falling_block, rocked_block(others));
      Simulation<dim> simulation(scene, MPI_COMM_WORLD);
      simulation.set_up();
      while (!simulation.is_finished())
        {
          const std::vector<double> gap = simulation.state().gap;
          simulation.advance();
          ++n_steps;
          end           = simulation.state();
          bool all_open = true;
          for (unsigned int k = 0; k < gap.size(); ++k)
            {
              n_changes += (gap[k] > 0.) != (end.gap[k] > 0.);
              largest_gap  = std::max(largest_gap, end.gap[k]);
              largest_slip = std::max(largest_slip, end.slip[k].norm());
              all_open     = all_open && end.gap[k] > 0.;
            }
          was_all_open = was_all_open || all_open;
        }
      EXPECT_GT(largest_gap, 1e-5);
      EXPECT_GT(largest_slip, 1e-5);
      EXPECT_GE(n_changes, 5u);
    }
  };



  /** Expect equal gaps and slips at the end, as a part of the largest. */
  template <int dim>
  void
  expect_close(const BlockRun<dim> &a,
               const BlockRun<dim> &b,
               const double         tolerance)
  {
    EXPECT_NEAR(a.largest_gap, b.largest_gap, tolerance * b.largest_gap);
    double gap = 0., slip = 0.;
    for (unsigned int k = 0; k < a.end.gap.size(); ++k)
      {
        gap  = std::max(gap, std::abs(a.end.gap[k] - b.end.gap[k]));
        slip = std::max(slip, (a.end.slip[k] - b.end.slip[k]).norm());
      }
    EXPECT_LE(gap, tolerance * b.largest_gap);
    EXPECT_LE(slip, tolerance * b.largest_slip);
  }
} // namespace



TEST(OpeningRuns, RateSolversAgree)
{
  for (const std::string inertia : {"dynamic", "quasi-dynamic", "quasi-static"})
    {
      SCOPED_TRACE(inertia);
      const BlockRun<2> multigrid({"Time/Inertia=" + inertia}),
        condensed(
          {"Time/Inertia=" + inertia, "Time/Rate solver=condensed Newton"});
      expect_close(multigrid, condensed, 1e-3);
    }
}



TEST(OpeningRuns, StepControlsAgree)
{
  const BlockRun<2> embedded({"Time/Tolerance=1e-5"}),
    doubling({"Time/Step size control=step doubling"});
  expect_close(embedded, doubling, 0.05);
}



TEST(OpeningRuns, AStateGoesOnBitForBitWithGaps)
{
  for (const std::string control : {"embedded", "step doubling"})
    {
      SCOPED_TRACE(control);
      const SceneParameters<2> scene =
        read_opening_scene<2>(falling_block,
                              rocked_block(
                                {"Time/Step size control=" + control,
                                 "Faults/contact/Tensile strength=1e3",
                                 "Faults/contact/Bond healing time=0.05"}));
      Simulation<2> kept(scene, MPI_COMM_WORLD);
      kept.set_up();
      const auto is_open = [&]() {
        const std::vector<double> &gap = kept.state().gap;
        return *std::max_element(gap.begin(), gap.end()) > 1e-5;
      };
      while (!is_open() && !kept.is_finished())
        kept.advance();
      ASSERT_TRUE(is_open());
      const TemporaryFolder folder;
      kept.write_state(folder.file("state"));
      Simulation<2> resumed(scene, MPI_COMM_WORLD);
      resumed.resume(folder.file("state"));
      for (unsigned int i = 0; i < 20 && !kept.is_finished(); ++i)
        {
          kept.advance();
          resumed.advance();
          ASSERT_TRUE(same_bits(resumed.state(), kept.state())) << i;
          EXPECT_EQ(resumed.state().gap, kept.state().gap);
          EXPECT_EQ(resumed.state().is_bonded, kept.state().is_bonded);
          EXPECT_EQ(resumed.energy_balance()->defect(resumed.state()),
                    kept.energy_balance()->defect(kept.state()));
        }
    }
}
