// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "project_directories.h"
#include "run_program.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string all_fields = R"(
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia = quasi-dynamic
end
subsection Output
  set Fault fields = slip, slip_rate, shear_traction, normal_stress, state, contact_pressure, position
end
)";

  const std::string junction = all_fields + R"(
subsection Bodies
  set Names     = base, west, east
  set Mesh file = t_junction.msh
end
subsection Faults
  set Names = main, branch
  subsection main
    set Normal stress          = function
    set Normal stress function = 100
  end
  subsection branch
    set Normal stress          = function
    set Normal stress function = 50
  end
end
subsection Boundary conditions
  set Sides = base bottom, west top, east top
  subsection base bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection west top
    set x condition = velocity
    set x value     = 1e-2
    set y condition = velocity
    set y value     = 1e-3
  end
  subsection east top
    set x condition = velocity
    set x value     = 1e-2
    set y condition = velocity
  end
end
)";

  // The ring is sheared around the disc.
  const std::string ring = all_fields + R"(
subsection Bodies
  set Names     = disc, ring
  set Mesh file = ring.msh
  subsection disc
    set Uniform refinements = 1
  end
  subsection ring
    set Uniform refinements = 2
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Normal stress          = function
    set Normal stress function = 100
  end
end
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set x condition = velocity
    set x value     = 1e-2 * y
    set y condition = velocity
    set y value     = 1e-2 * x
  end
end
)";

  const std::string patch = all_fields + R"(
set Dimension = 3
subsection Bodies
  set Names     = block
  set Mesh file = patch.msh
end
subsection Faults
  set Names = patch
  subsection patch
    set Normal stress          = function
    set Normal stress function = 100
  end
end
subsection Boundary conditions
  set Sides = block bottom, block top
  subsection block bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
  subsection block top
    set x condition = velocity
    set x value     = 1e-2
    set y condition = velocity
    set y value     = 3e-3
    set z condition = velocity
  end
end
)";



  // One of the bricks is finer than the other, with hanging nodes.
  const std::string bricks = all_fields + R"(
set Dimension = 3
subsection Bodies
  set Names = lower, upper
  subsection lower
    set Lower lateral corner = 0, 0
    set Upper lateral corner = 2, 1
    set Thickness            = 0.5
    set Coarse cells         = 2, 1, 1
  end
  subsection upper
    set Lower lateral corner = 0, 0
    set Upper lateral corner = 2, 1
    set Thickness            = 1
    set Coarse cells         = 2, 1, 1
    set Refinement passes    = 1
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Normal stress          = function
    set Normal stress function = 100
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
    set z condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 1e-2
    set y condition = velocity
    set y value     = 3e-3
  end
end
)";



  /** Run a scene, on several processes if a launcher is given; what is wrong
   * with the files of its faults. */
  std::string
  problems_of(const std::string &mesh,
              const std::string &scene,
              const std::string &end_time,
              const std::string &options,
              const std::string &faults,
              const std::string &launcher = "")
  {
    const TemporaryFolder folder;
    folder.write("scene.prm", scene);
    const Outcome run =
      run_command(folder,
                  "cp '" STICKSLIP_SOURCE_DIR "/tests/meshes/" + mesh +
                    "' . && " + program(launcher) +
                    " scene.prm --set 'Time/End time=" + end_time + "'");
    EXPECT_EQ(run.exit_status, 0) << run.errors;
    const Outcome check = run_command(folder,
                                      "/usr/bin/python3 '" STICKSLIP_SOURCE_DIR
                                      "/tests/check_fault_surfaces.py' " +
                                        options + " output/scene " + faults);
    EXPECT_EQ(check.errors, "");
    return check.output;
  }



  const std::string two_processes =
    "timeout --foreground -k 5 120 env OMPI_MCA_orte_execute_quiet=1 "
    "OMPI_MCA_rmaps_base_oversubscribe=1 "
    "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe mpirun -np 2 ";
} // namespace



TEST(ProgramSurfaces, OfABentFaultAndItsBranch)
{
  EXPECT_EQ(
    problems_of("t_junction.msh", junction, "1", "--box", "main branch"), "");
}



TEST(ProgramSurfaces, OfAClosedFault)
{
  EXPECT_EQ(problems_of("ring.msh", ring, "1", "", "fault"), "");
}



TEST(ProgramSurfaces, OfAPatchInSpaceOnTwoProcesses)
{
  EXPECT_EQ(
    problems_of("patch.msh", patch, "0.5", "--box", "patch", two_processes),
    "");
}



TEST(ProgramSurfaces, OfALevelFaultBetweenBricks)
{
  EXPECT_EQ(problems_of("patch.msh", bricks, "0.1", "--box", "fault"), "");
}
