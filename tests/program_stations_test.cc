// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <cmath>
#include <sstream>
#include <vector>

#include "creeping_scene.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Points of the fault and of both bodies there, inside a face whose nodes
  // match; and one on the side that moves.
  const std::string scene = creeping_bodies + R"(
subsection Output
  set Stations = on_fault: fault 0.3 0, below: lower 0.3 0, above: upper 0.3 0, side: upper 10 cm 50 cm
  set Station slip rate factor = 1.1
end
)";



  using Rows = std::vector<std::vector<double>>;

  /** The numbers of a file, below its header. */
  Rows
  rows_of(const TemporaryFolder &folder, const std::string &file)
  {
    std::istringstream lines(content_of(folder.file(file)));
    Rows               rows;
    bool               is_below = false;
    for (std::string line; std::getline(lines, line);)
      if (is_below)
        {
          rows.emplace_back();
          std::istringstream numbers(line);
          for (double x; numbers >> x;)
            rows.back().push_back(x);
        }
      else
        is_below = (line.rfind("t ", 0) == 0);
    return rows;
  }



  void
  expect_same(const Rows &a, const Rows &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (unsigned int i = 0; i < a.size(); ++i)
      {
        ASSERT_EQ(a[i].size(), b[i].size());
        for (unsigned int j = 0; j < a[i].size(); ++j)
          EXPECT_NEAR(a[i][j], b[i][j], 1e-5 * std::max(1., std::abs(b[i][j])));
      }
  }
} // namespace



TEST(ProgramStations, AgreeWithEachOtherAndWithTheMotionOfASide)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  const Outcome outcome = run_program(folder, "scene.prm");
  ASSERT_EQ(outcome.exit_status, 0) << outcome.errors;
  const std::string stations = "output/scene/stations/";
  const Rows        fault    = rows_of(folder, stations + "on_fault.dat"),
             below           = rows_of(folder, stations + "below.dat"),
             above           = rows_of(folder, stations + "above.dat"),
             side            = rows_of(folder, stations + "side.dat");
  ASSERT_GT(fault.size(), 20u);
  ASSERT_EQ(fault.size(), below.size());
  ASSERT_EQ(fault.size(), above.size());
  ASSERT_EQ(fault.size(), side.size());
  EXPECT_EQ(fault.front()[0], 0.);
  EXPECT_EQ(fault.back()[0], 2.);
  for (unsigned int i = 0; i < fault.size(); ++i)
    {
      // t slip slip_rate shear_stress state, and t disp_1 disp_2 vel_1 vel_2.
      ASSERT_EQ(fault[i].size(), 5u);
      ASSERT_EQ(above[i].size(), 5u);
      EXPECT_NEAR(fault[i][1],
                  above[i][1] - below[i][1],
                  1e-6 * std::abs(above[i][1]) + 1e-15);
      const double rate = above[i][3] - below[i][3];
      if (rate > 1e-6)
        {
          EXPECT_NEAR(fault[i][2], std::log10(rate), 1e-4);
        }
    }
  EXPECT_GT(fault.back()[1], 1e-4);
  // The side has moved at 1 mm/s since t = 1 s.
  EXPECT_NEAR(side.back()[3], 1e-3, 1e-9);
  EXPECT_NEAR(side.back()[4], 0., 1e-5);
  for (unsigned int i = 1; i < side.size(); ++i)
    if (side[i - 1][0] > 1.)
      {
        EXPECT_NEAR(side[i][1] - side[i - 1][1],
                    1e-3 * (side[i][0] - side[i - 1][0]),
                    2e-9);
      }
  // The friction of the law, with mu0 = 0 and a normal stress of 0.02 MPa.
  const double V     = std::pow(10., fault.back()[2]),
               theta = std::pow(10., fault.back()[4]);
  EXPECT_NEAR(fault.back()[3],
              0.02 * 0.02 *
                std::asinh(V / 2e-3 * std::exp(0.01 / 0.02 * std::log(theta))),
              1e-3 * fault.back()[3]);

  // Two processes, and a run that goes on.
  const Outcome shared = run_command(
    folder,
    program("env OMPI_MCA_rmaps_base_oversubscribe=1 "
            "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe mpirun -np "
            "2") +
      " scene.prm --set 'Output/Output directory=shared'");
  ASSERT_EQ(shared.exit_status, 0) << shared.errors;
  const Outcome half =
    run_program(folder,
                "scene.prm --set 'Output/Output directory=resumed' --set "
                "'Output/Checkpoint interval=0.5' --set 'Time/End time=1'");
  ASSERT_EQ(half.exit_status, 0) << half.errors;
  const Outcome resumed =
    run_program(folder,
                "scene.prm --restart --set 'Output/Output directory=resumed'");
  ASSERT_EQ(resumed.exit_status, 0) << resumed.errors;
  for (const std::string name : {"on_fault", "below", "above", "side"})
    {
      expect_same(rows_of(folder, "shared/stations/" + name + ".dat"),
                  rows_of(folder, stations + name + ".dat"));
      const Rows whole = rows_of(folder, "resumed/stations/" + name + ".dat");
      ASSERT_GT(whole.size(), 20u);
      EXPECT_EQ(whole.back()[0], 2.);
      for (unsigned int i = 1; i < whole.size(); ++i)
        EXPECT_GT(whole[i][0], whole[i - 1][0]);
    }
}



TEST(ProgramStations, OutsideAreRefusedWithOneSentence)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", scene);
  const auto errors_of = [&](const std::string &stations) {
    const Outcome outcome =
      run_program(folder, "scene.prm --set 'Output/Stations=" + stations + "'");
    EXPECT_EQ(outcome.exit_status, 1);
    return outcome.errors;
  };
  EXPECT_EQ(
    errors_of("high: fault 0 0.2"),
    "stickslip: 'Output/Stations' = 'high: fault 0 0.2' (--set): 'high' "
    "at (0, 0.2) m is outside of the fault 'fault', 0.2 m from it.\n");
  EXPECT_EQ(
    errors_of("left: upper -3 0.5"),
    "stickslip: 'Output/Stations' = 'left: upper -3 0.5' (--set): 'left' "
    "at (-3, 0.5) m is outside of the body 'upper', 2 m from it.\n");
  EXPECT_EQ(errors_of("nowhere: rock 0 0"),
            "stickslip: 'Output/Stations' = 'nowhere: rock 0 0' (--set): "
            "'nowhere' is at 'rock', which is neither a fault nor a body.\n");
}
