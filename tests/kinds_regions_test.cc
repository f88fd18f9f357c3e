// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/scene_writer.h>

#include <sstream>

#include "error_message.h"
#include "scene_text.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The fault of two_bodies with two regions that overlap. */
  const std::string regions = R"(
subsection Faults
  subsection main
    subsection Regions
      set Names = creeping, locked
      subsection creeping
        set Where            = x > 0
        set Friction         = prescribed slip rate
        set Slip rate along x = 1e-3 * x
        set Slip rate ramp length = 2
      end
      subsection locked
        set Where    = abs(x - 0.5) < 0.25
        set Friction = velocity strengthening
        set a        = 0.03
      end
    end
  end
end
)";



  /** The texts of read_scene() may have a section once only. */
  SceneParameters<2>
  scene_with_regions(const std::vector<std::string> &overrides = {})
  {
    const TemporaryFolder folder;
    folder.write("two_bodies.prm", two_bodies);
    return SceneReader(folder.write("scene.prm",
                                    "include two_bodies.prm\n" + regions),
                       overrides)
      .read<2>();
  }



  std::string
  message(const std::vector<std::string> &overrides)
  {
    return message_of([&]() { scene_with_regions(overrides); });
  }
} // namespace



TEST(Regions, HaveWhatTheySayAndElseWhatTheirFaultSays)
{
  const FaultParameters fault = scene_with_regions().faults[0];
  ASSERT_EQ(fault.regions.size(), 2u);
  const FrictionParameters &locked = fault.regions[1].friction;
  EXPECT_EQ(fault.kind().name, "rate and state");
  EXPECT_EQ(locked.kind().name, "velocity strengthening");
  EXPECT_EQ(locked["a"].constant(), 0.03);
  EXPECT_EQ(locked["b"].constant(), 0.02);
  EXPECT_EQ(locked["Regularisation"].constant(), 1.); // arcsinh
  EXPECT_EQ(locked["Initial state"].text(), "3 + x^2");

  // Set on the command line for the fault, or for one region only.
  const FaultParameters other =
    scene_with_regions({"Faults/main/Regions/locked/b=0.04",
                        "Faults/main/a=0.011",
                        "Faults/main/b=0.05"})
      .faults[0];
  EXPECT_EQ(other.regions[0].friction["b"].constant(), 0.05);
  EXPECT_EQ(other.regions[1].friction["b"].constant(), 0.04);
  EXPECT_EQ(other.regions[0].friction["a"].constant(), 0.011);
  EXPECT_EQ(other.regions[1].friction["a"].constant(), 0.03);
}



TEST(Regions, CoverTheFaultInTheirOrder)
{
  const FaultParameters        fault  = scene_with_regions().faults[0];
  const std::vector<Point<2>>  points = {{-0.5, 0},
                                         {0.1, 0},
                                         {0.5, 0},
                                         {0.9, 0}};
  const std::vector<FaultPart> parts  = fault.parts(points);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].positions, std::vector<unsigned int>({0}));
  EXPECT_EQ(parts[1].positions, std::vector<unsigned int>({1, 3}));
  EXPECT_EQ(parts[2].positions, std::vector<unsigned int>({2}));
  EXPECT_EQ(parts[2].section, "Faults/main/Regions/locked");
  EXPECT_EQ(parts[1].select(std::vector<double>({5, 6, 7, 8})),
            std::vector<double>({6, 8}));

  // The event catalogue starts from the largest velocity of all, that at the
  // end of the fault, x = 2.5 m.
  EXPECT_NEAR(largest_prescribed_velocity(scene_with_regions()), 2.5e-3, 1e-15);
}



TEST(Regions, AreWrittenAsTheyAreRead)
{
  const SceneParameters<2> scene = scene_with_regions();
  std::ostringstream       first, second;
  write_parameters(scene, first);
  const TemporaryFolder    folder;
  const SceneParameters<2> again =
    SceneReader(folder.write("again.prm", first.str()), {}).read<2>();
  write_parameters(again, second);
  EXPECT_EQ(first.str(), second.str());
  EXPECT_EQ(again.faults[0].regions[0].friction["Slip rate along x"].text(),
            "1e-3 * x");
  EXPECT_EQ(again.faults[0].regions[0].friction.slip_rate_ramp_length(), 2.);
}



TEST(Regions, ThatCannotBeUsedAreSaidInOneSentence)
{
  expect_one_sentence_with(message({"Faults/main/Regions/locked/a=0"}),
                           {"'Faults/main/Regions/locked/a' = '0'",
                            "must be a number > 0"});
  expect_one_sentence_with(message({"Faults/main/Regions/locked/Where=abs(w)"}),
                           {"Faults/main/Regions/locked", "Where"});
  expect_one_sentence_with(message({"Faults/main/Regions/creeping/"
                                    "Slip rate along x=1/(x - 0.2)^0"
                                    " / 0"}),
                           {"Faults/main/Regions/creeping",
                            "Slip rate along x"});
  // In two dimensions there is one axis to slip along.
  expect_one_sentence_with(
    message({"Faults/main/Regions/creeping/Slip rate along y=1"}),
    {"there is no such entry"});
  expect_one_sentence_with(message({"Faults/main/Regions/other/a=1"}),
                           {"'other' is not in 'Faults/main/Regions/Names'",
                            "creeping",
                            "locked"});
  expect_one_sentence_with(message({"Faults/main/Regions/Names=a, a"}),
                           {"listed twice"});
  expect_one_sentence_with(message({"Faults/main/Friction=glue"}),
                           {"'Faults/main/Friction' = 'glue'",
                            "velocity strengthening",
                            "Coulomb"});
  expect_one_sentence_with(message_of([]() {
                             read_scene(two_bodies,
                                        {"Faults/main/Friction=Coulomb",
                                         "Time/Step size control=step "
                                         "doubling"});
                           }),
                           {"'Time/Step size control' = 'step doubling'",
                            "rate and state"});
  // Entries that no node uses do not matter.
  EXPECT_EQ(message_of([]() {
              read_scene(two_bodies,
                         {"Faults/main/Friction=welded",
                          "Faults/main/Initial state=log(-1)"});
            }),
            "no error");
  // A region that is no more.
  expect_one_sentence_with(
    message({"Faults/main/Regions/Names="}),
    {"'creeping' is not in 'Faults/main/Regions/Names'"});
}
