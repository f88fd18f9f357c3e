// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/output/event_source.h>
#include <stickslip/output/table_columns.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/fault_rigidity.h>

#include <cmath>

#include "creeping_scene.h"
#include "stepping_scene.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  FaultMotion
  motion_of(const std::vector<double> &slip,
            const std::vector<double> &traction)
  {
    FaultMotion motion;
    motion.slip           = slip;
    motion.shear_traction = traction;
    return motion;
  }
} // namespace



TEST(EventSource, HasTheSizesOfACircularCrack)
{
  // A crack of radius a under a stress drop slips by c sqrt(a^2 - r^2): its
  // potency is 2/3 pi a^3 c, here by a fine sum over rings of nodes.
  constexpr unsigned int n = 2000;
  constexpr double       a = 50., c = 1e-4, G = 3e10, drop = 3e6;
  std::vector<double>    weights, slip, before, after;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double r = 2. * a * (i + 0.5) / n;
      weights.push_back(2 * numbers::PI * r * 2. * a / n);
      // Slip is against the first axis.
      slip.push_back(r < a ? -0.6 * c * std::sqrt(a * a - r * r) : 0.);
      slip.push_back(r < a ? 0.8 * c * std::sqrt(a * a - r * r) : 0.);
      before.push_back(-0.6 * drop);
      before.push_back(0.8 * drop);
      // The traction rises around the crack, which does not count.
      after.push_back(r < a ? 0. : -9e9);
      after.push_back(0.);
    }
  std::vector<char> has_ruptured(n, 0);
  std::fill_n(has_ruptured.begin(), n / 2, 1);
  const EventSource source(motion_of(std::vector<double>(2 * n, 0.), before),
                           motion_of(slip, after),
                           weights,
                           std::vector<double>(n, G),
                           has_ruptured);
  const double      moment = G * 2. / 3. * numbers::PI * a * a * a * c;
  EXPECT_NEAR(source.moment, moment, 1e-4 * moment);
  EXPECT_NEAR(source.stress_drop, drop, 1e-12 * drop);
  EXPECT_NEAR(source.ruptured_area, numbers::PI * a * a, 1e-9 * a * a);
}



TEST(EventSource, LeavesOutNodesOffContactAndMomentsWithoutRigidity)
{
  const EventSource source(motion_of({0, 0}, {5, 5}),
                           motion_of({2, 9}, {1, -9}),
                           {3., 0.},
                           {},
                           {1, 1});
  EXPECT_TRUE(std::isnan(source.moment));
  EXPECT_DOUBLE_EQ(source.stress_drop, 4.);
  EXPECT_DOUBLE_EQ(source.ruptured_area, 3.);
  const EventSource resting(
    motion_of({1}, {5}), motion_of({1}, {5}), {3.}, {7.}, {0});
  EXPECT_EQ(resting.moment, 0.);
  EXPECT_TRUE(std::isnan(resting.stress_drop));
}



TEST(EventSource, HasTheMagnitudeOfAPublishedMoment)
{
  // Global CMT, Tohoku 2011: 5.312e22 N m, Mw 9.1; Parkfield 2004: 1.13e18 N m,
  // Mw 6.0.
  EventSource source;
  source.moment = 5.312e22;
  EXPECT_NEAR(source.magnitude(), 9.1, 0.05);
  source.moment = 1.13e18;
  EXPECT_NEAR(source.magnitude(), 6.0, 0.05);
}



TEST(FaultRigidity, IsTheHarmonicMeanOfBothSides)
{
  const auto rigidity = [](const std::vector<std::string> &overrides) {
    return fault_rigidity(read_scene(creeping_bodies, overrides),
                          0,
                          {Point<2>(0.25, 0.), Point<2>(0.75, 0.)});
  };
  // G = E / 2 (1 + nu), of both 1 and 3: 2 / (1 + 1/3).
  EXPECT_NEAR(rigidity({"Bodies/lower/Material/Young modulus=2.5",
                        "Bodies/lower/Material/Poisson ratio=0.25",
                        "Bodies/upper/Material/Young modulus=7.5",
                        "Bodies/upper/Material/Poisson ratio=0.25"})[1],
              1.5,
              1e-12);
  // Of numbers that vary, those at the node.
  const std::vector<double> varying =
    rigidity({"Bodies/lower/Material/Young modulus=2.5 * (2 + x)",
              "Bodies/lower/Material/Poisson ratio=0.25",
              "Bodies/upper/Material/Young modulus=2.5 * (2 + x)",
              "Bodies/upper/Material/Poisson ratio=0.25"});
  EXPECT_NEAR(varying[0], 2.25, 1e-12);
  EXPECT_NEAR(varying[1], 2.75, 1e-12);
}



TEST(FaultRigidity, IsTwiceThatOfTheOtherSideNextToARigidBody)
{
  const double one =
    fault_rigidity(read_scene(creeping_bodies, {"Bodies/lower/Rigid=true"}),
                   0,
                   {Point<2>(0.5, 0.)})[0];
  const double both =
    fault_rigidity(read_scene(creeping_bodies, {}), 0, {Point<2>(0.5, 0.)})[0];
  EXPECT_NEAR(one, 2 * both, 1e-9 * both);
}



TEST(TableColumns, AreWrittenAsATable)
{
  const TemporaryFolder folder;
  write_columns(folder.file("columns.csv"),
                {{"a.csv", {{"time", "s", "when, and where"}, {"n", "", "x"}}},
                 {"b.csv", {{"main.slip", "m", "y"}}}});
  EXPECT_EQ(content_of(folder.file("columns.csv")),
            "file,column,unit,meaning\n"
            "a.csv,time,s,\"when, and where\"\n"
            "a.csv,n,,\"x\"\n"
            "b.csv,main.slip,m,\"y\"\n");
  EXPECT_EQ(header_of({{"a", "", ""}, {"b", "m", ""}}), "a,b");
}
