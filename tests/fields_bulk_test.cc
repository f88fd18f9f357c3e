// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/parameters/input_error.h>
#include <stickslip/simulation/lithostatic_stress.h>
#include <stickslip/simulation/simulation.h>

#include "stacked_bodies.h"
#include "stepping_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  MaterialFields
  make_material(const std::string &E,
                const std::string &nu   = "0.3",
                const std::string &rho  = "5e3",
                const std::string &eta  = "1e3",
                const std::string &zeta = "1e3")
  {
    MaterialFields material;
    material.youngs_modulus.set(E);
    material.poissons_ratio.set(nu);
    material.density.set(rho);
    material.shear_viscosity.set(eta);
    material.bulk_viscosity.set(zeta);
    return material;
  }



  template <int dim>
  MeshHierarchy<dim>
  make_brick(const unsigned int n_cells)
  {
    std::array<unsigned int, dim> cells;
    cells.fill(n_cells);
    return MeshHierarchy<dim>(stack<dim>({make_body<dim>(1., cells, 0)}),
                              MPI_COMM_WORLD);
  }



  double
  largest_difference(const BlockMatrix<2> &A, const BlockMatrix<2> &B)
  {
    double largest = 0, difference = 0;
    for (unsigned int i = 0; i < A.values().size(); ++i)
      {
        largest = std::max<double>(largest, std::abs(A.values()[i]));
        difference =
          std::max<double>(difference, std::abs(A.values()[i] - B.values()[i]));
      }
    return difference / largest;
  }



  /** u . A u for the interpolation of a function u. */
  template <int dim, typename Function>
  double
  twice_the_energy(const MeshLevel<dim>   &level,
                   const BlockMatrix<dim> &A,
                   const Function         &function)
  {
    const NodalVector u =
      interpolate(level, [&](const unsigned int, const Point<dim> &x) {
        return function(x);
      });
    NodalVector product = u;
    A.vmult(product, u);
    return u * product;
  }



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
                              scene.gravity);
    const InitialEquilibrium<2> equilibrium =
      solve_initial_equilibrium(problem);
    double at_top = 0, n_top = 0;
    for (const auto node :
         surface_nodes(meshes.finest(), 0, BodyMesh<2>::upper_side))
      {
        at_top += equilibrium.displacement.local_element(2 * node + 1);
        ++n_top;
      }
    return -at_top / n_top;
  }
} // namespace



TEST(BulkFields, ExpressionsOfConstantValueGiveTheMatricesOfNumbers)
{
  const MeshHierarchy<2> meshes = make_brick<2>(3);
  for (const VolumetricStrain strain :
       {VolumetricStrain::full, VolumetricStrain::cell_mean})
    {
      MaterialFields numbers = make_material("3e7", "0.2", "4e3", "2e3", "3e3");
      MaterialFields expressions = make_material(
        "3e7 + 0*x", "0.2 + 0*y", "4e3+0*x", "2e3+0*x", "3e3+0*x");
      numbers.volumetric_strain = expressions.volumetric_strain = strain;
      EXPECT_TRUE(numbers.are_constant());
      EXPECT_FALSE(expressions.are_constant());
      const auto one = assemble_elastic_matrices(meshes.finest(), {numbers});
      const auto two =
        assemble_elastic_matrices(meshes.finest(), {expressions});
      EXPECT_LT(largest_difference(one.mass, two.mass), 1e-15);
      EXPECT_LT(largest_difference(one.stiffness, two.stiffness), 1e-15);
      EXPECT_LT(largest_difference(one.damping, two.damping), 1e-15);

      NodalVector load = assemble_gravity(meshes.finest(), {expressions}, 9.81);
      load -= assemble_gravity(meshes.finest(), {numbers}, 9.81);
      EXPECT_LT(load.linfty_norm(), 1e-11);
    }
}



namespace
{
  /**
   * Parameters that are linear in x and y on the unit brick, whose energies of
   * simple motions are known. With two Gauss points per axis they are exact.
   */
  template <int dim>
  void
  expect_exact_energies()
  {
    const MeshHierarchy<dim> meshes = make_brick<dim>(3);
    const MeshLevel<dim>    &level  = meshes.finest();
    const BodyGeometry<dim>  body = stack<dim>({make_body<dim>(1., {}, 0)})[0];
    const Point<dim> centre = 0.5 * (body.lower_corner() + body.upper_corner());
    double           volume = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      volume *= body.upper_corner()[d] - body.lower_corner()[d];

    MaterialFields material = make_material("2e7*(20 + x + 2*y)",
                                            "0",
                                            "1e3*(30 + x - y)",
                                            "1e3*(40 - x + y)",
                                            "1e3*(50 + 2*x - y)");
    const double   E        = 2e7 * (20. + centre[0] + 2. * centre[1]);
    const double   rho      = 1e3 * (30. + centre[0] - centre[1]);
    const double   eta      = 1e3 * (40. - centre[0] + centre[1]);
    const double   zeta     = 1e3 * (50. + 2. * centre[0] - centre[1]);
    for (const VolumetricStrain strain :
         {VolumetricStrain::full, VolumetricStrain::cell_mean})
      {
        material.volumetric_strain = strain;
        const auto matrices = assemble_elastic_matrices(level, {material});
        const auto shift    = [](const Point<dim> &) {
          Tensor<1, dim> u;
          u[0] = 1.;
          return u;
        };
        EXPECT_NEAR(twice_the_energy(level, matrices.mass, shift),
                    rho * volume,
                    1e-11 * rho * volume);

        // Shear by an angle of one: mu and eta times its square.
        const auto shear = [](const Point<dim> &x) {
          Tensor<1, dim> u;
          u[0] = x[dim - 1];
          return u;
        };
        EXPECT_NEAR(twice_the_energy(level, matrices.stiffness, shear),
                    E / 2. * volume,
                    1e-11 * E * volume);
        EXPECT_NEAR(twice_the_energy(level, matrices.damping, shear),
                    eta * volume,
                    1e-11 * eta * volume);

        // Stretching along x: E, since nu = 0; 4/3 eta + zeta.
        const auto stretch = [](const Point<dim> &x) {
          Tensor<1, dim> u;
          u[0] = x[0];
          return u;
        };
        EXPECT_NEAR(twice_the_energy(level, matrices.stiffness, stretch),
                    E * volume,
                    1e-11 * E * volume);
        EXPECT_NEAR(twice_the_energy(level, matrices.damping, stretch),
                    (4. / 3. * eta + zeta) * volume,
                    1e-11 * (eta + zeta) * volume);

        NodalVector load   = assemble_gravity(level, {material}, 9.81);
        double      weight = 0;
        for (unsigned int i = 0; i < level.nodes.n_owned(); ++i)
          weight -= load.local_element(i * dim + dim - 1);
        EXPECT_NEAR(weight, 9.81 * rho * volume, 1e-10 * weight);
      }
  }
} // namespace



TEST(BulkFields, EnergiesOfLinearParametersAreExact)
{
  expect_exact_energies<2>();
  expect_exact_energies<3>();
}



TEST(BulkFields, ColumnOfLayersIsShortenedExactly)
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



TEST(BulkFields, ColumnOfSmoothStiffnessConvergesWithSecondOrder)
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
  EXPECT_LT(last, 1e-3);
}



TEST(BulkFields, TheSofterSideIsTheSlaveWhereStiffnessVaries)
{
  // The lower body is soft on the whole, but not next to the fault.
  const auto slave_is_upper = [](const std::string &E) {
    return SteppingScene(creeping_bodies,
                         {"Bodies/lower/Material/Young modulus=" + E})
      .problem.jump_basis()
      .faults()[0]
      .sides.slave_is_upper();
  };
  EXPECT_TRUE(slave_is_upper("if(y > -0.1, 4e8, 1e6)"));
  EXPECT_FALSE(slave_is_upper("if(y > -0.1, 4e6, 1e9)"));
}



TEST(BulkFields, LithostaticStressIsTheIntegralOfTheDensityAbove)
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



TEST(BulkFields, ValuesOutOfRangeAreFoundAtPointsOfTheMesh)
{
  // Corners and centre are fine.
  const SceneParameters<2> scene =
    read_scene(creeping_bodies,
               {"Bodies/upper/Material/Young modulus="
                "if(abs(x - 0.4) < 0.1, -1, 1e7)"});
  try
    {
      Simulation<2> simulation(scene, MPI_COMM_WORLD);
      ADD_FAILURE() << "no error";
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      for (const std::string part :
           {"'Bodies/upper/Material/Young modulus' = 'if(",
            "is -1 at (0.",
            ") m, but must be a number > 0 everywhere."})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
}



TEST(BulkFields, RunsOfNumbersAndOfTheSameExpressionsAgree)
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
