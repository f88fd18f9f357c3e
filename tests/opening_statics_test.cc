// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "contact_closed_forms.h"
#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** An elastic body on a rigid one, without mass and friction, of whose
   * width the mesh is one half. */
  const char *const pressed_body = R"(
subsection Bodies
  set Names          = wall, body
  set Base elevation = -1
  subsection wall
    set Lower lateral corner = -10
    set Upper lateral corner = 10
    set Thickness            = 1
    set Rigid                = true
  end
  subsection body
    set Lower lateral corner = 0
    set Upper lateral corner = 2
    set Thickness            = 2
    set Coarse cells         = 5, 5
    subsection Material
      set Young modulus   = 1e7
      set Poisson ratio   = 0.3
      set Density         = 1000
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Friction = frictionless
    set Contact  = unilateral
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 10
  set Inertia = quasi-static
end
subsection TNNMG
  set Tolerance = 1e-10
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** The nodes of the contact from left to right: place, m, weight, m,
   * pressure, Pa, gap, m, and the load of this half and the other, N/m. */
  struct Profile
  {
    std::vector<double> x, weight, pressure, gap;
    double              load = 0.;

    explicit Profile(const OpeningScene<2> &scene)
    {
      std::map<double, unsigned int> order;
      const auto                    &points =
        scene.problem.jump_basis().faults().front().slave.points;
      for (unsigned int k = 0; k < points.size(); ++k)
        if (scene.faults.in_contact(k))
          order[points[k][0]] = k;
      for (const auto &[place, k] : order)
        {
          x.push_back(place);
          weight.push_back(scene.faults.weights()[k]);
          pressure.push_back(scene.state.contact_pressure[k]);
          gap.push_back(scene.state.gap[k]);
          load += 2. * weight.back() * pressure.back();
        }
    }
  };



  /** Entries for the body with its top moved at that velocity, m/s, its left
   * side the plane of symmetry, and cells of 1/16 of 0.1 m everywhere: cells
   * that become larger at once from the contact on make it too stiff. */
  std::vector<std::string>
  half_body(const double velocity, const std::vector<std::string> &others)
  {
    const std::string        side = "Boundary conditions/body ";
    std::vector<std::string> all  = {
       "Bodies/body/Upper lateral corner=" + std::string("1"),
       "Bodies/body/Thickness=" + std::string("1"),
       "Bodies/body/Uniform refinements=" + std::string("5"),
       "Bodies/body/Refinement passes=" + std::string("0"),
       "Boundary conditions/Sides=body left, body top",
       side + "left/x condition=fixed",
       side + "top/x condition=fixed",
       side + "top/y condition=velocity",
       side + "top/Ramp length=0",
       side + "top/y value=" + std::to_string(velocity)};
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }



  void
  advance_by(OpeningScene<2> &scene, const unsigned int n, const double tau)
  {
    for (unsigned int i = 0; i < n; ++i)
      {
        const StepResult<2> step = scene.advance(tau);
        ASSERT_TRUE(step.converged) << step.failure;
        for (unsigned int k = 0; k < scene.faults.size(); ++k)
          EXPECT_TRUE(scene.state.gap[k] == 0. ||
                      scene.state.contact_pressure[k] == 0.);
      }
  }
} // namespace



TEST(OpeningStatics, ACylinderIsPressedOnAPlane)
{
  // Half width 0.1 m, a tenth of the body, and 1/16 of it a cell.
  const double    radius = 1.;
  OpeningScene<2> scene(pressed_body,
                        half_body(-0.0045,
                                  {"Faults/contact/Initial gap=0.5 * x^2"}));
  advance_by(scene, 4, 1.);
  const Profile   profile(scene);
  const double    modulus = contact_modulus(1e7, 0.3, 1e300, 0.);
  const HertzLine hertz   = {profile.load, radius, modulus};
  const double    a       = hertz.half_width();
  double          second = 0., error = 0., largest = 0.;
  for (unsigned int i = 0; i < profile.x.size(); ++i)
    {
      second +=
        profile.weight[i] * profile.pressure[i] * profile.x[i] * profile.x[i];
      largest = std::max(largest, profile.pressure[i]);
      if (std::abs(profile.x[i]) < 0.9 * a)
        error = std::max(error,
                         std::abs(profile.pressure[i] -
                                  hertz.pressure(profile.x[i])));
    }
  const double width = 2. * std::sqrt(2. * second / profile.load);
  EXPECT_NEAR(a, 0.1, 0.02);
  EXPECT_NEAR(width, a, 0.005 * a);
  EXPECT_NEAR(largest, hertz.pressure(0.), 0.003 * hertz.pressure(0.));
  EXPECT_LE(error, 0.02 * hertz.pressure(0.));
}



TEST(OpeningStatics, AFlatPunch)
{
  const double    a = 0.1;
  OpeningScene<2> scene(pressed_body,
                        half_body(-0.005,
                                  {"Bodies/wall/Lower lateral corner=-0.1",
                                   "Bodies/wall/Upper lateral corner=0.1"}));
  advance_by(scene, 2, 1.);
  const Profile profile(scene);
  double        error = 0.;
  for (unsigned int i = 0; i < profile.x.size(); ++i)
    if (profile.x[i] < 0.5 * a)
      error =
        std::max(error,
                 std::abs(profile.pressure[i] /
                            flat_punch_pressure(profile.load, a, profile.x[i]) -
                          1.));
  EXPECT_GT(profile.load, 0.);
  // The place between two nodes where the edge is felt is unknown by a fifth
  // of a cell.
  EXPECT_LE(error, 0.015);
}



namespace
{
  /** A heavy beam of 4 m by 0.1 m whose right end is lifted. */
  std::vector<std::string>
  lifted_beam(std::vector<std::string> overrides)
  {
    for (const char *entry :
         {"Bodies/body/Lower lateral corner=0",
          "Bodies/body/Upper lateral corner=4",
          "Bodies/body/Thickness=0.1",
          "Bodies/body/Coarse cells=40, 1",
          "Bodies/body/Uniform refinements=2",
          "Bodies/body/Refinement passes=0",
          "Bodies/body/Material/Young modulus=1e9",
          "Bodies/body/Material/Poisson ratio=0",
          "Boundary conditions/Sides=body left, body right",
          "Boundary conditions/body left/x condition=fixed",
          "Boundary conditions/body right/y condition=velocity",
          "Boundary conditions/body right/Ramp length=0",
          "Gravity/Acceleration=9.81"})
      overrides.push_back(entry);
    return overrides;
  }
} // namespace



TEST(OpeningStatics, ABeamIsLiftedAtItsEnd)
{
  OpeningScene<2> scene(
    pressed_body, lifted_beam({"Boundary conditions/body right/y value=2e-3"}));
  advance_by(scene, 4, 1.);
  const double     thickness = 0.1;
  const LiftedBeam beam      = {1e9 * std::pow(thickness, 3) / 12.,
                                1000. * 9.81 * thickness,
                                scene.state.displacement.linfty_norm()};
  const Profile    profile(scene);
  unsigned int     last = 0;
  while (profile.gap[last] == 0.)
    ++last;
  // A thick beam bends before it comes off.
  const double touches = 4. - beam.length();
  EXPECT_NEAR(profile.x[last], touches, thickness);
  double error = 0.;
  for (unsigned int i = last; i < profile.x.size(); ++i)
    {
      EXPECT_GT(profile.gap[i], 0.);
      error =
        std::max(error,
                 std::abs(profile.gap[i] - beam.gap(profile.x[i] - touches)));
    }
  EXPECT_LE(error, 0.02 * beam.lift);
  EXPECT_NEAR(profile.load / 2.,
              4. * beam.weight - beam.force(),
              0.01 * beam.weight);
}
