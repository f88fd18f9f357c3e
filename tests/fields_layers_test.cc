// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>

#include "stacked_bodies.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /**
   * The displacement of the top of a column of height 2 that stands on its
   * lower side, under its weight and a pressure of 1e4 Pa on top. With nu = 0
   * it becomes no wider, so that the problem is one-dimensional.
   */
  double
  shortening(const std::string &E,
             const std::string &rho,
             const unsigned int n_cells)
  {
    const std::string text = R"(
subsection Bodies
  set Names = column
  subsection column
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 2
    set Coarse cells         = 2, )" +
                             std::to_string(n_cells) + R"(
    set Refinement passes    = 0
    subsection Material
      set Young modulus = )" +
                             E +
                             R"(
      set Density       = )" +
                             rho +
                             R"(
      set Poisson ratio = 0
    end
  end
end
subsection Boundary conditions
  set Sides = column bottom, column top
  subsection column bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection column top
    set y condition = traction
    set y value     = -1e4
    set Ramp length = 0
  end
end
)";
    const SceneParameters<2> scene = read_scene(text);
    const MeshHierarchy<2>   meshes({scene.bodies[0].geometry}, MPI_COMM_WORLD);
    BoundaryValues<2> boundary(meshes, scene.boundary_conditions, {"column"});
    SpatialProblem<2> problem(meshes,
                              {scene.bodies[0].material},
                              boundary,
                              scene.gravity_vector());
    const InitialEquilibrium<2> equilibrium =
      solve_initial_equilibrium(problem);
    double              at_top = 0, n_top = 0;
    const MeshLevel<2> &level = meshes.finest();
    for (const auto dof :
         level.bodies[0]->dofs_on_side(BodyMesh<2>::upper_side))
      {
        at_top +=
          equilibrium.displacement.local_element(2 * level.node(0, dof) + 1);
        ++n_top;
      }
    return -at_top / n_top;
  }
} // namespace



TEST(LayeredFields, ColumnOfLayersIsShortenedExactly)
{
  // Layers of 0.5 m: E = 1e7, 4e7, 2e7, 1e8 Pa, rho = 1, 2, 3, 4 t/m^3.
  const std::string E =
    "if(y < 0.5, 1e7, if(y < 1, 4e7, if(y < 1.5, 2e7, 1e8)))";
  const std::string rho =
    "if(y < 0.5, 1e3, if(y < 1, 2e3, if(y < 1.5, 3e3, 4e3)))";
  const double moduli[] = {1e7, 4e7, 2e7, 1e8};
  double       exact = 0, above = 1e4;
  for (int layer = 3; layer >= 0; --layer)
    {
      const double weight = 1e3 * (layer + 1) * 9.81 * 0.5;
      exact += (above + weight / 2.) * 0.5 / moduli[layer];
      above += weight;
    }
  // Linear elements are exact at the nodes of a one-dimensional problem.
  EXPECT_NEAR(shortening(E, rho, 4), exact, 1e-9 * exact);
  EXPECT_NEAR(shortening(E, rho, 8), exact, 1e-9 * exact);
}



TEST(LayeredFields, ColumnOfSmoothStiffnessConvergesWithSecondOrder)
{
  const QIterated<1> quadrature(QGauss<1>(4), 50);
  double             exact = 0;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      // The weight above y of rho = 2e3 + 1e3 y is its integral up to 2.
      const double y     = 2. * quadrature.point(q)[0];
      const double above = 1e4 + 9.81 * (2e3 * (2. - y) + 5e2 * (4. - y * y));
      exact += above / (1e7 * std::exp(y)) * 2. * quadrature.weight(q);
    }
  double last = 0;
  for (const unsigned int n : {2, 4, 8, 16})
    {
      const double error =
        std::abs(shortening("1e7*exp(y)", "2e3 + 1e3*y", n) - exact) / exact;
      if (last > 0.)
        {
          EXPECT_GT(last / error, 3.5) << n;
          EXPECT_LT(last / error, 4.5) << n;
        }
      last = error;
    }
  EXPECT_LT(last, 2.5e-3);
}



TEST(LayeredFields, LayersAreShearedExactly)
{
  // Endless layers from 0 to 0.75 and to 2 m that differ in both moduli.
  const std::string text = R"(
subsection Bodies
  set Names = layers
  subsection layers
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 2
    set Coarse cells         = 2, 8
    set Refinement passes    = 0
    subsection Material
      set Young modulus = if(y < 0.75, 1e7, 6e7)
      set Poisson ratio = if(y < 0.75, 0.4, 0.1)
    end
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Boundary conditions
  set Periodic along x = true
  set Sides            = layers bottom, layers top
  subsection layers bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection layers top
    set x condition = traction
    set x value     = 2e4
    set Ramp length = 0
  end
end
)";
  for (const std::string strain : {"full", "patch mean"})
    {
      const SceneParameters<2> scene =
        read_scene(text,
                   {"Bodies/layers/Material/Volumetric strain=" + strain});
      const MeshHierarchy<2> meshes({scene.bodies[0].geometry}, MPI_COMM_WORLD);
      BoundaryValues<2> boundary(meshes, scene.boundary_conditions, {"layers"});
      SpatialProblem<2> problem(meshes,
                                {scene.bodies[0].material},
                                boundary,
                                scene.gravity_vector());
      const NodalVector u = solve_initial_equilibrium(problem).displacement;
      const double      G_below = 1e7 / 2.8, G_above = 6e7 / 2.2;
      const NodalVector exact = interpolate(
        meshes.finest(), [&](const unsigned int, const Point<2> &x) {
          return Tensor<1, 2>({2e4 * (std::min(x[1], 0.75) / G_below +
                                      std::max(x[1] - 0.75, 0.) / G_above),
                               0.});
        });
      for_each_node(meshes.finest(),
                    [&](const unsigned int,
                        const unsigned int,
                        const unsigned int node,
                        const Point<2>    &x,
                        const bool         is_image) {
                      if (is_image)
                        return;
                      for (unsigned int c = 0; c < 2; ++c)
                        EXPECT_NEAR(u.local_element(2 * node + c),
                                    exact.local_element(2 * node + c),
                                    1e-9 * exact.linfty_norm())
                          << x << ", component " << c;
                    });
    }
}
