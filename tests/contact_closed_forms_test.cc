// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <functional>

#include "contact_closed_forms.h"

using namespace StickSlip::Tests;

namespace
{
  /** Integral from a to b of a function with roots, logarithms or inverse roots
   * at both ends. */
  double
  integral(const std::function<double(double)> &f,
           const double                         a,
           const double                         b)
  {
    static const QGauss<1> gauss(200);
    double                 sum = 0;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        // A substitution that is flat at both ends.
        const double t = gauss.point(q)[0];
        const double s = t * t * (3 - 2 * t);
        sum += gauss.weight(q) * 6 * t * (1 - t) * (b - a) * f(a + (b - a) * s);
      }
    return sum;
  }



  /** Depth of the surface of a half-plane at x below that at the centre, m,
   * under a pressure on |x| < a (Johnson 1985, section 2.8). */
  double
  sinks_below_centre(const std::function<double(double)> &pressure,
                     const double                         a,
                     const double                         modulus,
                     const double                         x)
  {
    const auto at = [&](const double y) {
      const auto f = [&](const double s) {
        return pressure(s) * std::log(std::abs(y - s));
      };
      return -2 / (numbers::PI * modulus) *
             (integral(f, -a, y) + integral(f, y, a));
    };
    return at(x) - at(0);
  }



  /** Depth to which the surface of a half-space sinks at the distance r from
   * the axis of a pressure on a circle of radius a: in polar coordinates around
   * the point (Boussinesq). */
  double
  sinks(const std::function<double(double)> &pressure,
        const double                         a,
        const double                         modulus,
        const double                         r)
  {
    constexpr unsigned int n   = 200;
    double                 sum = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double phi  = 2 * numbers::PI * (i + 0.5) / n;
        const double c    = r * std::cos(phi);
        const double last = -c + std::sqrt(c * c + a * a - r * r);
        sum += integral(
          [&](const double s) {
            return pressure(std::sqrt(
              std::min(a * a * (1 - 1e-15), r * r + s * s + 2 * s * c)));
          },
          0,
          last);
      }
    return 2 * numbers::PI / n * sum / (numbers::PI * modulus);
  }
} // namespace



TEST(FlyingBar, IsASumOfWavesThatKeepsItsEnergy)
{
  const FlyingBar        bar     = {2., 3., 0.7, 1.3, 0.4};
  const double           c       = bar.wave_speed();
  const double           end     = bar.impact() + bar.duration();
  double                 impulse = 0;
  constexpr unsigned int n_times = 400;
  for (unsigned int i = 0; i < n_times; ++i)
    {
      const double dt = 1.5 * end / n_times, t = (i + 0.5) * dt;
      // Each sum of a wave to the left and one to the right fulfils this.
      for (double x = 0.1; x < 1.95; x += 0.13)
        for (const double d : {1e-3, 0.05})
          EXPECT_NEAR(bar.displacement(x, t + d / c) +
                        bar.displacement(x, t - d / c),
                      bar.displacement(x + d, t) + bar.displacement(x - d, t),
                      1e-14);
      constexpr double d = 1e-6;
      // The free end has no strain, the other one that of the pressure; it is
      // never inside the wall.
      EXPECT_NEAR(bar.displacement(2, t),
                  bar.displacement(2 - d, t),
                  2 * d * d);
      if (std::abs(t - bar.impact()) > d && std::abs(t - end) > d)
        {
          EXPECT_NEAR(bar.modulus *
                        (bar.displacement(0, t) - bar.displacement(d, t)) / d,
                      bar.pressure(t),
                      1e-8);
        }
      const double gap = bar.gap + bar.displacement(0, t);
      EXPECT_GE(gap, -1e-15);
      if (bar.pressure(t) > 0)
        {
          EXPECT_NEAR(gap, 0, 1e-15);
        }

      double           kinetic = 0, elastic = 0, momentum = 0;
      constexpr double n = 4000;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double x = (k + 0.5) * bar.length / n, dx = bar.length / n;
          const double v = bar.velocity(x, t);
          const double strain =
            (bar.displacement(x + d, t) - bar.displacement(x - d, t)) / (2 * d);
          kinetic += bar.density * v * v / 2 * dx;
          elastic += bar.modulus * strain * strain / 2 * dx;
          momentum += bar.density * v * dx;
        }
      EXPECT_NEAR(kinetic, bar.kinetic_energy(t), 2e-3);
      EXPECT_NEAR(elastic, bar.elastic_energy(t), 2e-3);
      impulse += dt * bar.pressure(t) / 2;
      EXPECT_NEAR(momentum,
                  -bar.density * bar.length * bar.speed + impulse,
                  0.02);
      impulse += dt * bar.pressure(t) / 2;
    }
}



TEST(Hertz, SurfacesFitInTheContactOfCylinders)
{
  const HertzLine hertz = {7., 3., 40.};
  const double    a     = hertz.half_width();
  const auto      p     = [&](const double x) { return hertz.pressure(x); };
  EXPECT_NEAR(integral(p, -a, a), hertz.load, 1e-12);
  for (const double x : {0.2 * a, -0.5 * a, 0.9 * a})
    EXPECT_NEAR(sinks_below_centre(p, a, hertz.modulus, x),
                -x * x / (2 * hertz.radius),
                1e-7);
  EXPECT_EQ(hertz.pressure(1.01 * a), 0);
}



TEST(Hertz, SurfacesFitInTheContactOfSpheres)
{
  const HertzSphere hertz = {7., 3., 40.};
  const double      a     = hertz.contact_radius();
  const auto        p     = [&](const double r) { return hertz.pressure(r); };
  EXPECT_NEAR(
    integral([&](const double r) { return 2 * numbers::PI * r * p(r); }, 0, a),
    hertz.load,
    1e-12);
  for (const double r : {0., 0.3 * a, 0.8 * a})
    EXPECT_NEAR(sinks(p, a, hertz.modulus, r),
                hertz.approach() - r * r / (2 * hertz.radius),
                1e-7);
}



TEST(FlatPunch, SinksInEvenly)
{
  constexpr double load = 7, a = 0.6, modulus = 40;
  const auto       line = [&](const double x) {
    return flat_punch_pressure(load, a, x);
  };
  EXPECT_NEAR(integral(line, -a, a), load, 1e-6);
  for (const double x : {0.2 * a, -0.5 * a, 0.9 * a})
    EXPECT_NEAR(sinks_below_centre(line, a, modulus, x), 0, 1e-6);
  const auto round = [&](const double r) {
    return round_punch_pressure(load, a, r);
  };
  for (const double r : {0., 0.3 * a, 0.8 * a})
    EXPECT_NEAR(sinks(round, a, modulus, r),
                round_punch_depth(load, a, modulus),
                1e-5);
}



TEST(LiftedBeam, NeitherPullsNorDipsIntoThePlane)
{
  const LiftedBeam beam = {5., 0.3, 0.02};
  const double     EI = beam.stiffness, w = beam.weight, d = beam.lift;
  // A beam that is clamped at the distance l from its end, which is held at d:
  // y = p x^2 + q x^3 - w x^4 / (24 EI).
  const auto coefficients = [&](const double l) {
    const double q =
      -(d - w * std::pow(l, 4) / (24 * EI) * 5) / (2 * std::pow(l, 3));
    const double p = w * l * l / (4 * EI) - 3 * q * l;
    EXPECT_NEAR(p * l * l + q * l * l * l - w * std::pow(l, 4) / (24 * EI),
                d,
                1e-14);
    return std::make_pair(p, q);
  };
  const double l = beam.length();
  // A plane would have to pull at a shorter one, a longer one would be inside.
  EXPECT_GT(coefficients(0.99 * l).first, 0);
  EXPECT_LT(coefficients(1.01 * l).first, 0);
  const auto [p, q] = coefficients(l);
  EXPECT_NEAR(p, 0, 1e-14);
  for (const double x : {0.1 * l, 0.7 * l})
    EXPECT_NEAR(beam.gap(x),
                q * x * x * x - w * std::pow(x, 4) / (24 * EI),
                1e-14);
  EXPECT_NEAR(beam.gap(l), d, 1e-14);
  EXPECT_EQ(beam.gap(-1), 0);
  // The force is the change of the energy with the lift.
  const LiftedBeam higher = {EI, w, d * (1 + 1e-6)};
  const auto       work   = [&](const LiftedBeam &of) {
    return integral(
      [&](const double x) {
        const double bend = w / (2 * EI) * x * (of.length() - x);
        return EI / 2 * bend * bend + w * of.gap(x);
      },
      0,
      of.length());
  };
  EXPECT_NEAR((work(higher) - work(beam)) / (d * 1e-6),
              beam.force(),
              1e-5 * beam.force());
}
