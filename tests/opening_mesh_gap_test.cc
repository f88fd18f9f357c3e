// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "mesh_text.h"
#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Height of the lower side of the upper body over the lower body, which is
   * flat: gap + curvature x^2. */
  struct Gap
  {
    double least, curvature;

    double
    operator()(const double x) const
    {
      return least + curvature * x * x;
    }
  };



  /** Two bodies of 2 m x 1 m, one above the other, of n cells along x. */
  MeshText
  bodies_apart(const Gap &gap, const unsigned int n)
  {
    MeshText mesh;
    mesh.groups = {{2, 1, "lower"},
                   {2, 2, "upper"},
                   {1, 3, "base"},
                   {1, 4, "lower_side"},
                   {1, 5, "upper_side"},
                   {1, 6, "rest"}};
    for (const int body : {1, 2})
      {
        // Meshes of the bodies do not match.
        const int  columns = body == 1 ? n : n + 1, rows = 4;
        const int  first = mesh.nodes.size() + 1;
        const auto node  = [&](const int i, const int j) {
          return first + i + j * (columns + 1);
        };
        for (int j = 0; j <= rows; ++j)
          for (int i = 0; i <= columns; ++i)
            {
              const double x     = -1. + 2. * i / columns;
              const double lower = body == 1 ? -1. : gap(x);
              const double upper = body == 1 ? 0. : 1.;
              mesh.nodes.push_back(
                {{x, lower + (upper - lower) * j / rows, 0.}});
            }
        for (int j = 0; j < rows; ++j)
          for (int i = 0; i < columns; ++i)
            mesh.elements.push_back({3,
                                     body,
                                     {node(i, j),
                                      node(i + 1, j),
                                      node(i + 1, j + 1),
                                      node(i, j + 1)}});
        for (int i = 0; i < columns; ++i)
          {
            mesh.elements.push_back(
              {1, body == 1 ? 3 : 5, {node(i, 0), node(i + 1, 0)}});
            mesh.elements.push_back(
              {1, body == 1 ? 4 : 6, {node(i, rows), node(i + 1, rows)}});
          }
        for (int j = 0; j < rows; ++j)
          for (const int i : {0, columns})
            mesh.elements.push_back({1, 6, {node(i, j), node(i, j + 1)}});
      }
    return mesh;
  }



  SceneParameters<2>
  scene_apart(const Gap                      &gap,
              const unsigned int              n,
              const std::vector<std::string> &more = {})
  {
    const TemporaryFolder folder;
    folder.write("two.msh", bodies_apart(gap, n).text());
    std::vector<std::string> overrides = {
      "Faults/contact/Initial gap from mesh=true"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return SceneReader(folder.write("scene.prm", R"(
subsection Bodies
  set Names     = lower, upper
  set Mesh file = two.msh
end
subsection Faults
  set Names = contact
  subsection contact
    set Between = lower lower_side, upper upper_side
    set Contact = unilateral
  end
end
subsection Boundary conditions
  set Sides = lower base
  subsection lower base
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Gravity
  set Acceleration = 9.81
end
subsection Time
  set End time = 1
end
subsection Output
  set Event start slip rate = 1
end
)"),
                       overrides)
      .read<2>();
  }



  /** The largest error of initial gaps at nodes that are not at the ends. */
  double
  error_of_gaps(const Gap &gap, const unsigned int n)
  {
    OpeningScene<2> scene(scene_apart(gap, n));
    const auto &points = scene.problem.jump_basis().faults()[0].slave.points;
    double      error  = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      if (std::abs(points[k][0]) < 0.9)
        error =
          std::max(error, std::abs(scene.state.gap[k] - gap(points[k][0])));
    return error;
  }
} // namespace



TEST(OpeningMeshGap, IsTheDistanceOfTheSides)
{
  // Plane sides, however far apart they are.
  EXPECT_LE(error_of_gaps({0.01, 0.}, 8), 1e-15);
  // Along the normal, which is up to 0.036 rad off the vertical: that alone
  // is 1.3e-5 m.
  EXPECT_LE(error_of_gaps({0.02, 0.02}, 32), 3e-5);
}



TEST(OpeningMeshGap, ClosesUnderGravity)
{
  OpeningScene<2> scene(scene_apart({0.01, 0.}, 8));
  // From the moment at which the upper body is let go.
  unsigned int n_touching = 0;
  while (scene.state.time < 0.15)
    {
      const auto result = scene.advance(1e-3);
      ASSERT_TRUE(result.converged) << result.failure;
      // Free fall from rest takes 45 ms.
      const unsigned int n =
        std::count(scene.state.gap.begin(), scene.state.gap.end(), 0.);
      if (scene.state.time < 0.044)
        {
          EXPECT_EQ(n, 0u);
        }
      n_touching = std::max(n_touching, n);
    }
  EXPECT_EQ(n_touching, scene.state.gap.size());
}



TEST(OpeningMeshGap, IsRefusedWhereItMakesNoSense)
{
  EXPECT_EQ(message_of([]() {
              scene_apart({0.6, 0.1}, 8);
            }),
            "The side 'lower lower_side' of the fault 'contact' does not touch "
            "the other side.");
  EXPECT_EQ(
    message_of([]() {
      scene_apart({0.01, 0.}, 8, {"Faults/contact/Contact=bilateral"});
    }),
    "'Faults/contact/Initial gap from mesh' = 'true' (--set): needs 'Contact' "
    "= 'unilateral', since sides that always touch cannot be apart.");
  EXPECT_NE(message_of([]() {
              scene_apart({0.05, 0.},
                          8,
                          {"Faults/contact/Initial gap from mesh=false"});
            }),
            "no error");
}
