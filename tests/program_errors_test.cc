// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/version.h>

#include "run_program.h"
#include "scene_text.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

TEST(Program, SaysInOneLineWhatIsWrongAndLeavesNoFolder)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", two_bodies);
  const Outcome outcome =
    run_program(folder, "scene.prm --set 'Bodies/upper/Thickness=-1'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: 'Bodies/upper/Thickness' = '-1' (--set): must be a "
            "number > 0.\n");
  EXPECT_EQ(outcome.output, "");
  EXPECT_FALSE(std::filesystem::exists(folder.file("output")));
}



TEST(Program, ReportsAContradictionFoundAfterParsing)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", two_bodies);
  const Outcome outcome =
    run_program(folder, "scene.prm --set 'Time/Smallest step=2'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: 'Time/Smallest step' = '2': must not be larger than "
            "'Largest step' = '0.5'.\n");
  EXPECT_FALSE(std::filesystem::exists(folder.file("output")));
}



TEST(Program, ReportsAMissingFile)
{
  const TemporaryFolder folder;
  const Outcome         outcome = run_program(folder, "none.prm");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: The parameter file 'none.prm' does not exist or is not "
            "a file.\n");
}



TEST(Program, TellsItsVersion)
{
  const TemporaryFolder folder;
  const Outcome         outcome = run_program(folder, "--version");
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.output, "stickslip " + std::string(version) + "\n");
}
