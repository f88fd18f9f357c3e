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



namespace
{
  /** A ring of radii 1 and 2 m around a disc, from which friction keeps it from
   * slipping, after a short time without inertia. */
  std::string
  ring_scene(const std::string &conditions)
  {
    return R"(
subsection Bodies
  set Names     = disc, ring
  set Mesh file = ring.msh
  subsection disc
    set Uniform refinements = 1
    subsection Material
      set Young modulus = 1e9
      set Poisson ratio = 0.25
    end
  end
  subsection ring
    set Uniform refinements = 1
    subsection Material
      set Young modulus = 1e9
      set Poisson ratio = 0.25
    end
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Shape                  = smooth
    set Normal stress          = function
    set Normal stress function = 1e8
    set Initial state          = 1e12
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia           = quasi-static
  set Step size control = constant
  set Largest step      = 1e-3
  set End time          = 1e-3
end
subsection Output
  set Event start slip rate = 1
end
)" + conditions;
  }



  /** Displacements of all nodes after a step, with their positions. */
  std::vector<std::pair<Point<2>, Tensor<1, 2>>>
  displacements_of_ring(const std::string &conditions)
  {
    const TemporaryFolder folder;
    std::filesystem::copy(STICKSLIP_SOURCE_DIR "/tests/meshes/ring.msh",
                          folder.file("ring.msh"));
    Simulation<2> simulation(
      SceneReader(folder.write("ring.prm", ring_scene(conditions))).read<2>(),
      MPI_COMM_WORLD);
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();
    std::vector<std::pair<Point<2>, Tensor<1, 2>>> result;
    const MeshLevel<2> &level = simulation.spatial_problem().meshes().finest();
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const std::vector<Point<2>> points = level.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            Tensor<1, 2> u;
            for (unsigned int d = 0; d < 2; ++d)
              u[d] = simulation.state().displacement.local_element(
                level.node(b, i) * 2 + d);
            result.emplace_back(points[i], u);
          }
      }
    return result;
  }
} // namespace



// A disc that is turned and pressed at its rim: along its axes as in space.
TEST(SideAxes, OfARingAreRadialAndAlongIt)
{
  const auto along_side = displacements_of_ring(R"(
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set Axes                 = side
    set normal condition     = velocity
    set normal value         = -1e-2
    set tangential condition = velocity
    set tangential value     = 2e-2
    set Ramp length          = 0
  end
end
)"),
             in_space   = displacements_of_ring(R"(
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set x condition = velocity
    set x value     = (-1e-2 * x + 2e-2 * y) / sqrt(x^2 + y^2)
    set y condition = velocity
    set y value     = (-1e-2 * y - 2e-2 * x) / sqrt(x^2 + y^2)
    set Ramp length = 0
  end
end
)");
  ASSERT_EQ(along_side.size(), in_space.size());
  double largest = 0., difference = 0.;
  for (unsigned int i = 0; i < in_space.size(); ++i)
    {
      largest    = std::max(largest, in_space[i].second.norm());
      difference = std::max(difference,
                            (along_side[i].second - in_space[i].second).norm());
    }
  std::cout << "difference " << difference / largest << '\n';
  EXPECT_GT(largest, 1e-5);
  EXPECT_LT(difference, 1e-9 * largest);
}



// A uniform state of pressure, which linear elements and polygons have exactly:
// u = -(1 + nu) (1 - 2 nu) / E p x.
TEST(SideAxes, OfARingUnderPressure)
{
  const double factor = -1.25 * 0.5 / 1e9 * 1e6;
  for (const auto &[x, u] : displacements_of_ring(R"(
subsection Boundary conditions
  set Sides = ring outside
  subsection ring outside
    set Axes                 = side
    set normal condition     = traction
    set normal value         = -1e6
    set tangential condition = fixed
    set Ramp length          = 0
  end
end
)"))
    EXPECT_LT((u - factor * x).norm(), 1e-9 * std::abs(2. * factor));
}



TEST(SideAxes, OfASideWithCornersAreRefused)
{
  const TemporaryFolder folder;
  std::filesystem::copy(STICKSLIP_SOURCE_DIR "/tests/meshes/cross.msh",
                        folder.file("cross.msh"));
  const std::string text = R"(
subsection Bodies
  set Names     = south, north
  set Mesh file = cross.msh
end
subsection Faults
  set Names = level, upright
end
subsection Boundary conditions
  set Sides = south outside
  subsection south outside
    set Axes                 = side
    set normal condition     = fixed
    set tangential condition = free
  end
end
subsection Output
  set Event start slip rate = 1
end
)";
  expect_one_sentence_with(
    message_of([&]() {
      Simulation<2>(SceneReader(folder.write("cross.prm", text)).read<2>(),
                    MPI_COMM_WORLD);
    }),
    {"'Boundary conditions/south outside/Axes' = 'side'", "has a corner at ("});
}
