// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>

#include "stacked_bodies.h"

using namespace StickSlip;

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
  largest_difference(const TermMatrix<2> &A, const TermMatrix<2> &B)
  {
    double               largest = 0, difference = 0;
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < A.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          largest    = std::max<double>(largest, A.entry(i, k).norm());
          difference = std::max<double>(difference,
                                        (A.entry(i, k) - B.entry(i, k)).norm());
        }
    return difference / largest;
  }



  /** u . A u for the interpolation of a function u. */
  template <int dim, typename Function>
  double
  twice_the_energy(const MeshLevel<dim>  &level,
                   const TermMatrix<dim> &A,
                   const Function        &function)
  {
    const NodalVector u =
      interpolate(level, [&](const unsigned int, const Point<dim> &x) {
        return function(x);
      });
    NodalVector product = u;
    A.vmult(product, u);
    return u * product;
  }
} // namespace



TEST(BulkFields, ExpressionsOfConstantValueGiveTheMatricesOfNumbers)
{
  const MeshHierarchy<2> meshes = make_brick<2>(3);
  for (const VolumetricStrain strain :
       {VolumetricStrain::full, VolumetricStrain::patch_mean})
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

      const Tensor<1, 2> g({3., -9.81});
      const NodalVector  load = assemble_gravity(meshes.finest(), {numbers}, g);
      NodalVector        difference =
        assemble_gravity(meshes.finest(), {expressions}, g);
      difference -= load;
      EXPECT_LT(difference.linfty_norm(), 1e-15 * load.linfty_norm());
    }
}



namespace
{
  /**
   * Parameters that are quadratic in x and y on a brick, whose energies of
   * simple motions are known. With two Gauss points per axis they are exact.
   */
  template <int dim>
  void
  expect_exact_energies()
  {
    const MeshHierarchy<dim> meshes = make_brick<dim>(3);
    const MeshLevel<dim>    &level  = meshes.finest();
    const BodyGeometry<dim>  body = stack<dim>({make_body<dim>(1., {}, 0)})[0];
    // The means of the coordinates and of their squares.
    const Point<dim> mean = 0.5 * (body.lower_corner() + body.upper_corner());
    Point<dim>       square;
    double           volume = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double extent = body.upper_corner()[d] - body.lower_corner()[d];
        square[d]           = mean[d] * mean[d] + extent * extent / 12.;
        volume *= extent;
      }

    MaterialFields material = make_material("2e7*(20 + x^2 + 2*y)",
                                            "0",
                                            "1e3*(30 + x - y^2)",
                                            "1e3*(40 - x^2 + y)",
                                            "1e3*(50 + 2*x - y^2)");
    const double   E        = 2e7 * (20. + square[0] + 2. * mean[1]);
    const double   rho      = 1e3 * (30. + mean[0] - square[1]);
    const double   eta      = 1e3 * (40. - square[0] + mean[1]);
    const double   zeta     = 1e3 * (50. + 2. * mean[0] - square[1]);
    for (const VolumetricStrain strain :
         {VolumetricStrain::full, VolumetricStrain::patch_mean})
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

        Tensor<1, dim> g, weight;
        g[0]                   = 3.;
        g[dim - 1]             = -9.81;
        const NodalVector load = assemble_gravity(level, {material}, g);
        for (unsigned int i = 0; i < level.nodes.n_owned(); ++i)
          for (unsigned int c = 0; c < dim; ++c)
            weight[c] += load.local_element(i * dim + c);
        EXPECT_LT((weight - rho * volume * g).norm(), 1e-11 * weight.norm());
      }
  }
} // namespace



TEST(BulkFields, EnergiesOfQuadraticParametersAreExact)
{
  expect_exact_energies<2>();
  expect_exact_energies<3>();
}



namespace
{
  /** A displacement that is zero on the sides of the unit square. */
  Tensor<1, 2>
  chosen_displacement(const Point<2> &x)
  {
    return Tensor<1, 2>(
      {std::sin(numbers::PI * x[0]) * std::sin(numbers::PI * x[1]),
       x[0] * (1. - x[0]) * x[1] * (1. - x[1]) * (1. + 2. * x[0])});
  }



  /** Differences of fourth order: what is left of them is far below the errors
   * of the elements. */
  template <typename Function>
  auto
  derivative(const Function    &function,
             const Point<2>    &x,
             const unsigned int axis)
  {
    const double   h = 1e-3;
    const Point<2> e = h * Point<2>::unit_vector(axis);
    return (8. * (function(Point<2>(x + e)) - function(Point<2>(x - e))) -
            (function(Point<2>(x + 2. * e)) - function(Point<2>(x - 2. * e)))) /
           (12. * h);
  }



  SymmetricTensor<2, 2>
  chosen_stress(const Point<2> &x)
  {
    const double E      = 1e7 * (2. + std::sin(2. * x[0] + 3. * x[1]));
    const double nu     = 0.2 + 0.2 * x[0] * x[1];
    const double mu     = E / (2. * (1. + nu));
    const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
    Tensor<2, 2> G;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d < 2; ++d)
        G[c][d] = derivative(chosen_displacement, x, d)[c];
    const SymmetricTensor<2, 2> eps = symmetrize(G);
    return 2. * mu * eps + lambda * trace(eps) * unit_symmetric_tensor<2>();
  }



  /** The L2 norm of the error of the chosen displacement, m^2. */
  double
  manufactured_error(const unsigned int n_cells)
  {
    BodyGeometry<2> square = make_body<2>(1., {{n_cells, n_cells}}, 0);
    square.lateral_lower.fill(0.);
    square.lateral_upper.fill(1.);
    const MeshHierarchy<2> meshes({square}, MPI_COMM_WORLD);
    const MeshLevel<2>    &level = meshes.finest();
    const TermMatrix<2>    K =
      assemble_elastic_matrices(
        level, {make_material("1e7*(2 + sin(2*x + 3*y))", "0.2 + 0.2*x*y")})
        .stiffness;

    // One in the inside.
    const NodalVector inside =
      interpolate(level, [](const unsigned int, const Point<2> &x) {
        const bool is_inside =
          std::min(x[0], x[1]) > 1e-10 && std::max(x[0], x[1]) < 1. - 1e-10;
        return Tensor<1, 2>({double(is_inside), double(is_inside)});
      });
    struct Operator
    {
      const TermMatrix<2> &K;
      const NodalVector   &inside;

      void
      vmult(NodalVector &result, const NodalVector &u) const
      {
        K.vmult(result, u);
        result.scale(inside);
      }
    };
    const DoFHandler<2>                 &dofs = level.bodies[0]->dof_handler();
    const QGauss<2>                      quadrature(4);
    FEValues<2>                          fe_values(dofs.get_fe(),
                          quadrature,
                          update_values | update_quadrature_points |
                            update_JxW_values);
    std::vector<types::global_dof_index> local(4);
    const auto for_each_point = [&](const auto &action) {
      for (const auto &cell : dofs.active_cell_iterators())
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(local);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            action(q, fe_values.quadrature_point(q), fe_values.JxW(q));
        }
    };
    NodalVector load = level.nodes.make_vector(), u = load;
    for_each_point([&](const unsigned int q,
                       const Point<2>    &x,
                       const double       w) {
      const SymmetricTensor<2, 2> along[2] = {derivative(chosen_stress, x, 0),
                                              derivative(chosen_stress, x, 1)};
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          load.local_element(level.node(0, local[i]) * 2 + c) -=
            (along[0][c][0] + along[1][c][1]) * fe_values.shape_value(i, q) * w;
    });
    load.scale(inside);
    SolverControl         control(2000, 1e-10 * load.l2_norm());
    SolverCG<NodalVector> solver(control);
    solver.solve(Operator{K, inside}, u, load, PreconditionIdentity());

    double square_of_error = 0.;
    for_each_point(
      [&](const unsigned int q, const Point<2> &x, const double w) {
        Tensor<1, 2> error = chosen_displacement(x);
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            error[c] -= u.local_element(level.node(0, local[i]) * 2 + c) *
                        fe_values.shape_value(i, q);
        square_of_error += error.norm_square() * w;
      });
    return std::sqrt(square_of_error);
  }
} // namespace



TEST(BulkFields, AManufacturedDisplacementConvergesWithSecondOrder)
{
  double last = 0;
  for (const unsigned int n : {4, 8, 16, 32})
    {
      const double error = manufactured_error(n);
      std::cout << n << " x " << n << " cells: error " << error << " m^2\n";
      if (last > 0.)
        {
          EXPECT_NEAR(std::log2(last / error), 2., 0.1) << n;
        }
      last = error;
    }
  EXPECT_LT(last, 2e-3);
}
