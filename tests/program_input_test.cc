// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/version.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "creeping_scene.h"
#include "run_program.h"
#include "scene_text.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  struct BadInput
  {
    std::string              arguments;
    std::vector<std::string> parts;
  };



  // Mistakes in the scene, and what the one line must say about it: the
  // entry, its value and what is allowed.
  const std::vector<BadInput> bad_inputs = {
    {"--set 'Boundary conditions/Sides=lower bottom, upper front'",
     {"Boundary conditions/Sides", "upper front", "left, right, bottom, top"}},
    {"--set 'Bodies/upper/Material/Poisson ratio=0.5'",
     {"Bodies/upper/Material/Poisson ratio", "'0.5'", "< 0.5"}},
    {"--set 'Faults/fault/a=-1'", {"Faults/fault/a", "'-1'", "> 0"}},
    {"--set 'Time/Ende=1'", {"Time/Ende", "'1'", "no such entry", "End time"}},
    {"--set 'Time/Step size control=magic'",
     {"Time/Step size control", "'magic'", "embedded, step doubling"}},
    {"--set 'Bodies/upper/Lower lateral corner=5' "
     "--set 'Bodies/upper/Upper lateral corner=7'",
     {"Bodies/upper", "'5, 7'", "overlap", "'-1, 1'"}},
    {"--set 'Boundary conditions/upper top/x value=2*/3'",
     {"Boundary conditions/upper top/x value", "'2*/3'", "x,y,t"}},
    {"--set 'nonsense'", {"'nonsense'", "Section/Subsection/Entry=value"}},
    {"--set", {"--set", "Section/Subsection/Entry=value"}},
    {"--set 'Bodies/upper/Thickness=-1'",
     {"Bodies/upper/Thickness", "'-1'", "> 0"}},
    {"--set 'Bodies/upper/Coarse cells=0, 1'",
     {"Bodies/upper/Coarse cells", "'0, 1'", ">= 1"}},
    {"--set 'Time/End time=0'", {"Time/End time", "'0'", "> 0"}},
    {"--set 'Time/End time=nan'", {"Time/End time", "'nan'", "> 0"}},
    {"--set 'Faults/fault/Initial state=x'",
     {"Faults/fault/Initial state", "'x'", "is -1 at (-1, 0) m", "> 0"}},
    {"--set 'Faults/fault/b=table none.txt'",
     {"Faults/fault/b", "'table none.txt'", "none.txt' does not exist"}},
    {"--set 'Gravity/Acceleration=0' "
     "--set 'Faults/fault/Normal stress=initial equilibrium'",
     {"Faults/fault/Normal stress", "nothing presses", "'function'"}},
    {"--set 'Bodies/upper/Thickness=1e-300'",
     {"Bodies/upper/Thickness", "'1e-300'", "out of all proportion"}},
    {"--set 'Output/Output directory=file/output'",
     {"Output/Output directory", "'file/output'", "cannot be created"}},
    {"--set 'Output/Output directory=file'",
     {"Output/Output directory", "'file'", "cannot be created"}},
    {"other.prm", {"'other.prm'", "one is allowed"}},
    {"--fast", {"'--fast'", "--set"}}};



  std::vector<std::string>
  names_in(const TemporaryFolder &folder)
  {
    std::vector<std::string> names;
    for (const auto &item :
         std::filesystem::recursive_directory_iterator(folder.path))
      names.push_back(item.path().string());
    std::sort(names.begin(), names.end());
    return names;
  }



  void
  expect_one_line_and_no_trace(const std::string              &arguments,
                               const std::vector<std::string> &parts)
  {
    SCOPED_TRACE(arguments);
    const TemporaryFolder folder;
    folder.write("scene.prm", creeping_bodies);
    folder.write("empty.prm", "");
    folder.write("file", "");
    folder.write("output.txt", "");
    folder.write("errors.txt", "");
    const auto    before  = names_in(folder);
    const Outcome outcome = run_program(folder, arguments);

    EXPECT_EQ(outcome.exit_status, 1);
    // Mistakes that the start finds follow the report of it.
    EXPECT_TRUE(outcome.output.empty() ||
                outcome.output.rfind("Meshes: ", 0) == 0)
      << outcome.output;
    EXPECT_EQ(names_in(folder), before);
    const std::string &line = outcome.errors;
    EXPECT_EQ(line.rfind("stickslip: ", 0), 0u) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.substr(line.size() - 2), ".\n") << line;
    for (const std::string &part : parts)
      EXPECT_NE(line.find(part), std::string::npos)
        << "'" << part << "' is missing in: " << line;
  }
} // namespace



TEST(ProgramInput, MistakesInAScene)
{
  for (const BadInput &input : bad_inputs)
    expect_one_line_and_no_trace("scene.prm " + input.arguments, input.parts);
}



TEST(ProgramInput, MistakesInFiles)
{
  expect_one_line_and_no_trace("none.prm", {"'none.prm'", "does not exist"});
  expect_one_line_and_no_trace("empty.prm",
                               {"Bodies/Names", "''", "at least one"});
  expect_one_line_and_no_trace(".", {"'.'", "not a file"});
  expect_one_line_and_no_trace("", {"FILE.prm"});
}



TEST(Program, SaysInOneLineWhatIsWrongAndLeavesNoFolder)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", two_bodies);
  const Outcome outcome =
    run_program(folder, "scene.prm --set 'Bodies/upper/Thickness=-1'");
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errors,
            "stickslip: 'Bodies/upper/Thickness' = '-1' (--set): must be a "
            "number > 0 (in m).\n");
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
            "stickslip: 'Time/Smallest step' = '2' (--set): must not be larger "
            "than 'Initial step' = '0.001'.\n");
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
  EXPECT_EQ(outcome.output.find("stickslip " + std::string(version) +
                                "\nrevision "),
            0u);
  for (const char *library : {"deal.II", "MPI", "HDF5", "Trilinos"})
    EXPECT_NE(outcome.output.find("\n" + std::string(library) + " "),
              std::string::npos)
      << library;
}



TEST(Program, PrintsAllEntriesOfAScene)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  const Outcome printed =
    run_program(folder,
                "scene.prm --print-parameters "
                "--set 'Time/End time=0.25' > all.prm && ls");
  EXPECT_EQ(printed.exit_status, 0) << printed.errors;
  EXPECT_EQ(printed.output, "all.prm\nerrors.txt\noutput.txt\nscene.prm\n");
  // The printed text is a scene of the same entries.
  const Outcome again =
    run_program(folder, "all.prm --print-parameters | cmp - all.prm");
  EXPECT_EQ(again.exit_status, 0) << again.output << again.errors;
  const std::string text = content_of(folder.file("all.prm"));
  EXPECT_NE(text.find("End time"), std::string::npos);
  EXPECT_NE(text.find("0.25"), std::string::npos);
  // Defaults as well.
  EXPECT_NE(text.find("Fault longest interval"), std::string::npos);
}



TEST(Program, NamesAllItsOptionsInTheHelp)
{
  const TemporaryFolder folder;
  const Outcome         help    = run_program(folder, "--help");
  const Outcome         refused = run_program(folder, "--nonsense");
  EXPECT_EQ(help.exit_status, 0);
  // The error names all there are.
  const std::regex  option("--[a-z-]+");
  unsigned int      n_options = 0;
  const std::string list =
    refused.errors.substr(refused.errors.find("allowed are"));
  for (std::sregex_iterator match(list.begin(), list.end(), option), end;
       match != end;
       ++match, ++n_options)
    EXPECT_NE(help.output.find("  " + match->str()), std::string::npos)
      << match->str();
  EXPECT_GE(n_options, 7u);
}
