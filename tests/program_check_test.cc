// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <string>

#include "creeping_scene.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string meshes = STICKSLIP_SOURCE_DIR "/tests/meshes/";



  std::string
  scene(const std::string &mesh,
        const std::string &bodies,
        const std::string &faults,
        const std::string &held)
  {
    return "subsection Bodies\n set Names = " + bodies +
           "\n set Mesh file = " + meshes + mesh +
           "\nend\nsubsection Faults\n set Names = " + faults +
           "\nend\nsubsection Boundary conditions\n set Sides = " + held +
           "\n subsection " + held +
           "\n  set x condition = fixed\n  set y condition = velocity\n"
           "  set y value = 1e-3\n end\nend\n";
  }



  void
  expect_parts(const std::string &text, const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_NE(text.find(part), std::string::npos)
        << "'" << part << "' is missing in:\n"
        << text;
  }
} // namespace



TEST(ProgramCheck, SaysWhatIsInAMeshFile)
{
  const TemporaryFolder folder;
  folder.write(
    "scene.prm",
    scene("t_junction.msh", "base, west, east", "main, branch", "base bottom"));
  const Outcome outcome = run_program(folder, "--check scene.prm");
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_parts(outcome.output,
               {"base: 24 quadrilaterals",
                "4.2 m^2",
                "side bottom (1): 8 faces, 4 m\n",
                "first side on base (4): 8 faces",
                "second side on west (3): 4 faces",
                "Junction of 3 parts at (0, 0.1): main, branch\n"});
  const std::string picture =
    content_of(folder.file("output/scene/mesh_east.vtk"));
  // Twelve cells and fourteen faces around them.
  expect_parts(picture,
               {"DATASET UNSTRUCTURED_GRID", "CELLS 26 ", "MaterialID"});
  // Nothing was run.
  EXPECT_FALSE(
    std::filesystem::exists(folder.file("output/scene/time_series.csv")));
}



TEST(ProgramCheck, SaysWhereFaultsEnd)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene("slit.msh", "block", "slit", "block left"));
  const Outcome outcome = run_program(folder, "--check scene.prm");
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_parts(outcome.output,
               {"triangles",
                "first side on block (5): 4 faces, 1 m\n",
                "second side on block (6): 4 faces, 1 m\n",
                "ends inside a body at (-0.5, 0), (0.5, 0)\n"});
}



TEST(ProgramCheck, RefusesWhatCannotBeRefined)
{
  const TemporaryFolder folder;
  folder.write("scene.prm",
               "set Dimension = 3\n" +
                 scene("patch.msh", "block", "patch", "block bottom"));
  const Outcome fine =
    run_program(folder,
                "--check scene.prm --set 'Boundary conditions/block bottom/"
                "z condition=fixed'");
  EXPECT_EQ(fine.errors, "");
  expect_parts(fine.output, {"tetrahedra", "ends inside a body at"});
  const Outcome outcome =
    run_program(folder,
                "--check scene.prm --set 'Boundary conditions/block bottom/"
                "z condition=fixed' --set 'Bodies/block/Refinement passes=2'");
  EXPECT_EQ(outcome.exit_status, 1);
  expect_parts(outcome.errors,
               {"'Bodies/block/Refinement passes' = '2'", "tetrahedra"});
}



TEST(ProgramCheck, WorksForBricks)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  const Outcome outcome = run_program(folder, "scene.prm --check");
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_parts(outcome.output,
               {"quadrilaterals", "side left (1): ", "first side"});
}
