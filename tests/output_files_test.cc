// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/atomic_file.h>
#include <stickslip/output/interrupt.h>
#include <stickslip/output/output_cadence.h>
#include <stickslip/output/output_directory.h>
#include <stickslip/output/progress.h>
#include <stickslip/output/pvd_record.h>
#include <stickslip/output/run_summary.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <sstream>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(OutputCadence, WritesFirstThenAfterTheLongestInterval)
{
  OutputCadence cadence({2, 0, 0.01, 0.5});
  EXPECT_TRUE(cadence.is_due(0, 0));
  cadence.note_written(0, 1e-9);
  EXPECT_FALSE(cadence.is_due(0.49, 1e-9));
  EXPECT_TRUE(cadence.is_due(0.5, 1e-9));

  // Whatever the sum of the steps is rounded to.
  double time = 0;
  for (unsigned int i = 0; i < 10; ++i)
    time += 0.05;
  ASSERT_LT(time, 0.5);
  EXPECT_TRUE(cadence.is_due(time, 1e-9));
}



TEST(OutputCadence, WritesAfterEnoughSlipAtASteadyRate)
{
  OutputCadence cadence({2, 1e-5, 0.01, 10});
  cadence.note_written(1, 1e-4);
  EXPECT_FALSE(cadence.is_due(1.09, 1e-4));
  EXPECT_TRUE(cadence.is_due(1.1, 1e-4));
  EXPECT_FALSE(cadence.is_due(1.005, 1.));
  EXPECT_TRUE(cadence.is_due(1.01, 1.));
}



TEST(OutputCadence, IsTheSameWheneverTheClockStarts)
{
  // Times that are numbers, and nothing that they are rounded to.
  const double step = std::ldexp(1., -10), start = std::ldexp(1., 33);
  for (const double slip_rate : {1e-9, 0.1, 1.})
    {
      OutputCadence now({2, 5e-3, 3 * step, 20 * step}),
        later({2, 5e-3, 3 * step, 20 * step});
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double time = i * step;
          const bool   due  = now.is_due(time, slip_rate);
          EXPECT_EQ(later.is_due(start + time, slip_rate), due)
            << "step " << i << " at " << slip_rate << " m/s";
          if (due)
            {
              now.note_written(time, slip_rate);
              later.note_written(start + time, slip_rate);
            }
        }
    }
}



TEST(OutputCadence, GoesOnFromAState)
{
  OutputCadence cadence({2, 0, 0.01, 0.5}), resumed({2, 0, 0.01, 0.5});
  cadence.note_written(1., 1e-3);
  resumed.resume(cadence.state());
  EXPECT_FALSE(resumed.is_due(1.1, 1e-3));
  EXPECT_TRUE(resumed.is_due(1.1, 2e-3));
  EXPECT_TRUE(resumed.is_due(1.5, 1e-3));
}



TEST(OutputCadence, WritesWhenTheSlipRateHasChangedButNotTooOften)
{
  OutputCadence cadence({2, 0, 0.01, 0.5});
  cadence.note_written(1, 1e-6);
  EXPECT_FALSE(cadence.is_due(1.1, 1.9e-6));
  EXPECT_TRUE(cadence.is_due(1.1, 2.1e-6));
  EXPECT_FALSE(cadence.is_due(1.1, 0.6e-6));
  EXPECT_TRUE(cadence.is_due(1.1, 0.4e-6));
  EXPECT_TRUE(cadence.is_due(1.1, 0));
  EXPECT_FALSE(cadence.is_due(1.005, 1.));
  EXPECT_TRUE(cadence.is_due(1.01, 1.));

  cadence.note_written(2, 0);
  EXPECT_FALSE(cadence.is_due(2.1, 0));
  EXPECT_TRUE(cadence.is_due(2.1, 1e-30));
}



TEST(OutputDirectory, IsMadeWithItsParents)
{
  const TemporaryFolder folder;
  const OutputDirectory directory(folder.file("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("a/b/c")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("a/b/c")));
  EXPECT_EQ(directory.file("x.csv"), folder.file("a/b/c/x.csv"));
}



TEST(OutputDirectory, RemovesEarlierResultsAndNothingElse)
{
  const TemporaryFolder folder;
  for (const char *name : {"time_series.csv",
                           "faults.h5",
                           "solution-0012.vtu",
                           "fault_main_00003.vtu",
                           "notes.txt",
                           "other.vtu"})
    folder.write(name, "old");
  OutputDirectory(folder.path.string()).remove_earlier_results();
  EXPECT_FALSE(std::filesystem::exists(folder.file("time_series.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("faults.h5")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("solution-0012.vtu")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("fault_main_00003.vtu")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("notes.txt")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("other.vtu")));
}



TEST(OutputDirectory, ReportsAFolderThatCannotBeMade)
{
  const TemporaryFolder folder;
  const std::string     file = folder.write("file", "");
  for (const std::string &path : {file, file + "/below"})
    try
      {
        OutputDirectory directory(path);
        FAIL() << path;
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("'Output/Output directory' = '" + path + "'"),
                  std::string::npos)
          << message;
      }
}



TEST(AtomicFile, ReplacesTheContentAndLeavesNothingElse)
{
  const TemporaryFolder folder;
  write_file_atomically(folder.file("a"), "a longer content");
  write_file_atomically(folder.file("a"), "short");
  EXPECT_EQ(content_of(folder.file("a")), "short");
  const auto items = std::filesystem::directory_iterator(folder.path);
  EXPECT_EQ(std::distance(begin(items), end(items)), 1);
  EXPECT_THROW(write_file_atomically(folder.file("no/a"), ""), InputError);
}



TEST(PvdRecord, ListsAllFilesAfterEachAddition)
{
  const TemporaryFolder folder;
  PvdRecord             record(folder.file("solution.pvd"));
  record.add(0, {"solution-0000.vtu"});
  record.add(1. / 3, {"a.vtu", "b.vtu"});
  EXPECT_EQ(content_of(folder.file("solution.pvd")),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0\" group=\"\" part=\"0\" "
            "file=\"solution-0000.vtu\"/>\n"
            "    <DataSet timestep=\"0.33333333333333331\" group=\"\" "
            "part=\"0\" file=\"a.vtu\"/>\n"
            "    <DataSet timestep=\"0.33333333333333331\" group=\"\" "
            "part=\"1\" file=\"b.vtu\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}



TEST(RunSummary, AlignsValuesAndKeepsTheOrder)
{
  RunSummary           summary;
  RunSummary::Section &mesh = summary.add_section("Mesh");
  mesh.add_count("vertices", 12345678);
  mesh.add("largest diameter", 0.708, "m");
  summary.add_section("Run").add("ended", "at the end time");
  mesh.add_count("cells", 3);
  std::ostringstream text;
  summary.print(text);
  EXPECT_EQ(text.str(),
            "Mesh\n"
            "  vertices          12345678\n"
            "  largest diameter  0.708 m\n"
            "  cells             3\n"
            "\n"
            "Run\n"
            "  ended             at the end time\n");
  const TemporaryFolder folder;
  summary.write(folder.file("summary.txt"));
  EXPECT_EQ(content_of(folder.file("summary.txt")), text.str());
}



TEST(Progress, RewritesOneLineOnATerminalOnceASecond)
{
  std::ostringstream out;
  double             now = 100;
  Progress           progress(out, true, 60, [&now]() { return now; });
  progress.update(1, 1, 0.5, 1e-9);
  EXPECT_EQ(out.str(), "");
  now = 101;
  progress.update(2, 6, 0.5, 2e-9);
  const std::string first = out.str();
  EXPECT_EQ(first.find('\r'), 0u);
  EXPECT_EQ(first.find('\n'), std::string::npos);
  for (const char *part :
       {"t = 6.0000 s", "step = 5.0e-01 s", "2.00e-09 m/s", "time left"})
    EXPECT_NE(first.find(part), std::string::npos) << first;
  now = 101.9;
  progress.update(3, 7, 0.5, 1e-9);
  EXPECT_EQ(out.str(), first);
  progress.finish();
  const std::string last = out.str().substr(first.size());
  EXPECT_NE(last.find("t = 7.0000 s"), std::string::npos);
  EXPECT_EQ(last.back(), '\n');
}



TEST(Progress, WritesPlainLinesToAFileAndEstimatesTheTimeLeft)
{
  std::ostringstream out;
  double             now = 0;
  Progress           progress(out, false, 40, [&now]() { return now; });
  progress.update(1, 0.5, 0.5, 1e-9);
  now = 9.9;
  progress.update(2, 9, 0.5, 1e-9);
  EXPECT_EQ(out.str(), "");
  now = 100;
  progress.update(3, 10, 0.5, 1e-9);
  // A quarter took 100 s, so three quarters take 300 s.
  EXPECT_NE(out.str().find(" 25.0 %"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("time left at least 5:00\n"), std::string::npos)
    << out.str();
  EXPECT_EQ(out.str().find('\r'), std::string::npos);
  const std::size_t length = out.str().size();
  progress.finish();
  EXPECT_EQ(out.str().size(), length);
}



namespace
{
  // Words on the time left after some steps, each of which takes
  // a second.
  class TimeLeft
  {
  public:
    TimeLeft(const unsigned int n_earlier_steps,
             const double       first_time,
             const unsigned int n_earlier_events)
      : step(n_earlier_steps)
      , progress(out, false, 100, [this]() { return clock; })
    {
      after(1, first_time, n_earlier_events);
    }

    std::string
    after(const unsigned int n_steps,
          const double       time,
          const unsigned int n_events)
    {
      step += n_steps;
      // Lines are ten seconds from each other at least.
      clock += n_steps;
      progress.update(step, time, 1, 1e-9, n_events);
      const std::string::size_type place = out.str().rfind("time left");
      return place == std::string::npos ? "" : out.str().substr(place);
    }

  private:
    std::ostringstream out;
    double             clock = 0;
    unsigned int       step;
    Progress           progress;
  };
} // namespace



TEST(Progress, EstimatesTheTimeLeftFromEvents)
{
  TimeLeft left(0, 1, 0);
  // Loading takes few steps: the first event is no measure for the others.
  EXPECT_EQ(left.after(19, 10, 0), "time left at least 3:00\n");
  EXPECT_EQ(left.after(20, 20, 1), "time left at least 2:40\n");
  // Sixty steps from one to the next, and seven of them to come.
  EXPECT_EQ(left.after(60, 30, 2), "time left 7:00\n");
  EXPECT_EQ(left.after(30, 39, 2), "time left 6:30\n");
  EXPECT_EQ(left.after(30, 40, 3), "time left 6:00\n");
  // The later half of three events is from the second to the third.
  EXPECT_EQ(left.after(120, 50, 4), "time left 7:30\n");
  // Steps that are more than in all cycles before set the pace.
  EXPECT_EQ(left.after(1620, 60, 4), "time left 40:00\n");
}



TEST(Progress, TakesEventsAtOnceForOne)
{
  // One rupture on two faults, whose few steps between are no cycle.
  TimeLeft left(0, 1, 0);
  left.after(99, 20, 1);
  EXPECT_EQ(left.after(10, 20.001, 2), "time left at least 7:20\n");
  EXPECT_EQ(left.after(90, 40, 3), "time left 5:00\n");
}



TEST(Progress, KnowsOfEarlierStepsWhereARunGoesOn)
{
  // In the middle of an event, whose steps are tiny.
  TimeLeft left(1000, 50, 3);
  EXPECT_EQ(left.after(999, 50.001, 3), "time left at least 33:20\n");
}



TEST(Progress, ShowsDurationsInAFormForPeople)
{
  EXPECT_EQ(duration(41.7), "42 s");
  EXPECT_EQ(duration(185), "3:05");
  EXPECT_EQ(duration(7800), "2:10:00");
}



TEST(Interrupt, NotesASignalAndGivesTheHandlersBack)
{
  const auto ignore         = [](int) {};
  void (*const before)(int) = ignore;
  std::signal(SIGTERM, before);
  {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.is_requested(MPI_COMM_SELF));
    std::raise(SIGTERM);
    EXPECT_TRUE(interrupt.is_requested(MPI_COMM_SELF));
  }
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), before);
}



TEST(Interrupt, ASecondSignalRightAfterTheFirstIsTheSame)
{
  const Interrupt interrupt;
  std::raise(SIGINT);
  std::raise(SIGTERM);
  std::raise(SIGINT);
  EXPECT_TRUE(interrupt.is_requested(MPI_COMM_SELF));
}



TEST(Interrupt, ASecondSignalLaterEndsTheProgram)
{
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
    {
      const Interrupt interrupt;
      std::raise(SIGINT);
      sleep(4);
      if (interrupt.is_requested(MPI_COMM_SELF))
        std::raise(SIGINT);
      _exit(0);
    }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGINT);
}
