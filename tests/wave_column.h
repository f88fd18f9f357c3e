// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_wave_column_h
#define stickslip_tests_wave_column_h

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace StickSlip::Tests
{
  using namespace dealii;

  /**
   * Two elastic columns of equal height and impedance in shear, one on the
   * other, with rate-and-state friction between them; the lower end is held,
   * the upper one moved. By characteristics: waves travel without change, are
   * turned over at the ends, and come back to the fault after twice the time of
   * travel. With f the velocity of the waves that arrive and g that of those
   * that leave, above (u) and below (l),
   *
   *   V = f_u + g_u - f_l - g_l,   tau = Z (f_u - g_u) = Z (g_l - f_l),
   *   f_u(t) = v_top(t - T) - g_u(t - 2 T),   f_l(t) = -g_l(t - 2 T),
   *
   * so that V + 2 tau(V, theta) / Z = 2 (f_u - f_l) holds at each moment, and
   * an ordinary differential equation for ln(theta) with a delay remains: no
   * mesh. It is integrated by the classical Runge-Kutta method of fourth order,
   * with cubic interpolation of the waves. Columns at rest without shear stress
   * at t = 0. Nothing here comes from the program.
   */
  struct WaveColumn
  {
    /** Pa, kg/m^3, m. */
    double shear_modulus, density, height;
    /** Friction in SI units, aging law; mu = a ln(V / Vmin) above Vmin and zero
     * below, or a asinh(V / (2 Vmin)). */
    double a, b, mu0, V0, L, normal_stress;
    bool   is_arcsinh = false;
    /** Velocity of the upper end, m/s, of time. */
    std::function<double(double)> velocity_of_top;
    /** Steps in the time that a wave takes to an end and back. */
    unsigned int steps_a_passage = 1000;

    /** Times, s, slip rates, m/s, and states ln(theta / 1 s). */
    std::vector<double> time, slip_rate, alpha;

    double
    passage() const
    {
      return 2. * height / std::sqrt(shear_modulus / density);
    }

    void
    run(const double end_time, const double initial_alpha)
    {
      const double       h       = passage() / steps_a_passage;
      const unsigned int n_steps = std::ceil(end_time / h);
      leaving_above.assign(n_steps + 1, 0.);
      leaving_below.assign(n_steps + 1, 0.);
      time      = {0.};
      slip_rate = {0.};
      alpha     = {initial_alpha};
      for (unsigned int n = 0; n < n_steps; ++n)
        {
          const double t = n * h, y = alpha.back();
          const double k1 = rate(n, y), k2 = rate(n + 0.5, y + h / 2. * k1),
                       k3 = rate(n + 0.5, y + h / 2. * k2),
                       k4 = rate(n + 1., y + h * k3);
          alpha.push_back(y + h / 6. * (k1 + 2. * k2 + 2. * k3 + k4));
          time.push_back(t + h);
          const auto [above, below] = arriving(n + 1.);
          slip_rate.push_back(
            slip_rate_for(2. * (above - below), alpha.back()));
          const double traction =
            impedance() / 2. * (2. * (above - below) - slip_rate.back());
          leaving_above[n + 1] = above - traction / impedance();
          leaving_below[n + 1] = below + traction / impedance();
        }
    }

    /** The velocity at a height y above the fault, m/s, negative below it. */
    double
    velocity(const double y, const double t) const
    {
      const double h     = passage() / steps_a_passage;
      const double delay = std::abs(y) / std::sqrt(shear_modulus / density);
      const auto   there = arriving((t + delay) / h);
      const double left =
        wave(y > 0. ? leaving_above : leaving_below, (t - delay) / h);
      return left + (y > 0. ? there.first : there.second);
    }

  private:
    std::vector<double> leaving_above, leaving_below;

    double
    impedance() const
    {
      return std::sqrt(shear_modulus * density);
    }

    /** A wave that left the fault, @p step steps after t = 0. */
    double
    wave(const std::vector<double> &values, const double step) const
    {
      if (step <= 0.)
        return 0.;
      const double whole = std::floor(step), x = step - whole;
      const auto   i  = static_cast<std::size_t>(whole);
      const auto   at = [&](const std::size_t k) { return values[k]; };
      if (x == 0.)
        return at(i);
      const double before = i == 0 ? 0. : at(i - 1);
      return -x * (x - 1.) * (x - 2.) / 6. * before +
             (x + 1.) * (x - 1.) * (x - 2.) / 2. * at(i) -
             (x + 1.) * x * (x - 2.) / 2. * at(i + 1) +
             (x + 1.) * x * (x - 1.) / 6. * at(i + 2);
    }

    std::pair<double, double>
    arriving(const double step) const
    {
      const double h = passage() / steps_a_passage;
      const double t = step * h - passage() / 2.;
      return {(t > 0. ? velocity_of_top(t) : 0.) -
                wave(leaving_above, step - steps_a_passage),
              -wave(leaving_below, step - steps_a_passage)};
    }

    /** The solution of V + 2 tau(V) / Z = r. */
    double
    slip_rate_for(const double r, const double y) const
    {
      if (r == 0.)
        return 0.;
      const double x_min =
        std::log(V0) - (mu0 + b * (y + std::log(V0 / L))) / a;
      const double c = 2. * normal_stress * a / impedance();
      if (is_arcsinh)
        return slip_rate_arcsinh(r, c, std::exp(x_min));
      const double size = std::abs(r);
      if (std::log(size) <= x_min)
        return r;
      // Convex and growing in x = ln V: from above Newton goes down to it.
      double x = std::min(std::log(size), x_min + size / c);
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double e    = std::exp(x);
          const double step = (e + c * (x - x_min) - size) / (e + c);
          x -= step;
          if (std::abs(step) < 1e-14 * std::max(1., std::abs(x)))
            return std::copysign(std::exp(x), r);
        }
      AssertThrow(false, ExcMessage("No slip rate was found."));
      return 0.;
    }

    /** The solution of V + c asinh(V / (2 V_min)) = r. */
    static double
    slip_rate_arcsinh(const double r, const double c, const double V_min)
    {
      // In z = asinh(V / (2 V_min)), from the far side of the solution.
      double z = std::asinh(r / (2. * V_min));
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double step = (2. * V_min * std::sinh(z) + c * z - r) /
                              (2. * V_min * std::cosh(z) + c);
          z -= step;
          if (std::abs(step) < 1e-14 * std::max(1., std::abs(z)))
            return 2. * V_min * std::sinh(z);
        }
      AssertThrow(false, ExcMessage("No slip rate was found."));
      return 0.;
    }

    double
    rate(const double step, const double y) const
    {
      const auto [above, below] = arriving(step);
      return std::exp(-y) -
             std::abs(slip_rate_for(2. * (above - below), y)) / L;
    }
  };
} // namespace StickSlip::Tests

#endif
