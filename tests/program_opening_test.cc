// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <cmath>
#include <sstream>

#include "project_directories.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // A block that falls upon another one, and bounces.
  const char *const bouncing_block = R"(
subsection Bodies
  set Names          = foundation, block
  set Base elevation = -1
  subsection foundation
    set Lower lateral corner = -1.5
    set Upper lateral corner = 1.5
    set Thickness            = 1
    set Coarse cells         = 3, 1
    set Uniform refinements  = 2
    set Refinement passes    = 0
  end
  subsection block
    set Lower lateral corner = -1
    set Upper lateral corner = 0.9
    set Thickness            = 0.8
    set Coarse cells         = 3, 1
    set Uniform refinements  = 2
    set Refinement passes    = 0
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Contact     = unilateral
    set Initial gap = 0.001 + 0.0005 * x
  end
end
subsection Boundary conditions
  set Sides = foundation bottom
  subsection foundation bottom
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Gravity
  set Acceleration = 9.81
end
subsection Time
  set Step size control = constant
  set Largest step      = 2e-4
  set End time          = 0.06
end
subsection Output
  set Event start slip rate = 1
end
)";
} // namespace



TEST(ProgramOpening, FilesOfABounceAgree)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", bouncing_block);
  const Outcome run = run_program(folder, "scene.prm");
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  const Outcome surfaces =
    run_command(folder,
                "/usr/bin/python3 '" STICKSLIP_SOURCE_DIR
                "/tests/check_fault_surfaces.py' output/scene fault");
  EXPECT_EQ(surfaces.output + surfaces.errors, "");

  // The fault is open from the start, lands, and part of it opens once more.
  std::istringstream openings(
    content_of(folder.file("output/scene/openings.csv")));
  std::string line;
  std::getline(openings, line);
  ASSERT_TRUE(std::getline(openings, line));
  std::istringstream  row(line);
  std::string         fault, item;
  std::vector<double> values;
  std::getline(row, fault, ',');
  while (std::getline(row, item, ','))
    values.push_back(std::stod(item));
  ASSERT_EQ(values.size(), 7u);
  EXPECT_EQ(values[0], 0);
  // The block falls, and the foundation, which has been relieved, comes to
  // meet it.
  EXPECT_GT(values[2], 0.005);
  EXPECT_LT(values[2], std::sqrt(2 * 0.00145 / 9.81));
  EXPECT_NEAR(values[3], 0.00145, 1e-15);
  EXPECT_TRUE(std::getline(openings, line));
}
