// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/scene_declaration.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/scene/scene_writer.h>

#include <cmath>
#include <sstream>

#include "project_directories.h"
#include "scene_text.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  template <int dim>
  std::string
  as_text(const SceneParameters<dim> &scene)
  {
    std::ostringstream text;
    write_parameters(scene, text);
    return text.str();
  }



  std::string
  source_file(const std::string &name)
  {
    return std::string(STICKSLIP_SOURCE_DIR "/") + name;
  }
} // namespace



TEST(SceneReader, SetsWhatTheFileSays)
{
  const TemporaryFolder folder;
  const SceneReader     reader(folder.write("small.prm", two_bodies));
  ASSERT_EQ(reader.dimension(), 2u);
  const SceneParameters<2> scene = reader.read<2>();

  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "lower");
  EXPECT_EQ(scene.bodies[0].geometry.coarse_cells[0], 16u);
  EXPECT_EQ(scene.bodies[0].geometry.coarse_cells[1], 1u);
  EXPECT_EQ(scene.bodies[0].material.youngs_modulus.constant(), 1e7);
  EXPECT_EQ(scene.bodies[1].material.youngs_modulus.constant(), 4.12e7);
  EXPECT_EQ(scene.bodies[0].geometry.lower_corner(), Point<2>(-2.5, -0.3));
  EXPECT_EQ(scene.bodies[1].geometry.lower_corner(), Point<2>(-1, 0));
  EXPECT_EQ(scene.bodies[1].geometry.upper_corner(), Point<2>(2.5, 1));

  ASSERT_EQ(scene.faults.size(), 1u);
  EXPECT_EQ(scene.faults[0].name, "main");
  EXPECT_EQ(scene.faults[0]["a"].constant(), 0.01);
  EXPECT_EQ(scene.faults[0]["b"].constant(), 0.02);
  EXPECT_EQ(scene.faults[0]["State law"].constant(), 1.);      // slip
  EXPECT_EQ(scene.faults[0]["Regularisation"].constant(), 1.); // arcsinh
  EXPECT_EQ(scene.faults[0]["Initial state"].text(), "3 + x^2");
  EXPECT_EQ(scene.faults[0].normal_stress_source, NormalStressSource::function);
  EXPECT_EQ(scene.faults[0].normal_stress.text(), "1e4 * (3 + x)");

  ASSERT_EQ(scene.boundary_conditions.size(), 2u);
  const BoundaryCondition<2> &top = scene.boundary_conditions[1];
  EXPECT_EQ(top.body, "upper");
  EXPECT_EQ(top.side, 3u);
  EXPECT_EQ(top.type[0], BoundaryType::velocity);
  EXPECT_EQ(top.type[1], BoundaryType::traction);
  EXPECT_EQ(top.expression[1], "-100");
  EXPECT_EQ(top.ramp_length, 0.1);

  EXPECT_EQ(scene.time.end_time, 7);
  EXPECT_EQ(scene.time.rate_state_method, RateStateMethod::nested);
  EXPECT_EQ(scene.output.directory, "output/small");
}



TEST(SceneReader, WrittenParametersGiveTheSameScene)
{
  const TemporaryFolder folder;
  SceneParameters<2>    scene =
    SceneReader(folder.write("small.prm", two_bodies)).read<2>();
  // Numbers that need all digits.
  scene.bodies[1].material.density          = 1e4 / 3;
  scene.faults[0]["a"]                      = 0.1 + 0.2;
  scene.time.tolerance                      = 1e-4 / 7;
  scene.bodies[0].geometry.lateral_lower[0] = -2.0 / 3;
  scene.tnnmg.max_iterations                = 77;
  scene.contact.follow_slip                 = false;
  scene.time.control                        = StepSizeControl::step_doubling;
  scene.time.state_update                   = StateUpdate::implicit_euler;

  write_parameters(scene, folder.file("again.prm"));
  const SceneParameters<2> again =
    SceneReader(folder.file("again.prm")).read<2>();
  EXPECT_EQ(as_text(again), as_text(scene));
  EXPECT_EQ(again.bodies[1].material.density.constant(), 1e4 / 3);
  EXPECT_EQ(again.faults[0]["a"].constant(), 0.1 + 0.2);
  EXPECT_EQ(again.time.tolerance, 1e-4 / 7);
  EXPECT_EQ(again.bodies[0].geometry.lateral_lower[0], -2.0 / 3);
  EXPECT_EQ(again.tnnmg.max_iterations, 77u);
  EXPECT_FALSE(again.contact.follow_slip);
  EXPECT_EQ(again.time.control, StepSizeControl::step_doubling);
  EXPECT_EQ(again.time.state_update, StateUpdate::implicit_euler);
  EXPECT_EQ(again.output.directory, "output/small");
}



TEST(SceneReader, ReadsThreeDimensionsAndSingleBodies)
{
  const TemporaryFolder folder;
  const SceneReader     reader(folder.write("block.prm", one_body_3d));
  ASSERT_EQ(reader.dimension(), 3u);
  const SceneParameters<3> scene = reader.read<3>();
  EXPECT_TRUE(scene.faults.empty());
  EXPECT_EQ(scene.boundary_conditions[0].side, 4u);
  EXPECT_EQ(scene.boundary_conditions[1].side, 2u);
  EXPECT_EQ(scene.boundary_conditions[1].expression[1], "1e-3 * z");
  EXPECT_EQ(scene.bodies[0].geometry.upper_corner(), Point<3>(1, 2, 1));

  write_parameters(scene, folder.file("again.prm"));
  EXPECT_EQ(as_text(SceneReader(folder.file("again.prm")).read<3>()),
            as_text(scene));
}



TEST(SceneReader, OverridesActAfterTheFile)
{
  const TemporaryFolder    folder;
  const std::string        file = folder.write("small.prm", two_bodies);
  const SceneParameters<2> scene =
    SceneReader(file,
                {"Time/End time=3",
                 "Time/End time = 4",
                 "Bodies/lower/Material/Young modulus=5e7",
                 "Faults/main/Initial state=if(x==0, 1, 2)",
                 "Output/Output directory=a=b"})
      .read<2>();
  EXPECT_EQ(scene.time.end_time, 4);
  EXPECT_EQ(scene.bodies[0].material.youngs_modulus.constant(), 5e7);
  EXPECT_EQ(scene.faults[0]["Initial state"].text(), "if(x==0, 1, 2)");
  EXPECT_EQ(scene.output.directory, "a=b");

  // Names too can be overridden, here with a scene of one body in the end.
  const SceneParameters<3> renamed =
    SceneReader(folder.write("block.prm", one_body_3d),
                {"Boundary conditions/Sides=block bottom, block front, "
                 "block top",
                 "Boundary conditions/block top/z condition=fixed"})
      .read<3>();
  EXPECT_EQ(renamed.boundary_conditions.size(), 3u);
  EXPECT_EQ(renamed.boundary_conditions[2].type[2], BoundaryType::fixed);
}



TEST(SceneReader, IncludedFilesAreFoundNextToTheFileAndMayBeOverridden)
{
  const TemporaryFolder folder;
  folder.write("small.prm", two_bodies);
  const SceneParameters<2> scene =
    SceneReader(folder.write("variant.prm",
                             "include small.prm\n"
                             "subsection Time\n"
                             "  set End time = 8\n"
                             "end\n"))
      .read<2>();
  EXPECT_EQ(scene.time.end_time, 8);
  EXPECT_EQ(scene.faults[0]["b"].constant(), 0.02);
  EXPECT_EQ(scene.output.directory, "output/variant");
}



TEST(SceneReader, TheSpringSliderIsThePublishedOne)
{
  const SceneParameters<2> scene =
    SceneReader(source_file("parameters/spring_slider.prm")).read<2>();
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].geometry.lower_corner(), Point<2>(-2.5, -1));
  EXPECT_EQ(scene.bodies[1].geometry.upper_corner(), Point<2>(2.5, 1));
  EXPECT_EQ(scene.bodies[1].geometry.refinement_passes, 4u);
  EXPECT_EQ(scene.faults[0]["Characteristic slip"].constant(), 2e-5);
  EXPECT_EQ(scene.time.end_time, 60);
  EXPECT_DOUBLE_EQ(event_start_slip_rate(scene), 4e-4);

  SceneParameters<2> printed =
    SceneReader(source_file("parameters/spring_slider_printed_L.prm"))
      .read<2>();
  EXPECT_EQ(printed.faults[0]["Characteristic slip"].constant(), 0.02);
  printed.faults[0]["Characteristic slip"] = 2e-5;
  printed.output.directory                 = scene.output.directory;
  EXPECT_EQ(as_text(printed), as_text(scene));
}



TEST(SceneReader, TheReferenceOfParametersIsUpToDate)
{
  std::ostringstream reference;
  print_parameter_reference(reference);
  EXPECT_EQ(content_of(source_file("doc/parameters.md")), reference.str());
}



TEST(LoadingRate, IsTheLargestPrescribedVelocity)
{
  const TemporaryFolder folder;
  SceneParameters<2>    scene =
    SceneReader(folder.write("small.prm", two_bodies)).read<2>();
  // 2e-4 (1 + sin(t) / 2) up to t = 7, seen at steps of 0.07 s.
  EXPECT_NEAR(largest_prescribed_velocity(scene), 3e-4, 1e-7);
  EXPECT_NEAR(event_start_slip_rate(scene), 6e-4, 2e-7);
  scene.output.event_start_slip_rate = 5e-5;
  EXPECT_EQ(event_start_slip_rate(scene), 5e-5);
}



TEST(Material, LameParametersGiveBackYoungsModulusAndPoissonsRatio)
{
  Material material;
  material.youngs_modulus = 3e7;
  material.poissons_ratio = 0.2;
  const double lambda = material.lame_lambda(), mu = material.shear_modulus();
  EXPECT_NEAR(mu * (3 * lambda + 2 * mu) / (lambda + mu), 3e7, 1e-7);
  EXPECT_NEAR(lambda / (2 * (lambda + mu)), 0.2, 1e-15);
}



TEST(SmoothRamp, GrowsFromZeroToOneWithLevelEnds)
{
  EXPECT_EQ(smooth_ramp(-1, 2), 0);
  EXPECT_EQ(smooth_ramp(0, 2), 0);
  EXPECT_NEAR(smooth_ramp(0.5, 2), 0.5 * (1 - std::sqrt(0.5)), 1e-15);
  EXPECT_NEAR(smooth_ramp(1, 2), 0.5, 1e-15);
  EXPECT_EQ(smooth_ramp(2, 2), 1);
  EXPECT_EQ(smooth_ramp(3, 2), 1);
  EXPECT_EQ(smooth_ramp(0, 0), 1);
}



TEST(NumberRange, KnowsBoundsThatAreExcluded)
{
  const NumberRange ratio = NumberRange().above(-1).below(0.5);
  for (const char *good : {"0", "0.4999", "-.5", "+1e-3"})
    EXPECT_TRUE(ratio.match(good)) << good;
  for (const char *bad :
       {"0.5", "-1", "nan", "inf", "0.3 x", "", "0x0", "1e-3e", "0.1, 0.2"})
    EXPECT_FALSE(ratio.match(bad)) << bad;
  EXPECT_EQ(ratio.description(), "a number > -1 and < 0.5");

  const NumberRange cells = NumberRange().whole().at_least(1).times(2);
  EXPECT_TRUE(cells.match("10, 2"));
  EXPECT_FALSE(cells.match("10, 0"));
  EXPECT_FALSE(cells.match("10, 2.5"));
  EXPECT_FALSE(cells.match("10"));
  EXPECT_EQ(cells.description(), "2 whole numbers >= 1, separated by commas");
  EXPECT_EQ(shortest_form(0.1), "0.1");
  EXPECT_EQ(std::stod(shortest_form(1. / 3)), 1. / 3);
}



TEST(SideName, FollowsTheBoundaryIndicators)
{
  EXPECT_EQ(brick_side_names<2>()[0], "left");
  EXPECT_EQ(brick_side_names<2>()[3], "top");
  EXPECT_EQ(brick_side_names<3>()[1], "right");
  EXPECT_EQ(brick_side_names<3>()[2], "front");
  EXPECT_EQ(brick_side_names<3>()[4], "bottom");
}
