// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/simulation/lithostatic_stress.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>

#include "error_message.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

TEST(BodyFields, TheSofterSideIsTheSlaveWhereStiffnessVaries)
{
  // The lower body is soft on the whole, but not next to the fault.
  const auto slave_is_second = [](const std::string &E) {
    return SteppingScene(creeping_bodies,
                         {"Bodies/lower/Material/Young modulus=" + E})
      .problem.jump_basis()
      .faults()[0]
      .sides.slave_is_second();
  };
  EXPECT_TRUE(slave_is_second("if(y > -0.1, 4e8, 1e6)"));
  EXPECT_FALSE(slave_is_second("if(y > -0.1, 4e6, 1e9)"));
}



TEST(BodyFields, LithostaticStressIsTheIntegralOfTheDensityAbove)
{
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Gravity/Acceleration=10",
                "Bodies/upper/Material/Density=1e3*(2 + x) + 4e3*y"});
  const std::vector<double> stress =
    lithostatic_stress(scene, 0, {Point<2>(-1., 0.), Point<2>(0.5, 0.)});
  // The upper body reaches from 0 to 0.5.
  EXPECT_NEAR(stress[0], 10. * (1e3 * 0.5 + 2e3 * 0.25), 1e-8);
  EXPECT_NEAR(stress[1], 10. * (2.5e3 * 0.5 + 2e3 * 0.25), 1e-8);

  const SceneParameters<2> constant =
    read_scene(creeping_bodies, {"Gravity/Acceleration=10"});
  EXPECT_EQ(lithostatic_stress(constant, 0, {Point<2>(0.3, 0.)})[0],
            5e3 * 10. * 0.5);
}



TEST(BodyFields, LithostaticStressIsThatOfTheBodyAboveThePoint)
{
  // Two bodies side by side on the lower one, listed before it.
  const std::vector<std::string> g          = {"Gravity/Acceleration=10"};
  const SceneParameters<2>       stack      = read_scene(creeping_bodies, g);
  SceneParameters<2>             scene      = stack;
  scene.bodies                              = {read_scene(creeping_bodies,
                             {g[0], "Bodies/upper/Material/Density=2e3"})
                                                 .bodies[1],
                                               stack.bodies[1],
                                               stack.bodies[0]};
  scene.bodies[0].geometry.lateral_lower[0] = 0.2;
  scene.bodies[1].geometry.lateral_upper[0] = 0.2;
  scene.topology                            = FaultTopology(
    {"right", "left", "lower"},
    {{"fault",
                                 {{{{2, BodyMesh<2>::upper_side}},
                                   {{0, BodyMesh<2>::lower_side}, {1, BodyMesh<2>::lower_side}}}}}});
  const std::vector<double> stress =
    lithostatic_stress(scene, 0, {Point<2>(-0.5, 0.), Point<2>(0.7, 0.)});
  EXPECT_EQ(stress[0], 5e3 * 10. * 0.5);
  EXPECT_EQ(stress[1], 2e3 * 10. * 0.5);
}



TEST(BodyFields, LithostaticStressFollowsSlopeAndDip)
{
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Gravity/Acceleration=10",
                "Gravity/Dip=30",
                "Bodies/upper/Upper slope=0.2",
                "Bodies/upper/Material/Density=1e3*(2 + x) + 4e3*y"});
  const std::vector<double> stress = lithostatic_stress(
    scene, 0, {Point<2>(-1., 0.), Point<2>(0.5, 0.), Point<2>(7., 0.)});
  const auto exact = [](const double x) {
    const double h = 0.5 + 0.2 * (x + 1.);
    return 10. * std::sqrt(0.75) * (1e3 * (2. + x) * h + 2e3 * h * h);
  };
  EXPECT_NEAR(stress[0], exact(-1.), 1e-8);
  EXPECT_NEAR(stress[1], exact(0.5), 1e-8);
  // Beyond the body it is that of its side.
  EXPECT_NEAR(stress[2], exact(1.), 1e-8);
}



namespace
{
  /** The laws of a scene's nodes and their positions. */
  struct Laws
  {
    NodeLaws              laws;
    std::vector<Point<2>> points;

    explicit Laws(const std::vector<std::string> &overrides)
    {
      const SteppingScene scene(creeping_bodies, overrides);
      laws   = scene.laws;
      points = scene.problem.jump_basis().faults()[0].slave.points;
    }

    double
    radiation_damping(const unsigned int k) const
    {
      return laws.laws[laws.of_node[k]].radiation_damping;
    }
  };
} // namespace



TEST(BodyFields, RadiationDampingIsThatOfBothSidesAtEachNode)
{
  // With nu = 0.25 the shear modulus is 0.4 E.
  std::vector<std::string> scene = {
    "Time/Inertia=quasi-dynamic",
    "Bodies/lower/Material/Poisson ratio=0.25",
    "Bodies/upper/Material/Poisson ratio=0.25",
    "Bodies/lower/Material/Young modulus=1e7*(2 + x)",
    "Bodies/lower/Material/Density=2e3*exp(x)",
    "Bodies/upper/Material/Young modulus=if(x < 0.1, 1e7, 3e7)"};
  const auto lower = [](const double x) {
    return std::sqrt(0.4e7 * (2. + x) * 2e3 * std::exp(x));
  };
  const auto upper = [](const double x) {
    return std::sqrt(0.4 * (x < 0.1 ? 1e7 : 3e7) * 5e3);
  };
  const Laws both(scene);
  for (unsigned int k = 0; k < both.points.size(); ++k)
    {
      const double x = both.points[k][0];
      EXPECT_NEAR(both.radiation_damping(k),
                  1. / (1. / lower(x) + 1. / upper(x)),
                  1e-9 * upper(x));
    }
  EXPECT_EQ(both.laws.laws.size(), both.points.size());

  // A rigid body takes no waves, and its material is nobody's business.
  scene.push_back("Bodies/lower/Rigid=true");
  scene.push_back("Bodies/lower/Material/Density=if(abs(x - 0.4)<0.2, -1, 1)");
  const Laws founded(scene);
  for (unsigned int k = 0; k < founded.points.size(); ++k)
    EXPECT_NEAR(founded.radiation_damping(k),
                upper(founded.points[k][0]),
                1e-9 * upper(0.));
  EXPECT_EQ(founded.laws.laws.size(), 2u);

  // There is none with inertia.
  EXPECT_EQ(Laws({"Bodies/lower/Material/Young modulus=1e7*(2 + x)"})
              .radiation_damping(0),
            0.);
}



TEST(BodyFields, ValuesOutOfRangeAreFoundAtPointsOfTheMesh)
{
  // Corners and centre are fine.
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Bodies/upper/Material/Young modulus="
                "if(abs(x - 0.4) < 0.1, -1, 1e7)"});
  const std::string message =
    message_of([&]() { Simulation<2> simulation(scene, MPI_COMM_WORLD); });
  expect_one_sentence_with(
    message,
    {"'Bodies/upper/Material/Young modulus' = 'if(",
     "is -1 at (0.",
     ") m, but must be a number > 0 (in Pa) everywhere."});
}



TEST(BodyFields, MistakesAreFoundBeforeTheMeshes)
{
  const TemporaryFolder folder;
  const std::string in_depth = folder.write("depth.txt", "z\n0 1e7\n1 2e7\n");
  const std::string falling =
    folder.write("falling.txt", "y\n0 3e3\n0.5 -1e3\n");
  const auto expect_error = [&](const std::string              &entry,
                                const std::string              &value,
                                const std::vector<std::string> &parts) {
    const std::string path = "Bodies/upper/Material/" + entry;
    const std::string message =
      message_of([&]() { read_scene(creeping_bodies, {path + "=" + value}); });
    expect_one_sentence_with(message, {"'" + path + "' = '" + value + "'"});
    expect_one_sentence_with(message, parts);
  };
  expect_error("Young modulus",
               "-1e7",
               {"must be a number > 0 (in Pa), an expr"});
  expect_error("Young modulus",
               "1e7*x",
               {"is -1e+07 at (-1, 0) m, but must be a number > 0"});
  expect_error("Young modulus", "1e7*q", {"cannot be used: ", "\"q\""});
  expect_error("Young modulus",
               "table " + in_depth,
               {"the table depends on z, but in two dimensions"});
  expect_error("Young modulus", "table nowhere.txt", {"cannot be "});
  expect_error("Poisson ratio", "0.5", {"must be a number > -1 and < 0.5"});
  expect_error("Poisson ratio",
               "0.5 + 0*x",
               {"is 0.5 at (-1, 0) m, but must be a number > -1 and < 0.5"});
  expect_error("Density", "0", {"must be a number > 0"});
  expect_error("Density",
               "table " + falling,
               {"is -1000 at (-1, 0.5) m, but must be a number > 0"});
  expect_error("Density", "0/0 + x", {"at (-1, 0) m, but must be a number"});
  expect_error("Shear viscosity", "y - 0.1", {"is -0.1 at (-1, 0) m"});
  expect_error("Bulk viscosity", "0.1 - y", {"is -0.4 at (-1, 0.5) m"});

  // A wedge is tried at its own corners: the thick end reaches to y = 0.9.
  EXPECT_NE(message_of([]() {
              read_scene(creeping_bodies,
                         {"Bodies/upper/Upper slope=0.2",
                          "Bodies/upper/Material/Density=0.8 - y"});
            }).find("at (1, 0.9) m"),
            std::string::npos);
}



namespace
{
  /** The names of the cells' values in the first volume file of a run. */
  std::set<std::string>
  names_of_cell_data(const std::vector<std::string> &overrides)
  {
    const TemporaryFolder    folder;
    std::vector<std::string> all = overrides;
    all.push_back("Output/Output directory=" + folder.file("output"));
    all.push_back("Time/End time=1e-3");
    Simulation<2>(read_scene(creeping_bodies, all), MPI_COMM_WORLD).run();

    std::ifstream         file(folder.file("output/solution_00000.vtu"));
    const std::string     text{std::istreambuf_iterator<char>(file), {}};
    const std::regex      name("Name=\"([a-z_]+)\"");
    std::set<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), name), end;
         match != end;
         ++match)
      names.insert((*match)[1]);
    return names;
  }
} // namespace



TEST(BodyFields, VolumeOutputHasWhatVaries)
{
  const std::set<std::string> numbers = names_of_cell_data({});
  EXPECT_EQ(numbers.count("stress_xy"), 1u);
  std::set<std::string> expected = numbers;
  expected.insert("density");
  expected.insert("bulk_viscosity");
  EXPECT_EQ(names_of_cell_data({"Bodies/upper/Material/Density=5e3 + x",
                                "Bodies/lower/Material/Bulk viscosity="
                                "1e3*(2 + x)"}),
            expected);
  EXPECT_EQ(expected.size(), numbers.size() + 2);
}



TEST(BodyFields, RunsOfNumbersAndOfTheSameExpressionsAgree)
{
  const auto end_of_run = [](const std::vector<std::string> &overrides) {
    SteppingScene scene(creeping_bodies, overrides);
    scene.advance_until(0.3);
    return scene.state;
  };
  const SystemState<2> one = end_of_run({});
  const SystemState<2> two =
    end_of_run({"Bodies/lower/Material/Young modulus=4.12e7 + 0*x",
                "Bodies/upper/Material/Shear viscosity=2e5 + 0*y"});
  EXPECT_NEAR(one.time, two.time, 1e-12);
  for (unsigned int k = 0; k < one.alpha.size(); ++k)
    {
      EXPECT_NEAR(one.slip_rate[k][0],
                  two.slip_rate[k][0],
                  1e-9 * one.slip_rate[k].norm());
      EXPECT_NEAR(one.alpha[k], two.alpha[k], 1e-9);
    }
  // With other values it is another run.
  const SystemState<2> three =
    end_of_run({"Bodies/lower/Material/Young modulus=4.12e7*(1 + 0.5*x)"});
  EXPECT_GT(std::abs(three.slip_rate[3][0] - one.slip_rate[3][0]),
            1e-4 * one.slip_rate[3].norm());
}
