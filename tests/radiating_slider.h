// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_radiating_slider_h
#define stickslip_tests_radiating_slider_h

#include <deal.II/base/exceptions.h>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace StickSlip::Tests
{
  using namespace dealii;

  /**
   * A slider without mass on a spring, with a dashpot beside the spring,
   * radiation damping and rate-and-state friction (aging law),
   *
   *   k (w - d) + c (w' - V) = sigma_n mu(V, alpha) + eta V,
   *   d' = V,   alpha' = exp(-alpha) - V / L,
   *
   * per unit area, mu being a ln(V / Vmin) above Vmin and zero below, or
   * a asinh(V / (2 Vmin)). The first equation is solved for V, and the two
   * others are integrated by the explicit Runge-Kutta method of Dormand and
   * Prince with control of the error (Boost.Odeint). At rest without stress at
   * t = 0. Nothing here comes from the program.
   */
  struct RadiatingSlider
  {
    /** Pa/m; Pa s/m. */
    double stiffness, dashpot, radiation_damping;
    double a, b, mu0, V0, L, normal_stress;
    bool   is_arcsinh = false;
    /** Displacement, m, and velocity, m/s, of the end of the spring. */
    std::function<std::array<double, 2>(double)> loading;
    double                                       tolerance = 1e-13;

    std::vector<double> time, slip_rate, alpha;

    /** Until the end time or until a slip rate, m/s, is reached. */
    void
    run(const double end_time,
        const double initial_alpha,
        const double largest_slip_rate = 1e300)
    {
      namespace ode      = boost::numeric::odeint;
      using State        = std::array<double, 2>;
      auto       stepper = ode::make_controlled(tolerance,
                                          tolerance,
                                          ode::runge_kutta_dopri5<State>());
      const auto rhs     = [this](const State &x, State &dxdt, const double t) {
        const double V = slip_rate_for(x[0], x[1], t);
        dxdt           = {{V, bounded_exp(-x[1]) - V / L}};
      };
      State  x{{0., initial_alpha}};
      double t = 0., h = 1e-6;
      time      = {0.};
      slip_rate = {0.};
      alpha     = {initial_alpha};
      while (t < end_time && slip_rate.back() < largest_slip_rate)
        {
          h = std::min({h, end_time - t, 0.05});
          while (stepper.try_step(rhs, x, t, h) == ode::fail)
            AssertThrow(h > 1e-16, ExcMessage("The step has become zero."));
          time.push_back(t);
          slip_rate.push_back(slip_rate_for(x[0], x[1], t));
          alpha.push_back(x[1]);
        }
    }

  private:
    /** Attempts at a step that is far too long must end with numbers, to be
     * rejected. */
    static double
    bounded_exp(const double x)
    {
      return std::exp(std::min(x, 50.));
    }

    /** The solution of linear V + s asinh(V / (2 V_min)) = force. */
    static double
    slip_rate_arcsinh(const double force,
                      const double linear,
                      const double s,
                      const double V_min)
    {
      // In z = asinh(V / (2 V_min)), from the far side of the solution.
      double z = force / s;
      if (linear > 0.)
        z = std::min(z, std::asinh(force / linear / (2. * V_min)));
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double step =
            (2. * V_min * linear * std::sinh(z) + s * z - force) /
            (2. * V_min * linear * std::cosh(z) + s);
          z -= step;
          if (std::abs(step) < 1e-14 * std::max(1., std::abs(z)))
            return 2. * V_min * std::sinh(z);
        }
      AssertThrow(false, ExcMessage("No slip rate was found."));
      return 0.;
    }

    /** Slip rate that balances the forces at slip d and state y. */
    double
    slip_rate_for(const double d, const double y, const double t) const
    {
      const auto [w, w_t] = loading(t);
      const double force  = stiffness * (w - d) + dashpot * w_t;
      const double linear = dashpot + radiation_damping;
      const double x_min =
        std::log(V0) - (mu0 + b * (y + std::log(V0 / L))) / a;
      const double s = normal_stress * a;
      if (force <= 0.)
        return 0.;
      if (is_arcsinh)
        return slip_rate_arcsinh(force, linear, s, std::exp(x_min));
      if (linear == 0.)
        return bounded_exp(x_min + force / s);
      // linear e^x + s (x - x_min) = force is convex and grows: Newton's method
      // goes down to its zero from above.
      double x = std::min(x_min + force / s, std::log(force / linear));
      if (x <= x_min)
        return force / linear;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double e    = linear * std::exp(x);
          const double step = (e + s * (x - x_min) - force) / (e + s);
          x -= step;
          if (std::abs(step) < 1e-14 * std::max(10., force / s))
            return std::exp(x);
        }
      AssertThrow(false, ExcMessage("No slip rate was found."));
      return 0.;
    }
  };
} // namespace StickSlip::Tests

#endif
