// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/version.h>
#include <sys/wait.h>

#include "scene_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct Outcome
  {
    int         exit_status;
    std::string output;
    std::string errors;
  };



  // Run the program in a folder, with none of this process's environment, as
  // that would make it part of the same MPI job.
  Outcome
  run_program(const TemporaryFolder &folder, const std::string &arguments)
  {
    const char       *binary_folder = std::getenv("STICKSLIP_BINARY_DIR");
    const std::string program =
      std::string(binary_folder == nullptr ? "." : binary_folder) +
      "/stickslip";
    EXPECT_TRUE(std::filesystem::exists(program)) << program;

    const std::string command =
      "cd '" + folder.path.string() +
      "' && env -i PATH=\"$PATH\" HOME=\"$HOME\" OMPI_ALLOW_RUN_AS_ROOT=1 "
      "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 '" +
      std::filesystem::absolute(program).string() + "' " + arguments +
      " > output.txt 2> errors.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            content_of(folder.file("output.txt")),
            content_of(folder.file("errors.txt"))};
  }
} // namespace



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
