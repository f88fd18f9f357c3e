// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>

#include "parallel_comparison.h"
#include "pushed_block.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Largest values of a run on one process, and largest differences from them
   * of the same run on all. */
  template <int dim>
  struct Landing
  {
    double gap = 0., slip = 0.;
    double gap_error = 0., slip_error = 0., displacement_error = 0.;
    /** Steps after which no node touches, and changes of nodes from open to
     * closed or back. */
    unsigned int n_flying = 0, n_changes = 0;
    /** Nodes that touch in one of the runs only, over all steps. */
    unsigned int n_different = 0;
    unsigned int n_mappings = 0, most_off_contact = 0;

    explicit Landing(const SceneParameters<dim> &scene)
    {
      Simulation<dim> shared(scene, MPI_COMM_WORLD),
        alone(scene, MPI_COMM_SELF);
      shared.set_up();
      alone.set_up();
      EXPECT_EQ(shared.fault_points(), alone.fault_points());
      while (!alone.is_finished())
        {
          const std::vector<double> before = alone.state().gap;
          shared.advance();
          alone.advance();
          // Steps that end at a contact do so by gaps, which the solver makes
          // alike. All processes know both times.
          const double difference =
            std::abs(shared.state().time - alone.state().time);
          EXPECT_LT(difference, 1e-9 * alone.state().time);
          if (difference >= 1e-9 * alone.state().time)
            return;
          compare(shared, alone, before);
        }
      EXPECT_TRUE(shared.is_finished());
      EXPECT_EQ(shared.counts().accepted, alone.counts().accepted);
      EXPECT_EQ(shared.counts().contact_mappings,
                alone.counts().contact_mappings);
      n_mappings         = alone.counts().contact_mappings;
      displacement_error = difference(shared.state().displacement,
                                      shared.meshes().finest().nodes,
                                      alone.state().displacement,
                                      numbers_on_one(shared.meshes().finest()));
    }

  private:
    void
    compare(const Simulation<dim>     &shared,
            const Simulation<dim>     &alone,
            const std::vector<double> &before)
    {
      const SystemState<dim> &ours = shared.state(), &one = alone.state();
      ASSERT_EQ(ours.gap.size(), one.gap.size());
      bool         flies         = true;
      unsigned int n_off_contact = 0;
      for (unsigned int k = 0; k < one.gap.size(); ++k)
        {
          gap       = std::max(gap, one.gap[k]);
          gap_error = std::max(gap_error, std::abs(ours.gap[k] - one.gap[k]));
          slip      = std::max(slip, one.slip[k].norm());
          slip_error =
            std::max(slip_error, (ours.slip[k] - one.slip[k]).norm());
          n_different += (ours.gap[k] > 0.) != (one.gap[k] > 0.);
          n_changes += (before[k] > 0.) != (one.gap[k] > 0.);
          if (alone.fault_nodes().in_contact(k))
            flies = flies && one.gap[k] > 0.;
          else
            ++n_off_contact;
        }
      n_flying += flies;
      most_off_contact = std::max(most_off_contact, n_off_contact);
    }
  };



  /** Expect steps and gaps that are those of one process. */
  template <int dim>
  Landing<dim>
  expect_equal_landing(const std::string              &text,
                       const std::vector<std::string> &entries,
                       const double                    tolerance = 1e-9)
  {
    const Landing<dim> landing(read_opening_scene<dim>(text, entries));
    EXPECT_LE(landing.gap_error, tolerance * landing.gap);
    EXPECT_LE(landing.slip_error, tolerance * landing.slip);
    EXPECT_LE(landing.displacement_error, tolerance);
    EXPECT_EQ(landing.n_different, 0u);
    EXPECT_GT(landing.n_flying, 0u);
    EXPECT_GE(landing.n_changes, 10u);
    return landing;
  }



  /** Bounces amplify what the iterations leave. */
  std::vector<std::string>
  settled(std::vector<std::string> entries)
  {
    entries.insert(entries.end(),
                   {"TNNMG/Tolerance=1e-12",
                    "Time/Rate-state tolerance=1e-10"});
    return entries;
  }
} // namespace



TEST(ParallelLanding, FarFromWhereItWasThrown)
{
  const Landing<2> landing = expect_equal_landing<2>(
    falling_block, settled(pushed_block(20., 10., {"Time/End time=0.4"})));
  EXPECT_GT(landing.n_flying, 100u);
  EXPECT_GT(landing.slip, 0.4);
  EXPECT_GT(landing.n_mappings, 3u);
}



TEST(ParallelLanding, OverTheEdge)
{
  const Landing<2> landing = expect_equal_landing<2>(
    falling_block, settled(pushed_block(27., 10., {"Time/End time=0.4"})));
  EXPECT_GT(landing.most_off_contact, 0u);
}



TEST(ParallelLanding, OnPeriodicBodies)
{
  std::vector<std::string> entries = {
    "Bodies/block/Lower lateral corner=-1.5",
    "Bodies/block/Upper lateral corner=1.5",
    "Bodies/block/Coarse cells=4, 1",
    "Bodies/block/Uniform refinements=2",
    "Bodies/foundation/Uniform refinements=2",
    "Bodies/block/Material/Shear viscosity=1e4",
    "Bodies/foundation/Material/Shear viscosity=1e4",
    "Boundary conditions/Periodic along x=true",
    "Boundary conditions/Sides=foundation bottom, block top",
    "Boundary conditions/block top/x condition=traction",
    "Boundary conditions/block top/x value=if(t < 0.1, 8e4, 0)",
    "Boundary conditions/block top/Ramp length=0",
    "Faults/contact/Initial gap=0.02 + 0.005 * cos(2 * pi * x / 3)",
    "Time/End time=0.2",
    "Time/Step size control=constant",
    "Time/Initial step=2e-3",
    "Time/Largest step=2e-3"};
  const Landing<2> landing =
    expect_equal_landing<2>(falling_block, settled(entries));
  EXPECT_GT(landing.slip, 0.1);
  EXPECT_GT(landing.n_mappings, 1u);
  EXPECT_EQ(landing.most_off_contact, 0u);
}



TEST(ParallelLanding, WithStepsThatFollowIt)
{
  // Steps end on moments of contact, which amplify what iterations leave.
  expect_equal_landing<2>(falling_block,
                          settled(
                            {"Bodies/block/Uniform refinements=2",
                             "Bodies/foundation/Uniform refinements=2",
                             "Bodies/block/Material/Shear viscosity=3e5",
                             "Bodies/foundation/Material/Shear viscosity=3e5",
                             "Time/End time=0.06",
                             "Time/Largest step=2e-3",
                             "Time/Initial step=2e-3"}),
                          1e-7);
}



TEST(ParallelLanding, InThreeDimensions)
{
  // A wedge below a block that is not parallel to the axes' planes of symmetry.
  std::string text = falling_block;
  const auto  set  = [&](const std::string &from, const std::string &to) {
    const std::size_t position = text.find(from);
    ASSERT_NE(position, std::string::npos) << from;
    text.replace(position, from.size(), to);
  };
  set("corner = -1.5", "corner = -1, -1");
  set("corner = 1.5", "corner = 1, 1");
  set("corner = -1\n", "corner = -0.8, -0.7\n");
  set("corner = 0.9", "corner = 0.7, 0.8");
  set("= 3, 1", "= 3, 3, 1");
  set("= 3, 1", "= 2, 2, 1");
  set("refinements  = 3", "refinements  = 1");
  set("refinements  = 3", "refinements  = 1");
  set("0.001 + 0.0005 * x", "0.002 + 0.001 * x + 0.0005 * y");
  set("set y condition", "set z condition = fixed\n    set y condition");
  const Landing<3> landing =
    expect_equal_landing<3>("set Dimension = 3\n" + text,
                            settled(
                              {"Bodies/block/Material/Shear viscosity=1e5",
                               "Bodies/foundation/Material/Shear viscosity=1e5",
                               "Time/End time=0.06",
                               "Time/Step size control=constant",
                               "Time/Initial step=2e-3",
                               "Time/Largest step=2e-3"}));
  EXPECT_GT(landing.n_flying, 3u);
}
