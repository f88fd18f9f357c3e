// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>

#include <sstream>

#include "scene_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string fault_entry = "subsection Faults\n subsection main\n  set ";



  SceneParameters<2>
  read(const std::string &file, const std::vector<std::string> &overrides = {})
  {
    return SceneReader(file, overrides).read<2>();
  }



  double
  value_of_a(const SceneParameters<2> &scene, const double x)
  {
    return scene.faults[0]["a"].values<2>({Point<2>(x, 0)}, "").front();
  }



  std::string
  as_text(const SceneParameters<2> &scene)
  {
    std::ostringstream text;
    write_parameters(scene, text);
    return text.str();
  }
} // namespace



TEST(FieldsOfAScene, TablesAreFoundNextToTheFileThatNamesThem)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "inner");
  folder.write("inner/a.txt", "x\n-1 0.01\n1 0.03\n");
  folder.write("inner/part.prm",
               two_bodies + fault_entry + "a = table a.txt\n end\nend\n");
  const std::string file =
    folder.write("scene.prm", "include inner/part.prm\n");
  const SceneParameters<2> scene = read(file);
  EXPECT_NEAR(value_of_a(scene, 0.5), 0.025, 1e-15);

  // The scene that is written back can be read from anywhere and is the same.
  std::filesystem::create_directory(folder.path / "output");
  write_parameters(scene, folder.file("output/parameters.prm"));
  const SceneParameters<2> again = read(folder.file("output/parameters.prm"));
  EXPECT_EQ(as_text(again), as_text(scene));
  EXPECT_EQ(value_of_a(again, 0.3), value_of_a(scene, 0.3));

  // On the command line they begin in the current folder.
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path / "inner");
  const SceneParameters<2> overridden =
    read(folder.file("scene.prm"), {"Faults/main/b=table a.txt"});
  std::filesystem::current_path(before);
  EXPECT_EQ(overridden.faults[0]["b"].text(),
            "table " + folder.file("inner/a.txt"));
}



TEST(FieldsOfAScene, AllFrictionParametersMayVary)
{
  const TemporaryFolder    folder;
  const SceneParameters<2> scene =
    read(folder.write("scene.prm", two_bodies),
         {"Faults/main/a=0.01 + 0.001*x^2",
          "Faults/main/b=if(abs(x) < 1, 0.02, 0)",
          "Faults/main/Reference friction coefficient=0.5 + 0.01*x",
          "Faults/main/Reference slip rate=1e-6*exp(x)",
          "Faults/main/Characteristic slip=1e-5*(3 + x)"});
  // a, b, mu0, V0, L, and the positions of two words.
  const std::vector<LawValues> values =
    scene.faults[0].law_values<2>({Point<2>(0.5, 0), Point<2>(2, 0)},
                                  "Faults/main");
  ASSERT_EQ(values[0].all().size(), 7u);
  EXPECT_DOUBLE_EQ(values[0].all()[0], 0.01025);
  EXPECT_DOUBLE_EQ(values[1].all()[0], 0.014);
  EXPECT_EQ(values[0].all()[1], 0.02);
  EXPECT_EQ(values[1].all()[1], 0.);
  EXPECT_DOUBLE_EQ(values[1].all()[2], 0.52);
  EXPECT_DOUBLE_EQ(values[0].all()[3], 1e-6 * std::exp(0.5));
  EXPECT_DOUBLE_EQ(values[1].all()[4], 5e-5);
}



TEST(FieldsOfAScene, MistakesAreFoundBeforeTheRun)
{
  const TemporaryFolder folder;
  const std::string     file = folder.write("scene.prm", two_bodies);
  folder.write("bad.txt", "x\n0 1\n1 -1\n");
  folder.write("broken.txt", "x\n0 1\n1 one\n");
  const auto expect_error = [&](const std::string              &override,
                                const std::vector<std::string> &parts) {
    try
      {
        read(file, {override});
        ADD_FAILURE() << "no error: " << override;
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &part : parts)
          EXPECT_NE(message.find(part), std::string::npos)
            << "'" << part << "' is missing in: " << message;
      }
  };
  // The common part of the two bodies reaches from -1 to 2.5.
  expect_error("Faults/main/a=0.005*(x + 1)",
               {"'Faults/main/a' = '0.005*(x + 1)'",
                "is 0 at (-1, 0) m",
                "a number > 0 everywhere."});
  expect_error(
    "Faults/main/Characteristic slip=-1e-5",
    {"'Faults/main/Characteristic slip' = '-1e-5' (--set)",
     "must be a number > 0 (in m), an expression in x, y (z), or table "
     "FILE."});
  expect_error("Faults/main/b=table " + folder.file("bad.txt"),
               {"'Faults/main/b' = 'table ",
                "bad.txt' (--set): is -1 at (2.5, 0) m",
                "a number >= 0"});
  expect_error("Faults/main/b=table " + folder.file("broken.txt"),
               {"'Faults/main/b' = 'table ",
                "(--set): cannot be used: ",
                "broken.txt, line 3: 'one' is not a number."});
}
