// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>

#include <array>
#include <iostream>
#include <memory>
#include <string>

#include "linear_iterations.h"
#include "random_vectors.h"
#include "stuck_faults.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double ratios[] = {0.49, 0.499, 0.4999, 0.49999};

  Material
  material(const double poissons_ratio, const double bulk_viscosity = 1e3)
  {
    Material result;
    result.poissons_ratio    = poissons_ratio;
    result.bulk_viscosity    = bulk_viscosity;
    result.volumetric_strain = VolumetricStrain::patch_mean;
    return result;
  }



  /** Two bodies refined towards their fault, the lower one held, the upper one
   * as well where its top is given. */
  SpatialScene<2>
  make_scene(const std::vector<BodyGeometry<2>> &bodies,
             const Material                     &material,
             const bool                          top_is_held)
  {
    std::vector<BoundaryCondition<2>> conditions = {
      make_side<2>("0",
                   BodyMesh<2>::lower_side,
                   {{BoundaryType::fixed, BoundaryType::fixed}})};
    if (top_is_held)
      conditions.push_back(
        make_side<2>(std::to_string(bodies.size() - 1),
                     BodyMesh<2>::upper_side,
                     {{BoundaryType::fixed, BoundaryType::free}}));
    return SpatialScene<2>(stack<2>(bodies),
                           conditions,
                           std::vector<Material>(bodies.size(), material),
                           0.);
  }



  /** The first part of the nodes of the fault stuck. */
  NodeMask
  stick(LevelHierarchy<2> &hierarchy, const double part)
  {
    NodeMask    active = hierarchy.finest().fixed;
    const auto &nodes  = hierarchy.finest().nonsmooth_nodes;
    for (unsigned int k = 0; k < part * nodes.size(); ++k)
      active.mask(nodes[k], 0);
    linearise_without_friction(hierarchy, active);
    return active;
  }



  /** Steps of conjugate gradients for several operators and states of the
   * fault. */
  std::vector<unsigned int>
  steps(SpatialScene<2> &scene)
  {
    std::vector<unsigned int> result;
    LevelHierarchy<2>        &hierarchy = scene.problem.hierarchy();
    for (const std::vector<double> &coefficients :
         {std::vector<double>{0., 0., 1.},
          Newmark<2>().operator_coefficients(1e-2),
          Newmark<2>().operator_coefficients(1e-4)})
      {
        scene.problem.combine(coefficients);
        for (const double part : {1., 0.5, 0.})
          {
            const NodeMask active = stick(hierarchy, part);
            result.push_back(
              cg_iterations(hierarchy,
                            random_vector(hierarchy.finest(), active, 7)));
          }
      }
    return result;
  }



  void
  print(const std::string &name, const std::vector<unsigned int> &steps)
  {
    std::cout << name << ':';
    for (const unsigned int n : steps)
      std::cout << ' ' << n;
    std::cout << std::endl;
  }
} // namespace



TEST(TNNMGIncompressible, StiffVolumesFollowFromTheMaterial)
{
  const std::vector<BodyGeometry<2>> bodies   = {make_body<2>(1., {{10, 2}}, 3),
                                                 make_body<2>(1., {{10, 2}}, 3)};
  const auto                         is_found = [&](const Material &material) {
    SpatialScene<2> scene = make_scene(bodies, material, true);
    return !scene.problem.hierarchy().finest().stiff_volumes.empty();
  };
  for (const double nu : {0., 0.3, 0.4, 0.45})
    EXPECT_FALSE(is_found(material(nu))) << nu;
  for (const double nu : ratios)
    EXPECT_TRUE(is_found(material(nu))) << nu;
  // By their viscosity.
  EXPECT_TRUE(is_found(material(0.3, 1e6)));
  // No vortex is soft where each point resists.
  Material full          = material(0.4999);
  full.volumetric_strain = VolumetricStrain::full;
  EXPECT_FALSE(is_found(full));
}



TEST(TNNMGIncompressible, CyclesAreSymmetric)
{
  SpatialScene<2> scene =
    make_scene({make_body<2>(1., {{10, 2}}, 2), make_body<2>(1., {{7, 2}}, 2)},
               material(0.499),
               true);
  LevelHierarchy<2> &hierarchy = scene.problem.hierarchy();
  hierarchy.set_cycle_precision(CyclePrecision::double_precision);
  scene.problem.combine(Newmark<2>().operator_coefficients(1e-2));
  for (const unsigned int sweeps : {1, 2})
    {
      hierarchy.set_smoothing_sweeps(sweeps);
      expect_symmetric_cycle(hierarchy, stick(hierarchy, 0.5), 1e-12);
    }
}



TEST(TNNMGIncompressible, CoarseLevelsFollowTheTruncation)
{
  // Rows that are formed anew, and a hierarchy that forms all of them.
  const auto make = []() {
    std::unique_ptr<SpatialScene<2>> scene(new SpatialScene<2>(make_scene(
      {make_body<2>(1., {{10, 2}}, 3), make_body<2>(1., {{7, 2}}, 3)},
      material(0.499),
      true)));
    scene->problem.hierarchy().set_cycle_precision(
      CyclePrecision::double_precision);
    return scene;
  };
  const auto lasting = make();
  for (const double part : {0.5, 0., 1., 0.9})
    for (const double tau : {1e-2, 1e-4})
      {
        const auto fresh = make();
        for (SpatialScene<2> *scene : {lasting.get(), fresh.get()})
          {
            scene->problem.combine(Newmark<2>().operator_coefficients(tau));
            stick(scene->problem.hierarchy(), part);
          }
        LevelHierarchy<2> &hierarchy = lasting->problem.hierarchy();
        const NodalVector  b =
          random_vector(hierarchy.finest(), stick(hierarchy, part), 3);
        NodalVector x = b, y = b;
        hierarchy.v_cycle(x, b);
        fresh->problem.hierarchy().v_cycle(y, b);
        const double size = y.linfty_norm();
        x -= y;
        EXPECT_LE(x.linfty_norm(), 1e-8 * size) << part << ' ' << tau;
      }
}



TEST(TNNMGIncompressible, StepsBesideThoseOfOrdinaryBodies)
{
  // Meshes that match and that do not, graded towards the fault, cells of one
  // size, and cells three and ten times as tall as wide. The largest ratios of
  // steps for each Poisson's ratio.
  struct Case
  {
    std::vector<BodyGeometry<2>> bodies;
    std::array<double, 4>        largest;
  };
  const std::vector<Case> cases = {
    {{make_body<2>(1., {{10, 2}}, 4), make_body<2>(1., {{10, 2}}, 4)},
     {{1.1, 1.6, 2.4, 2.6}}},
    {{make_body<2>(1., {{10, 2}}, 4), make_body<2>(1., {{9, 2}}, 4)},
     {{1.1, 1.8, 3.5, 5.5}}},
    {halved<2>({make_body<2>(1., {{10, 2}}, 0), make_body<2>(1., {{10, 2}}, 0)},
               3),
     {{1.2, 1.5, 1.5, 1.7}}},
    {{make_body<2>(1., {{30, 2}}, 1), make_body<2>(1., {{30, 2}}, 1)},
     {{1.2, 1.7, 1.9, 2.}}},
    {{make_body<2>(1., {{100, 2}}, 1), make_body<2>(1., {{100, 2}}, 1)},
     {{5.5, 11., 14., 20.}}}};
  for (const Case &its_case : cases)
    {
      SpatialScene<2> ordinary =
        make_scene(its_case.bodies, material(0.3), true);
      const std::vector<unsigned int> fewest = steps(ordinary);
      print("nu = 0.3", fewest);
      for (unsigned int n = 0; n < its_case.largest.size(); ++n)
        {
          SpatialScene<2> scene =
            make_scene(its_case.bodies, material(ratios[n]), true);
          const std::vector<unsigned int> its_steps = steps(scene);
          print("nu = " + std::to_string(ratios[n]), its_steps);
          for (unsigned int k = 0; k < fewest.size(); ++k)
            EXPECT_LE(its_steps[k], its_case.largest[n] * fewest[k])
              << ratios[n] << ' ' << k;
        }
    }
}



TEST(TNNMGIncompressible, BulkViscosityCountsAsWell)
{
  const std::vector<BodyGeometry<2>> bodies = {make_body<2>(1., {{10, 2}}, 4),
                                               make_body<2>(1., {{10, 2}}, 4)};
  SpatialScene<2> ordinary = make_scene(bodies, material(0.3), true);
  const std::vector<unsigned int> fewest = steps(ordinary);
  for (const double bulk_viscosity : {1e5, 1e6})
    {
      SpatialScene<2> scene =
        make_scene(bodies, material(0.3, bulk_viscosity), true);
      const std::vector<unsigned int> its_steps = steps(scene);
      print("zeta = " + std::to_string(bulk_viscosity), its_steps);
      for (unsigned int k = 0; k < fewest.size(); ++k)
        EXPECT_LE(its_steps[k], 3 * fewest[k]) << bulk_viscosity << ' ' << k;
    }
}
