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



// A group of cells need not be of one piece.
TEST(ProgramCheck, SaysHowManyPartsABodyHas)
{
  const TemporaryFolder folder;
  folder.write("islands.msh",
               "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
               "$PhysicalNames\n3\n1 1 \"bottom\"\n1 2 \"rest\"\n"
               "2 3 \"rock\"\n$EndPhysicalNames\n"
               "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
               "5 3 0 0\n6 4 0 0\n7 4 1 0\n8 3 1 0\n$EndNodes\n"
               "$Elements\n10\n1 1 2 1 1 1 2\n2 1 2 1 1 5 6\n"
               "3 1 2 2 1 2 3\n4 1 2 2 1 3 4\n5 1 2 2 1 4 1\n"
               "6 1 2 2 1 6 7\n7 1 2 2 1 7 8\n8 1 2 2 1 8 5\n"
               "9 3 2 3 1 1 2 3 4\n10 3 2 3 1 5 6 7 8\n$EndElements\n");
  folder.write("scene.prm",
               "subsection Bodies\n set Names = rock\n"
               " set Mesh file = islands.msh\nend\n"
               "subsection Faults\n set Names =\nend\n"
               "subsection Boundary conditions\n set Sides = rock bottom\n"
               " subsection rock bottom\n  set x condition = fixed\n"
               "  set y condition = fixed\n end\nend\n");
  const Outcome outcome = run_program(folder, "--check scene.prm");
  EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
  expect_parts(outcome.output,
               {"rock: 2 quadrilaterals",
                "2 m^2, in 2 parts that share no "
                "face\n"});
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
