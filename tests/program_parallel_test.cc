// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <algorithm>

#include "creeping_scene.h"
#include "nan_in_debug_mode.h"
#include "project_directories.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // With an event, large slip and volume output.
  const std::string scene = creeping_bodies + R"(
subsection Output
  set Event start slip rate = 5e-4
  set Write volume          = true
end
)";



  // The end of a run that hangs; no test below takes as long. It passes on the
  // signal that it sends itself.
  const std::string time_limit = "timeout --foreground -s USR1 -k 5 120 ";



  // More processes than cores, for versions 4 and 5 of Open MPI; the former can
  // be told to say nothing of its own.
  const std::string launcher =
    "env OMPI_MCA_orte_execute_quiet=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
    "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe mpirun -np ";



  std::string
  parallel_program(const unsigned int n)
  {
    return program(time_limit + launcher + std::to_string(n));
  }
} // namespace



TEST(ProgramParallel, WritesTheSameFiles)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  const Outcome alone =
    run_program(folder, "scene.prm --set 'Output/Output directory=alone'");
  ASSERT_EQ(alone.exit_status, 0) << alone.errors;
  for (const unsigned int n : {2, 3})
    {
      const std::string name = "shared" + std::to_string(n);
      const Outcome     shared =
        run_command(folder,
                    parallel_program(n) +
                      " scene.prm --set 'Output/Output directory=" + name +
                      "'");
      ASSERT_EQ(shared.exit_status, 0) << shared.errors;
      EXPECT_EQ(shared.errors, "");
      // One process speaks for all.
      const std::string ending = "Run reached the end time";
      const auto        place  = shared.output.find(ending);
      ASSERT_NE(place, std::string::npos) << shared.output;
      EXPECT_EQ(shared.output.find(ending, place + 1), std::string::npos);
      EXPECT_EQ(problems_of_output(folder, name), "");
      const Outcome comparison =
        run_command(folder,
                    "/usr/bin/python3 '" STICKSLIP_SOURCE_DIR
                    "/tests/compare_output_folders.py' alone " +
                      name);
      EXPECT_EQ(comparison.output + comparison.errors, "");
      EXPECT_NE(content_of(folder.file(name + "/summary.txt"))
                  .find("processes                            " +
                        std::to_string(n)),
                std::string::npos);
    }
}



TEST(ProgramParallel, ReportsBadInputOnce)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  const Outcome outcome =
    run_command(folder,
                parallel_program(3) +
                  " scene.prm --set 'Bodies/upper/Thickness=-1'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: 'Bodies/upper/Thickness' = '-1' (--set): must be a "
            "number > 0 (in m).\n");
  EXPECT_FALSE(std::filesystem::exists(folder.file("output")));
}



TEST(ProgramParallel, SaysOnceWhyAStartIsRefused)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  // Nothing presses the fault together, which shows on the coarser mesh of the
  // report on the first process too.
  const std::string arguments =
    " scene.prm --set 'Faults/fault/Normal stress=initial equilibrium'";
  const std::string words = "nothing presses this fault together";
  for (const std::string &command : {program(), parallel_program(3)})
    for (const std::string option : {"", " --check"})
      {
        const Outcome outcome =
          run_command(folder, command + arguments + option + " --overwrite");
        EXPECT_EQ(outcome.exit_status, 1) << command << option;
        EXPECT_EQ(
          outcome.errors.rfind("stickslip: 'Faults/fault/Normal stress' = "
                               "'initial equilibrium' (--set): " +
                                 words,
                               0),
          0u)
          << outcome.errors;
        EXPECT_EQ(
          std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
          << outcome.errors;
        EXPECT_EQ(outcome.output.find(words), std::string::npos)
          << outcome.output;
        EXPECT_NE(outcome.output.find("Meshes: "), std::string::npos)
          << outcome.output;
      }
}



TEST(ProgramParallel, WhatIsForOneProcessSaysSo)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  for (const std::pair<std::string, std::string> entry :
       {std::make_pair("Time/Rate solver", "condensed Newton"),
        std::make_pair("TNNMG/Linear correction", "UMFPACK"),
        std::make_pair("TNNMG/Linear correction", "MUMPS")})
    {
      const Outcome outcome =
        run_command(folder,
                    parallel_program(2) + " scene.prm --set '" + entry.first +
                      "=" + entry.second + "'");
      EXPECT_EQ(outcome.exit_status, 1);
      EXPECT_EQ(outcome.errors,
                "stickslip: '" + entry.first + "' = '" + entry.second +
                  "' (--set): runs on one process only, but there are 2.\n");
      EXPECT_FALSE(std::filesystem::exists(folder.file("output")));
    }
}



TEST(ProgramParallel, InputThatOneProcessLacksEndsAll)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  // As on a machine that does not see the folder.
  const Outcome outcome =
    run_command(folder,
                program(time_limit + launcher + "3 sh -c '" +
                        "[ $OMPI_COMM_WORLD_RANK = 0 ] && "
                        "exec \"$0\" scene.prm || "
                        "exec \"$0\" elsewhere.prm'"));
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(
    outcome.errors,
    "stickslip: The parameter file 'elsewhere.prm' does not exist or is "
    "not a file.\n");
  EXPECT_FALSE(std::filesystem::exists(folder.file("output")));
}



TEST(ProgramParallel, FolderThatCannotBeMadeEndsAllProcesses)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  folder.write("file", "no folder");
  const Outcome outcome =
    run_command(folder,
                parallel_program(3) +
                  " scene.prm --set 'Output/Output directory=file/below'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
    << outcome.errors;
  EXPECT_NE(outcome.errors.find("'Output/Output directory' = 'file/below'"),
            std::string::npos)
    << outcome.errors;
}



TEST(ProgramParallel, FileThatCannotBeWrittenEndsAllProcesses)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  // Only the first process writes, and meets something in the way.
  std::filesystem::create_directories(
    folder.file("output/scene/solution_00002.vtu/in_the_way"));
  const Outcome outcome =
    run_command(folder, parallel_program(3) + " scene.prm");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(
    outcome.errors,
    "stickslip: The file 'output/scene/solution_00002.vtu' cannot be written "
    "(Is a directory).\n");
  // Everything else is there, the reason too.
  std::filesystem::remove_all(folder.file("output/scene/solution_00002.vtu"));
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  EXPECT_NE(content_of(folder.file("output/scene/summary.txt"))
              .find("cannot be written"),
            std::string::npos);
}



TEST(ProgramParallel, FailureOnTheWayEndsAllProcesses)
{
  SKIP_WHERE_NAN_IS_FATAL();
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  const Outcome outcome =
    run_command(folder,
                parallel_program(3) +
                  " scene.prm --set 'Boundary conditions/upper top/x value="
                  "if(x > 0.9 && t > 0.3 && t < 0.9, sqrt(-1), 2e-4)'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.errors.find("can be taken: the solution is not a number"),
            std::string::npos)
    << outcome.errors;
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
    << outcome.errors;
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
}



TEST(ProgramParallel, InterruptLeavesCompleteFiles)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  // The launcher passes this signal on, and kills nobody, but does not always
  // print what comes after it.
  const Outcome outcome =
    run_and_interrupt(folder,
                      parallel_program(2) +
                        " scene.prm --set 'Time/End time=99999' "
                        "--set 'Contact/Follow slip=false'",
                      "USR1");
  EXPECT_NE(content_of(folder.file("output/scene/summary.txt"))
              .find("interrupted by the user, t = "),
            std::string::npos)
    << outcome.errors;
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
}
