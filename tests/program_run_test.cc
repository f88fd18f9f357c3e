// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <algorithm>
#include <chrono>
#include <sstream>
#include <vector>

#include "creeping_scene.h"
#include "nan_in_debug_mode.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // The creeping scene with an event: the loading is above the threshold.
  const std::string scene_with_event =
    creeping_bodies +
    "subsection Output\n set Event start slip rate = 5e-4\nend\n";



  std::vector<std::string>
  lines_of(const std::string &text)
  {
    std::vector<std::string> lines;
    std::istringstream       stream(text);
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    return lines;
  }



  void
  expect_part(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos)
      << "'" << part << "' is missing in:\n"
      << text;
  }
} // namespace



TEST(ProgramRun, WritesFilesThatAgreeAndCanBeRepeated)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene_with_event);
  const Outcome outcome = run_program(folder, "scene.prm");
  ASSERT_EQ(outcome.exit_status, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  expect_part(outcome.output,
              "Run reached the end time, t = 2 s. Results are in "
              "output/scene.\n");
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");

  const std::string results = folder.file("output/scene/");
  EXPECT_EQ(lines_of(content_of(results + "events.csv")).size(), 2u);
  const std::string summary = content_of(results + "summary.txt");
  expect_part(summary, "reached the end time");
  // There is no load at the start, so nothing to solve.
  expect_part(summary, "CG at the start                      0\n");

  // Everything that was used is in the file of parameters.
  const Outcome again = run_program(folder,
                                    "output/scene/parameters.prm "
                                    "--set 'Output/Output directory=again'");
  ASSERT_EQ(again.exit_status, 0) << again.errors;
  for (const std::string file : {"time_series.csv", "events.csv"})
    {
      const std::string content = content_of(results + file);
      EXPECT_FALSE(content.empty());
      EXPECT_EQ(content, content_of(folder.file("again/") + file)) << file;
    }
}



TEST(ProgramRun, InterruptLeavesCompleteFiles)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene_with_event);
  const Outcome outcome =
    run_and_interrupt(folder,
                      program() +
                        " scene.prm --set 'Time/End time=1e8' "
                        // Weights in faults.h5 are those of the start.
                        "--set 'Contact/Follow slip=false'");
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.errors, "");
  expect_part(outcome.output, "Run interrupted by the user, t = ");
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  const std::string summary =
    content_of(folder.file("output/scene/summary.txt"));
  expect_part(summary, "interrupted by the user");
}



TEST(ProgramRun, FailureAtTheStartLeavesTheInitialState)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene_with_event);
  const Outcome outcome =
    run_program(folder,
                "scene.prm --set 'Gravity/Acceleration=9.81' "
                "--set 'Time/Largest number of rate-state iterations=1' "
                "--set 'Time/Rate-state tolerance=1e-14'");
  const std::string reason =
    "At t = 0 s no time step down to the smallest one allowed, Time/Smallest "
    "step = 1e-09 s, can be taken: rate and state did not settle within 1 "
    "iterations.";
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors, "stickslip: " + reason + "\n");
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  expect_part(content_of(folder.file("output/scene/summary.txt")), reason);
}



TEST(ProgramRun, FailureOnTheWayLeavesTheLastGoodState)
{
  SKIP_WHERE_NAN_IS_FATAL();
  const TemporaryFolder folder;
  // Between the times at which input is checked.
  folder.write("scene.prm", scene_with_event);
  const Outcome outcome =
    run_program(folder,
                "scene.prm --set 'Time/Step size control=constant' "
                "--set 'Time/Largest step=0.01' --set 'Time/Smallest step=4e-3'"
                " --set 'Boundary conditions/upper top/x value="
                "(abs(t-0.31)<0.009) ? sqrt(-1) : 1e-3'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: At t = 0.3 s no time step down to the smallest one "
            "allowed, Time/Smallest step = 0.004 s, can be taken: the solution "
            "is not a number.\n");
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  // Thirty steps and the names of the columns.
  EXPECT_EQ(
    lines_of(content_of(folder.file("output/scene/time_series.csv"))).size(),
    31u);
  expect_part(content_of(folder.file("output/scene/summary.txt")),
              "the solution is not a number");
}



TEST(ProgramRun, TerminalShowsOneRewrittenLine)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene_with_event);
  folder.write("run.sh",
               program() + " scene.prm --set 'Time/End time=1e8' "
                           "--set 'Output/Write volume=false' &\n"
                           "pid=$!\n"
                           "for i in $(seq 600); do\n"
                           "  [ -s output/scene/time_series.csv ] && break\n"
                           "  sleep 0.1\n"
                           "done\n"
                           "sleep 5\n"
                           "kill -INT $pid\n"
                           "wait $pid\n");
  const auto    start = std::chrono::steady_clock::now();
  const Outcome outcome =
    run_command(folder, "script -qec 'sh run.sh' /dev/null < /dev/null");
  const std::chrono::duration<double> seconds =
    std::chrono::steady_clock::now() - start;
  EXPECT_EQ(outcome.exit_status, 130) << outcome.errors;

  // The terminal turns each line's end into \r\n. The report of the start
  // comes first.
  const std::vector<std::string> lines = lines_of(outcome.output);
  ASSERT_GE(lines.size(), 2u) << outcome.output;
  EXPECT_EQ(lines.back().rfind("Run interrupted", 0), 0u) << lines.back();
  const std::string &progress = lines[lines.size() - 2];
  EXPECT_EQ(progress.front(), '\r');
  // At most one a second, at the end one more.
  const auto n_updates = std::count(progress.begin(), progress.end(), '\r') - 1;
  EXPECT_GE(n_updates, 2);
  EXPECT_LE(n_updates, seconds.count() + 1.);
  for (const std::string part : {"%", "t = ", "step = ", "slip rate", "left"})
    expect_part(progress, part);
}



TEST(ProgramRun, FileReceivesPlainLines)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene_with_event);
  const Outcome outcome = run_program(folder, "scene.prm");
  EXPECT_EQ(outcome.output.find('\r'), std::string::npos);
  const std::vector<std::string> lines = lines_of(outcome.output);
  ASSERT_GE(lines.size(), 2u);
  expect_part(lines[lines.size() - 2], "100.0 %  t = 2.0000 s");
}



TEST(ProgramRun, WarnsOfConstantStepsThatAreTooLarge)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  const std::string constant =
    "scene.prm --set 'Time/Step size control=constant' "
    "--set 'Time/Largest step=0.1' --set 'Output/Write volume=false' ";
  const Outcome careless = run_program(folder, constant);
  ASSERT_EQ(careless.exit_status, 0) << careless.errors;
  expect_part(careless.output,
              "Warning: the estimated error of a time step reached ");
  expect_part(careless.output, ", more than Time/Tolerance = 1.3e-06.");

  const Outcome informed =
    run_program(folder, constant + "--overwrite --set 'Time/Tolerance=1e9'");
  ASSERT_EQ(informed.exit_status, 0) << informed.errors;
  EXPECT_EQ(informed.output.find("Warning"), std::string::npos);
}
