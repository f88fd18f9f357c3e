// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/command_line.h>
#include <stickslip/scene/scene_reader.h>

#include "error_message.h"
#include "scene_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Reading this text of a scene in two dimensions must fail with a message
  // that has these parts.
  void
  expect_error(const std::string              &text,
               const std::vector<std::string> &overrides,
               const std::vector<std::string> &parts)
  {
    const TemporaryFolder folder;
    const std::string     file = folder.write("scene.prm", text);
    expect_one_sentence_with(message_of([&]() {
                               const SceneReader reader(file, overrides);
                               if (reader.dimension() == 2)
                                 reader.read<2>();
                               else
                                 reader.read<3>();
                             }),
                             parts);
    EXPECT_FALSE(std::filesystem::exists("output/scene"));
  }



  std::string
  with(const std::string &old_line, const std::string &new_line)
  {
    std::string       text  = two_bodies;
    const std::size_t place = text.find(old_line);
    EXPECT_NE(place, std::string::npos);
    return text.replace(place, old_line.size(), new_line);
  }
} // namespace



TEST(SceneErrors, EntryOutOfRangeIsNamedWithFileAndLine)
{
  expect_error(with("set b = 0.02", "set b = -0.02"),
               {},
               {"'Faults/main/b' = '-0.02'", "scene.prm, line 19", ">= 0"});
  expect_error(with("set b = 0.02", "set a = -0.01"),
               {},
               {"'Faults/main/a' = '-0.01'", "line 19", "> 0"});
  expect_error(with("set Young modulus = 1e7", "set Poisson ratio = 0.5"),
               {},
               {"'Bodies/lower/Material/Poisson ratio' = '0.5'",
                "line 9",
                "> -1 and < 0.5"});
  expect_error(with("State law = slip", "State law = ageing"),
               {},
               {"'Faults/main/State law' = 'ageing'", "one of: aging, slip"});
  expect_error(with("Coarse cells = 16, 1", "Coarse cells = 16"),
               {},
               {"'Bodies/lower/Coarse cells' = '16'", "2 whole numbers"});
  expect_error(with("set Dimension = 2", "set Dimension = 4"),
               {},
               {"'Dimension' = '4'", "line 1", "2 or 3"});
}



TEST(SceneErrors, OutputFieldsMustBeThere)
{
  expect_error(two_bodies,
               {"Output/Fault fields=slip, state, tau"},
               {"'Output/Fault fields' = 'slip, state, tau'",
                "any of, separated by commas: slip, slip_rate, "});
  expect_error(two_bodies,
               {"Output/Volume fields=velocity, acceleration",
                "Time/Inertia=quasi-static"},
               {"'Output/Volume fields'", "'acceleration'", "'dynamic'"});
}



TEST(SceneErrors, OverridesAreCheckedLikeTheFile)
{
  expect_error(two_bodies,
               {"Bodies/upper/Material/Poisson ratio=0.6"},
               {"'Bodies/upper/Material/Poisson ratio' = '0.6'",
                "--set",
                "< 0.5"});
  expect_error(two_bodies,
               {"Time/End tim=3"},
               {"'Time/End tim' = '3'", "no such entry", "End time"});
  expect_error(two_bodies, {"Time/End time"}, {"--set", "Time/End time"});
  expect_error(two_bodies, {"=3"}, {"--set", "=3"});
}



TEST(SceneErrors, NearestNameIsOffered)
{
  expect_error(with("set b = 0.02", "set Reference slip rat = 1e-6"),
               {},
               {"line 19", "did you mean 'Faults/main/Reference slip rate'"});
  // The missing entry is there under a misspelt name.
  expect_error(with("subsection Bodies\n", "subsection Bodys\n"),
               {},
               {"'Bodys/",
                "line 3",
                "no such subsection 'Bodys'; did you mean 'Bodies/"});
  expect_error(two_bodies,
               {"Faults/Nmes=main", "Faults/Names=main, other"},
               {"'Faults/Nmes' = 'main'", "did you mean 'Faults/Names'"});
}



TEST(SceneErrors, FilesOfOddBytes)
{
  const TemporaryFolder folder;
  // A byte order mark is taken.
  const std::string marked =
    folder.write("marked.prm", "\xEF\xBB\xBF" + std::string(two_bodies));
  EXPECT_EQ(SceneReader(marked).read<2>().bodies.size(), 2u);
  std::string text             = two_bodies;
  text[text.find("Dimension")] = '\0';
  expect_error(text, {}, {"scene.prm, line 1: there is a byte of value zero"});
  const std::string blanks(1000000, ' ');
  expect_error(with("set b = 0.02", "set b =" + blanks + "0.02" + blanks + "x"),
               {},
               {"'Faults/main/b' = '0.02 x'"});
  const std::string wide =
    folder.write("wide.prm",
                 with("Coarse cells = 16, 1",
                      "Coarse cells = 16," + blanks + "1"));
  EXPECT_EQ(SceneReader(wide).read<2>().bodies.size(), 2u);
}



TEST(SceneErrors, InertiaIsOneOfThree)
{
  expect_error(two_bodies,
               {"Time/Inertia=static"},
               {"'Time/Inertia' = 'static'",
                "dynamic, quasi-dynamic, quasi-static"});
}



TEST(SceneErrors, UnknownEntriesAndSections)
{
  expect_error(with("set b = 0.02", "set bb = 0.02"),
               {},
               {"'Faults/main/bb' = '0.02'", "line 19", "no such entry", "b,"});
  expect_error(with("subsection upper\n", "subsection uper\n"),
               {},
               {"'Bodies/uper/Lower lateral corner' = '-1'",
                "'uper' is not in 'Bodies/Names'",
                "did you mean 'upper'"});
}



TEST(SceneErrors, UnreadableFiles)
{
  expect_one_sentence_with(message_of(
                             []() { SceneReader("nowhere/none.prm"); }),
                           {"nowhere/none.prm", "does not exist"});
  expect_error("include none.prm\n", {}, {"line 1", "none.prm"});
  expect_error("subsection Bodies\n", {}, {"Bodies", "not closed"});
  expect_error("\nend\n", {}, {"line 2", "end"});
  expect_error("Dimension = 2\n", {}, {"line 1", "Dimension = 2"});
  expect_error("set Dimension 2\n", {}, {"line 1", "set Dimension 2"});
  const TemporaryFolder folder;
  folder.write("loop.prm", "include loop.prm\n");
  expect_one_sentence_with(message_of(
                             [&]() { SceneReader(folder.file("loop.prm")); }),
                           {"loop.prm", "nested"});
}



TEST(SceneErrors, AnEntrySetTwiceInOneFile)
{
  expect_error(with("set b = 0.02", "set b = 0.02\n set  b=0.03"),
               {},
               {"'Faults/main/b' = '0.03'", "line 20", "line 19"});
  // Also when the subsection is entered twice.
  expect_error(two_bodies + "subsection Time\n set End time = 9\nend\n",
               {},
               {"'Time/End time' = '9'", "second time"});
}



TEST(SceneErrors, Names)
{
  expect_error(with("lower, upper ", "lower, lower "),
               {},
               {"'Bodies/Names' = 'lower, lower'", "twice"});
  expect_error(with("Names = main", "Names = main, other"),
               {},
               {"'Faults/Names' = 'main, other'", "1 for the 2"});
  expect_error(with("set Names = main", ""),
               {},
               {"'main' is not in 'Faults/Names'", "there are no names"});
  expect_error(with("Names = main", "Names = ma.in"),
               {},
               {"'Faults/Names' = 'ma.in'", "letters, digits, _ and -"});
  expect_error(with("Names = main", "Names = Names"),
               {},
               {"'Faults/Names' = 'Names'", "another name"});
  expect_error("", {}, {"'Bodies/Names' = ''", "at least one"});
}



TEST(SceneErrors, Sides)
{
  const std::string sides = "set Sides = lower bottom, upper top";
  expect_error(with(sides, "set Sides = lower bottom, upper front"),
               {},
               {"'Boundary conditions/Sides' = 'lower bottom, upper front'",
                "'upper front' is no side",
                "left, right, bottom, top"});
  expect_error(with(sides, "set Sides = lower bottom, middle top"),
               {},
               {"'middle top' is on no body", "lower, upper"});
  expect_error(with(sides, "set Sides = lower bottom, lower top"),
               {},
               {"'lower top' is a fault", "outer sides"});
  expect_error(with(sides, "set Sides = lower bottom, upper bottom"),
               {},
               {"'upper bottom' is a fault"});
  expect_error(with(sides, "set Sides = upper top, lower bottom, upper  top"),
               {},
               {"'upper top' is listed twice"});
  expect_error(with(sides, "set Sides = lower bottom, top"),
               {},
               {"'lower bottom, top'", "two words"});
}



TEST(SceneErrors, Geometry)
{
  expect_error(two_bodies,
               {"Bodies/upper/Upper lateral corner=-1"},
               {"'Bodies/upper/Lower lateral corner' = '-1'", "less than"});
  expect_error(two_bodies,
               {"Bodies/upper/Lower lateral corner=2.5",
                "Bodies/upper/Upper lateral corner=4"},
               {"Bodies/upper", "2.5, 4", "overlap", "-2.5, 2.5"});
}



TEST(SceneErrors, TimeSteps)
{
  expect_error(two_bodies,
               {"Time/Smallest step=0.6", "Time/Largest step=0.5"},
               {"'Time/Smallest step' = '0.6'", "'Largest step' = '0.5'"});
  expect_error(two_bodies,
               {"Time/Initial step=0.7", "Time/Largest step=0.5"},
               {"'Time/Initial step' = '0.7'", "'Largest step' = '0.5'"});
  expect_error(two_bodies,
               {"Output/Fault longest interval=1e-4"},
               {"'Output/Fault shortest interval' = '0.001'",
                "'Fault longest interval' = '1e-04'"});
}



TEST(SceneErrors, Expressions)
{
  const std::string x_value = "Boundary conditions/upper top/x value";
  expect_error(two_bodies,
               {x_value + "=2e-4*speed"},
               {"'" + x_value + "' = '2e-4*speed'", "speed", "x,y,t"});
  expect_error(two_bodies,
               {x_value + "=1e-4*("},
               {"'" + x_value + "' = '1e-4*('"});
  expect_error(two_bodies, {x_value + "=0,5"}, {"'0,5'", "more than one"});
  expect_error(two_bodies, {x_value + "="}, {"'" + x_value + "' = ''"});
  // Fine at the start, infinite at the end of the run.
  expect_error(two_bodies,
               {x_value + "=1/(7-t)"},
               {"'1/(7-t)'", "t = 7", "finite"});
  expect_error(two_bodies,
               {"Faults/main/Initial state=t"},
               {"'Faults/main/Initial state' = 't'", "x,y"});
  // Negative at one end of the fault, which reaches from -1 to 2.5.
  expect_error(two_bodies,
               {"Faults/main/Initial state=x+0.5"},
               {"'Faults/main/Initial state' = 'x+0.5'",
                "is -0.5 at (-1, 0) m",
                "a number > 0"});
  expect_error(
    two_bodies,
    {"Faults/main/Normal stress function=-1"},
    {"'Faults/main/Normal stress function' = '-1'",
     "--set",
     "a number >= 0 (in Pa), an expression in x, y (z), or table FILE"});
  expect_error(two_bodies,
               {"Faults/main/Normal stress function=-x"},
               {"'Faults/main/Normal stress function' = '-x'",
                "is -2.5 at (2.5, 0) m",
                "a number >= 0"});
  expect_error(two_bodies,
               {"Boundary conditions/lower bottom/x value=1e-4"},
               {"'Boundary conditions/lower bottom/x value' = '1e-4'",
                "'x condition' = 'fixed'"});
}



TEST(SceneErrors, BodiesThatNothingHolds)
{
  expect_error(two_bodies,
               {"Boundary conditions/lower bottom/y condition=free"},
               {"'lower'", "'y condition'", "along y"});
  expect_error(two_bodies,
               {"Boundary conditions/lower bottom/x condition=traction"},
               {"'lower'", "'x condition'", "along x"});
}



TEST(SceneErrors, PeriodicBodiesOfDifferentExtents)
{
  expect_error(two_bodies,
               {"Boundary conditions/Periodic along x=true"},
               {"'Bodies/upper/Lower and Upper lateral corner' = '-1, 2.5'",
                "'lower'",
                "'-2.5, 2.5'",
                "'Boundary conditions/Periodic along x' = 'true'"});
}



TEST(SceneErrors, ConditionsOnSidesThatPeriodicityJoins)
{
  expect_error(with("set Sides = lower bottom, upper top",
                    "set Sides = lower bottom, upper top, lower left"),
               {"Boundary conditions/Periodic along x=true",
                "Bodies/upper/Lower lateral corner=-2.5"},
               {"'lower left'",
                "'Boundary conditions/Periodic along x' = 'true'"});
}



TEST(SceneErrors, EventsNeedAThreshold)
{
  const std::string at_rest = "Boundary conditions/upper top/x value=0";
  expect_error(two_bodies,
               {at_rest},
               {"'Output/Event start slip rate' = '0'", "> 0"});
  const TemporaryFolder folder;
  EXPECT_EQ(message_of([&]() {
              SceneReader(folder.write("scene.prm", two_bodies),
                          {at_rest, "Output/Event start slip rate=1e-4"})
                .read<2>();
            }),
            "no error");
}



TEST(CommandLine, TakesFileAndOverrides)
{
  const CommandLine line =
    parse_command_line({"a.prm", "--set", "x/y=1", "--set=z=2"});
  EXPECT_EQ(line.task, CommandLine::Task::run);
  EXPECT_EQ(line.parameter_file, "a.prm");
  EXPECT_EQ(line.overrides, (std::vector<std::string>{"x/y=1", "z=2"}));
  EXPECT_EQ(parse_command_line({"--help"}).task, CommandLine::Task::print_help);
  EXPECT_EQ(parse_command_line({"--parameter-reference"}).task,
            CommandLine::Task::print_parameter_reference);
}



TEST(CommandLine, RejectsWhatItDoesNotKnow)
{
  const auto message = [](const std::vector<std::string> &arguments) {
    return message_of([&]() { parse_command_line(arguments); });
  };
  expect_one_sentence_with(message({"a.prm", "--sat"}), {"'--sat'", "--set"});
  expect_one_sentence_with(message({"a.prm", "b.prm"}), {"'b.prm'", "'a.prm'"});
  expect_one_sentence_with(message({"a.prm", "--set"}), {"--set"});
  expect_one_sentence_with(message({}), {"No parameter file"});
}



TEST(SceneErrors, Foundations)
{
  expect_error(two_bodies,
               {"Bodies/lower/Rigid=true", "Bodies/upper/Rigid=true"},
               {"'Bodies/upper/Rigid' = 'true'", "'lower' below is rigid"});
  expect_error(two_bodies,
               {"Bodies/lower/Upper slope=0.1"},
               {"'Bodies/lower/Upper slope'", "highest body"});
  expect_error(two_bodies,
               {"Bodies/upper/Upper slope=-0.5"},
               {"'Bodies/upper/Upper slope'", "-0.75 m at the thin end"});
  expect_error(two_bodies,
               {"Bodies/upper/Upper slope=0.1", "Bodies/upper/Rigid=true"},
               {"'Bodies/upper/Upper slope'", "'Rigid'"});
  expect_error(two_bodies,
               {"Bodies/upper/Lower lateral corner=-2.5",
                "Bodies/upper/Upper slope=0.1",
                "Boundary conditions/Periodic along x=true"},
               {"'Bodies/upper/Upper slope' = '0.1'",
                "'Boundary conditions/Periodic along x' = 'true'"});
  // The upper side of the upper body is pressed.
  expect_error(two_bodies,
               {"Bodies/upper/Rigid=true"},
               {"'Boundary conditions/upper top/y condition' = 'traction'",
                "rigid"});
  expect_error(two_bodies,
               {"Bodies/upper/Rigid=true",
                "Boundary conditions/upper top/y condition=fixed",
                "Boundary conditions/upper top/y value=0",
                "Boundary conditions/upper top/x value=1e-4*x"},
               {"'Boundary conditions/upper top/x value' = '1e-4*x'",
                "position"});
  expect_error(with("set Sides = lower bottom",
                    "set Sides = lower left, lower bottom"),
               {"Bodies/lower/Rigid=true"},
               {"'Boundary conditions/Sides'", "two sides", "'lower'"});
  expect_error(two_bodies,
               {"Gravity/Dip=90"},
               {"'Gravity/Dip' = '90'", "< 90"});
}
