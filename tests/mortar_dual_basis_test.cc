// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>
#include <stickslip/mortar/dual_basis.h>
#include <stickslip/mortar/face_shape.h>

#include "mortar_surfaces.h"

using namespace StickSlip;

namespace
{
  /** The shape functions of the unit face at a point. */
  template <int dim>
  typename DualBasis<dim>::Vector
  unit_shape_values(const Point<dim - 1> &x)
  {
    typename DualBasis<dim>::Vector values;
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        values[i] = 1.;
        for (unsigned int d = 0; d < dim - 1; ++d)
          values[i] *= (i >> d) & 1 ? x[d] : 1. - x[d];
      }
    return values;
  }



  /** Integrals of products of two functions over a box in the unit face. */
  template <int dim, typename F, typename G>
  typename DualBasis<dim>::Matrix
  integrate(const Point<dim - 1> &lower,
            const Point<dim - 1> &upper,
            const F              &f,
            const G              &g)
  {
    typename DualBasis<dim>::Matrix result = {};
    const QGauss<dim - 1>           quadrature(4);
    for (unsigned int k = 0; k < quadrature.size(); ++k)
      {
        Point<dim - 1> x;
        double         JxW = quadrature.weight(k);
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            x[d] = lower[d] + quadrature.point(k)[d] * (upper[d] - lower[d]);
            JxW *= upper[d] - lower[d];
          }
        const auto f_values = f(x), g_values = g(x);
        for (unsigned int i = 0; i < f_values.size(); ++i)
          for (unsigned int j = 0; j < g_values.size(); ++j)
            result[i][j] += f_values[i] * g_values[j] * JxW;
      }
    return result;
  }



  template <int dim>
  void
  check_box(const Point<dim - 1>                      &lower,
            const Point<dim - 1>                      &upper,
            const std::array<bool, DualBasis<dim>::n> &active)
  {
    constexpr unsigned int n    = DualBasis<dim>::n;
    const auto             phi  = unit_shape_values<dim>;
    const auto             mass = integrate<dim>(lower, upper, phi, phi);
    DualBasis<dim>         basis(mass);
    ASSERT_TRUE(basis.is_valid());
    basis.restrict_to(active);

    const auto psi = [&](const Point<dim - 1> &x) {
      const auto                      values = phi(x);
      typename DualBasis<dim>::Vector result = {};
      for (unsigned int p = 0; p < n; ++p)
        for (unsigned int q = 0; q < n; ++q)
          result[p] += basis.coefficients()[p][q] * values[q];
      return result;
    };
    const auto products = integrate<dim>(lower, upper, psi, phi);

    for (unsigned int q = 0; q < n; ++q)
      {
        double D = 0., sum = 0.;
        for (unsigned int p = 0; p < n; ++p)
          {
            D += mass[q][p];
            sum += products[p][q];
          }
        // Relative to the weight of the shape function, however small. The
        // sum over all functions is that against the constant one.
        EXPECT_NEAR(sum, D, 1e-13 * D);
        for (unsigned int p = 0; p < n; ++p)
          {
            if (!active[p])
              {
                EXPECT_EQ(products[p][q], 0.);
              }
            else if (active[q])
              {
                EXPECT_NEAR(products[p][q], p == q ? D : 0., 1e-13 * D);
              }
          }
      }
  }
} // namespace



TEST(DualBasis, WholeSegmentIsTheKnownOne)
{
  DualBasis<2>::Matrix mass;
  mass[0] = {{1. / 3., 1. / 6.}};
  mass[1] = {{1. / 6., 1. / 3.}};
  const DualBasis<2> basis(mass);
  ASSERT_TRUE(basis.is_valid());
  EXPECT_NEAR(basis.coefficients()[0][0], 2., 1e-15);
  EXPECT_NEAR(basis.coefficients()[0][1], -1., 1e-15);
  EXPECT_NEAR(basis.coefficients()[1][0], -1., 1e-15);
  EXPECT_NEAR(basis.coefficients()[1][1], 2., 1e-15);
}



TEST(DualBasis, BiorthogonalOnPartlyCoveredSegments)
{
  for (const double c : {1., 0.7, 0.1, 1e-3, 1e-6, 1e-10})
    for (const auto &active : {std::array<bool, 2>{{true, true}},
                               std::array<bool, 2>{{true, false}},
                               std::array<bool, 2>{{false, true}}})
      check_box<2>(Point<1>(0.), Point<1>(c), active);
  check_box<2>(Point<1>(0.2), Point<1>(1.), {{true, true}});
  check_box<2>(Point<1>(0.3), Point<1>(0.8), {{true, true}});
}



TEST(DualBasis, BiorthogonalOnPartlyCoveredRectangles)
{
  for (const double a : {1., 0.4, 1e-3, 1e-8})
    for (const double b : {1., 0.6, 1e-2, 1e-8})
      for (unsigned int bits = 1; bits < 16; ++bits)
        check_box<3>(Point<2>(0., 0.),
                     Point<2>(a, b),
                     {{(bits & 1) != 0,
                       (bits & 2) != 0,
                       (bits & 4) != 0,
                       (bits & 8) != 0}});
}



TEST(DualBasis, ThinStripsInsideAFaceAreRefused)
{
  const auto make = [](const double x0, const double x1) {
    const auto phi = unit_shape_values<3>;
    return DualBasis<3>(
      integrate<3>(Point<2>(x0, 0.), Point<2>(x1, 1.), phi, phi));
  };
  EXPECT_TRUE(make(0., 0.01).is_valid());
  EXPECT_TRUE(make(0.4, 0.6).is_valid());
  EXPECT_FALSE(make(0.5, 0.51).is_valid());
  EXPECT_FALSE(make(0.5, 0.5).is_valid());
  EXPECT_FALSE(DualBasis<2>(DualBasis<2>::Matrix()).is_valid());
}
