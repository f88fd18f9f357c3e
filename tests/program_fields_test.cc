// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <cmath>

#include "creeping_scene.h"
#include "project_directories.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Print what a faults.h5, and then the last VTU file of a folder, hold. */
  const std::string print_names = R"py(
import h5py, pathlib, re, sys
folder = pathlib.Path(sys.argv[1])
if (folder / "faults.h5").exists():
    print(*sorted(h5py.File(folder / "faults.h5")["fault"]))
for path in sorted(folder.glob("*.vtu"))[-1:]:
    names = re.findall('<DataArray[^>]*Name="([^"]+)"', path.read_text())
    print(*[n for n in names if n not in ("TIME", "Points", "connectivity", "offsets", "types")])
)py";



  std::string
  names_in(const TemporaryFolder &folder, const std::string &output)
  {
    folder.write("names.py", print_names);
    const Outcome outcome =
      run_command(folder, "/usr/bin/python3 names.py " + output);
    EXPECT_EQ(outcome.errors, "");
    return outcome.output;
  }



  void
  run_without_problems(const TemporaryFolder &folder,
                       const std::string     &arguments)
  {
    const Outcome outcome = run_program(folder, arguments);
    ASSERT_EQ(outcome.exit_status, 0) << outcome.errors;
    ASSERT_EQ(outcome.errors, "");
  }
} // namespace



TEST(ProgramFields, BelongTogether)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  // The load shakes the upper body.
  run_without_problems(
    folder,
    "scene.prm --set 'Boundary conditions/upper top/y condition=traction' "
    "--set 'Boundary conditions/upper top/y value=-2e4 * sin(40 * t)^2' "
    "--set 'Boundary conditions/upper top/Ramp length=0.01' "
    "--set 'Time/End time=0.11' "
    "--set 'Output/Fault fields=slip, slip_rate, shear_traction, "
    "normal_stress, state, contact_pressure, contact_weight' "
    "--set 'Output/Volume fields=displacement, velocity, acceleration, stress, "
    "strain, body, material'");
  EXPECT_EQ(problems_of_output(folder, "output/scene"), "");
  const double  load = 2. * 2e4 * std::pow(std::sin(40 * 0.11), 2);
  const Outcome check =
    run_command(folder,
                "/usr/bin/python3 '" STICKSLIP_SOURCE_DIR
                "/tests/check_output_fields.py' output/scene " +
                  std::to_string(load));
  EXPECT_EQ(check.output, "");
  EXPECT_EQ(check.errors, "");
  EXPECT_EQ(names_in(folder, "output/scene"),
            "arc_length axes contact_pressure contact_weight coordinates faces "
            "normal_stress shear_traction slip slip_rate state time weight\n"
            "body_names displacement velocity acceleration stress_xx stress_xy "
            "stress_yy stress_zz strain_xx strain_xy strain_yy body\n");
}



TEST(ProgramFields, OnlyThoseAskedForAreWritten)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  run_without_problems(folder,
                       "scene.prm --set 'Time/End time=0.5' "
                       "--set 'Output/Fault fields=slip_rate' "
                       "--set 'Output/Volume fields=velocity' "
                       "--set 'Output/Time series steps=4'");
  const std::string names =
    "arc_length axes coordinates faces slip_rate time weight\n"
    "body_names velocity\n";
  EXPECT_EQ(names_in(folder, "output/scene"), names);

  // The choice is kept with the parameters.
  run_without_problems(folder,
                       "output/scene/parameters.prm "
                       "--set 'Output/Output directory=again'");
  EXPECT_EQ(names_in(folder, "again"), names);

  // Every fourth step and the last one.
  run_without_problems(folder,
                       "scene.prm --set 'Time/End time=0.5' "
                       "--set 'Output/Output directory=all'");
  const Outcome rows =
    run_command(folder,
                "awk -F, 'NR == 1 || $1 % 4 == 0' all/time_series.csv > rows\n"
                "tail -n 1 all/time_series.csv >> rows\n"
                "uniq rows | cmp - again/time_series.csv && wc -l < rows");
  EXPECT_EQ(rows.exit_status, 0) << rows.output << rows.errors;
  EXPECT_GT(std::stoi(rows.output), 5);
}



TEST(ProgramFields, FilesNotAskedForAreNotThere)
{
  const TemporaryFolder folder;
  folder.write("scene.prm", creeping_bodies);
  run_without_problems(folder,
                       "scene.prm --set 'Time/End time=0.02' "
                       "--set 'Output/Write faults=false' "
                       "--set 'Output/Write fault surfaces=false' "
                       "--set 'Output/Write volume=false' "
                       "--set 'Output/Time series steps=0'");
  const Outcome files = run_command(folder, "cd output/scene && ls");
  EXPECT_EQ(
    files.output,
    "checkpoints\ncolumns.csv\nevents.csv\nparameters.prm\nsummary.txt\n");
}
