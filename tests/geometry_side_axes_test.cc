// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "simulation_scenes.h"
#include "temporary_folder.h"
#include "turned_layers.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/*
 * Conditions along the axes of a side against those along x and y.
 */

namespace
{
  using Settings = std::vector<std::string>;

  /** Conditions that drive the upper body: rollers below, ends that are held
   * along their tangent, and a top with a velocity along it and a pressure. */
  const std::string along_sides = R"(
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set Axes                 = side
    set tangential condition = fixed
    set normal condition     = fixed
  end
  subsection upper top
    set Axes                 = side
    set tangential condition = velocity
    set tangential value     = 2e-3
    set normal condition     = traction
    set normal value         = -1e4
    set Ramp length          = 0.1
  end
end
)",
                    along_space = R"(
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set x value     = 2e-3
    set y condition = traction
    set y value     = -1e4
    set Ramp length = 0.1
  end
end
)";



  std::string
  without_conditions(std::string scene)
  {
    const std::size_t begin = scene.find("subsection Boundary conditions"),
                      end   = scene.find("subsection Time");
    return scene.erase(begin, end - begin);
  }



  FaultSnapshot<2>
  run(const double angle, const Cells cells, const std::string &conditions)
  {
    const TemporaryFolder folder;
    folder.write("layers.msh", turned_layers(angle, cells).text());
    Simulation<2> simulation(
      SceneReader(folder.write("layers.prm",
                               without_conditions(turned_scene(angle)) +
                                 conditions),
                  {"Gravity/Dip=" + shortest_form(angle * 180. / numbers::PI),
                   "Time/Step size control=constant",
                   "Time/Largest step=0.02",
                   "Time/End time=1.2",
                   "Faults/fault/Friction=velocity strengthening",
                   "Time/Rate-state tolerance=1e-12",
                   "TNNMG/Tolerance=1e-13",
                   "TNNMG/Cycle precision=double",
                   "Output/Event start slip rate=1"})
        .read<2>(),
      MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    return snapshots(simulation).front();
  }
} // namespace



TEST(SideAxes, ABodyTurnedByThirtyDegreesMovesAsTheOneThatIsNot)
{
  for (const Cells cells : {Cells::quadrilaterals, Cells::triangles})
    {
      const FaultSnapshot<2> level  = run(0., cells, along_space),
                             turned = run(numbers::PI / 6., cells, along_sides);
      ASSERT_EQ(level.points.size(), turned.points.size());
      double slip = 0, traction = 0;
      for (unsigned int k = 0; k < level.points.size(); ++k)
        {
          slip     = std::max(slip, std::abs(level.slip[k][0]));
          traction = std::max(traction, std::abs(level.shear_traction[k][0]));
        }
      EXPECT_GT(slip, 1e-8);
      for (unsigned int k = 0; k < level.points.size(); ++k)
        {
          EXPECT_NEAR(turned.slip[k][0], level.slip[k][0], 1e-10 * slip);
          EXPECT_NEAR(turned.shear_traction[k][0],
                      level.shear_traction[k][0],
                      1e-10 * traction);
        }
    }
}



TEST(SideAxes, ErrorsAreInOneSentence)
{
  const auto message = [](const std::string &conditions) {
    return message_of(
      [&]() { run(numbers::PI / 6., Cells::quadrilaterals, conditions); });
  };
  std::string conditions = along_sides;
  const auto  with       = [&](const std::string &from, const std::string &to) {
    std::string text = along_sides;
    return text.replace(text.find(from), from.size(), to);
  };
  // Entries of other axes.
  expect_one_sentence_with(message(with("Axes                 = side",
                                        "Axes = space")),
                           {"tangential condition", "there is no such entry"});
  expect_one_sentence_with(message(with("set normal condition     = fixed",
                                        "set y condition = fixed")),
                           {"y condition", "there is no such entry"});
  // Sides that are held along the normal alone leave the bodies free along the
  // tangent.
  conditions =
    with("set tangential condition = fixed", "set tangential condition = free");
  conditions.replace(conditions.find("= velocity"), 10, "= traction");
  expect_one_sentence_with(message(conditions), {"float away"});
}



TEST(SideAxes, OfACurvedSideAreRefused)
{
  const TemporaryFolder folder;
  std::filesystem::copy(STICKSLIP_SOURCE_DIR "/tests/meshes/ring.msh",
                        folder.file("ring.msh"));
  const std::string text = R"(
subsection Bodies
  set Names     = disc, ring
  set Mesh file = ring.msh
end
subsection Faults
  set Names = fault
end
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set Axes                 = side
    set normal condition     = velocity
    set normal value         = -1e-6
    set tangential condition = fixed
  end
end
)";
  expect_one_sentence_with(
    message_of([&]() {
      Simulation<2>(SceneReader(folder.write("ring.prm", text)).read<2>(),
                    MPI_COMM_WORLD);
    }),
    {"'Boundary conditions/ring outside/Axes' = 'side'", "is not plane"});
}
