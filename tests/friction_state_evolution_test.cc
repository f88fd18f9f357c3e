// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <boost/numeric/odeint.hpp>

#include <gtest/gtest.h>
#include <stickslip/friction/state_evolution.h>

#include <array>
#include <cmath>
#include <functional>

#include "friction_reference.h"

using namespace StickSlip;
using Reference::epsilon;
using Reference::Real;

namespace
{
  constexpr double L = 2e-5;

  const StateLaw                     &aging = *state_laws()[0].law;
  const StateLaw                     &slip  = *state_laws()[1].law;
  const std::vector<const StateLaw *> laws{&aging, &slip};

  /**
   * Integrate alpha' = f(alpha, V(t)) from t = 0 to @p end with an adaptive
   * method of order five, the laws written down anew.
   */
  long double
  integrate(const StateLaw *const                          law,
            const long double                              alpha,
            const std::function<long double(long double)> &V,
            const long double                              end)
  {
    namespace odeint = boost::numeric::odeint;
    using State      = std::array<long double, 1>;
    using Stepper    = odeint::runge_kutta_dopri5<State, long double>;
    State x{{alpha}};
    odeint::integrate_adaptive(
      odeint::make_controlled<Stepper>(1e-17L, 1e-17L),
      [&](const State &a, State &rate, const long double t) {
        const long double ratio = V(t) / L;
        rate[0]                 = (law == &aging) ? std::exp(-a[0]) - ratio :
                                                    -ratio * (a[0] + std::log(ratio));
      },
      x,
      0.L,
      end,
      end / 1000.L);
    return x[0];
  }

  /**
   * The exponential update from its formula, in fifty digits.
   */
  Real
  exact_exponential(const StateLaw *const law,
                    const double          alpha,
                    const double          V,
                    const double          tau)
  {
    const Real ratio = Real(V) / L;
    const Real decay = exp(-ratio * tau);
    if (law == &aging)
      return log(exp(Real(alpha)) * decay + (1 - decay) / ratio);
    return (alpha + log(ratio)) * decay - log(ratio);
  }

  /**
   * The implicit Euler step by bisection of its increasing residual.
   */
  Real
  exact_implicit(const StateLaw *const law,
                 const double          alpha,
                 const double          V,
                 const double          tau)
  {
    const Real ratio = Real(V) / L;
    Real       lower = -2e6, upper = 2e6;
    for (unsigned int i = 0; i < 140; ++i)
      {
        const Real x                             = (lower + upper) / 2;
        const Real rate                          = (law == &aging) ?
                                                     (x < -2000 ? Real("1e1000") : exp(-x)) - ratio :
                                                     -ratio * (x + log(ratio));
        (x - alpha < tau * rate ? lower : upper) = x;
      }
    return lower;
  }

  const std::vector<StateUpdate> updates{StateUpdate::exponential,
                                         StateUpdate::implicit_euler};
} // namespace



TEST(StateEvolution, RateVanishesInSteadyState)
{
  for (const StateLaw *const law : laws)
    for (const double V : {1e-12, 1e-6, 1e-3})
      {
        const double alpha = -std::log(V / L);
        EXPECT_NEAR(std::exp(alpha), L / V, 1e-13 * L / V);
        EXPECT_NEAR(law->rate(alpha, V, L), 0., 1e-13 * V / L);
        // Below it the state grows, above it falls.
        EXPECT_GT(law->rate(alpha - 0.1, V, L), 0.);
        EXPECT_LT(law->rate(alpha + 0.1, V, L), 0.);
        for (const StateUpdate update : updates)
          for (const double tau : {1e-3, 1., 1e6})
            EXPECT_NEAR(law->updated(update, alpha, V, L, tau), alpha, 1e-13);
      }
}



TEST(StateEvolution, UpdatesAgreeWithHighPrecision)
{
  std::mt19937                           engine(2);
  std::uniform_real_distribution<double> random_alpha(-700., 700.);
  std::uniform_real_distribution<double> random_mild_alpha(-20., 20.);
  Reference::LogUniform                  random_tau(1e-12, 1e5);
  Reference::LogUniform                  random_steps(1e-18, 1e6);
  double                                 largest = 0.;
  for (unsigned int i = 0; i < 3000; ++i)
    for (const StateLaw *const law : laws)
      {
        const double alpha =
          (i % 2 == 0) ? random_mild_alpha(engine) : random_alpha(engine);
        const double tau = random_tau(engine);
        const double V   = random_steps(engine) * L / tau;
        for (const StateUpdate update : updates)
          {
            const Real   exact = (update == StateUpdate::exponential) ?
                                   exact_exponential(law, alpha, V, tau) :
                                   exact_implicit(law, alpha, V, tau);
            const double scale =
              1. + std::abs(alpha) + std::abs(static_cast<double>(exact)) +
              std::abs(std::log(tau)) + std::abs(std::log(V / L));
            const double error = std::abs(static_cast<double>(
              law->updated(update, alpha, V, L, tau) - exact));
            EXPECT_LT(error, 2. * epsilon * scale)
              << "law " << (law == &slip) << ", update "
              << static_cast<int>(update) << ", alpha = " << alpha
              << ", V = " << V << ", tau = " << tau;
            largest = std::max(largest, error / scale);
          }
      }
  RecordProperty("largest_error_in_epsilon", std::to_string(largest / epsilon));
}



TEST(StateEvolution, ExponentialUpdateIsExactAtConstantSlipRate)
{
  for (const StateLaw *const law : laws)
    for (const double alpha : {-5., 0., 8.})
      for (const double V : {1e-9, 1e-6, 2e-4})
        for (const double tau : {1e-3, 0.1, 2.})
          EXPECT_NEAR(law->updated(StateUpdate::exponential, alpha, V, L, tau),
                      static_cast<double>(integrate(
                        law, alpha, [V](long double) { return V; }, tau)),
                      1e-13 * (1. + std::abs(alpha)));
}



TEST(StateEvolution, ImplicitEulerStepMinimisesItsFunctional)
{
  // psi' = -alpha'; psi = exp(-x) + V/L x, respectively
  // V/L (x^2/2 + x ln(V/L)).
  const double V = 3e-5, tau = 0.7;
  for (const StateLaw *const law : laws)
    for (const double alpha : {-4., 1., 6.})
      {
        const auto functional = [&](const Real &x) -> Real {
          const Real ratio = Real(V) / L;
          const Real psi   = (law == &aging) ?
                               exp(-x) + ratio * x :
                               ratio * (x * x / 2 + x * log(ratio));
          return (x - alpha) * (x - alpha) / (2 * tau) + psi;
        };
        const Real x =
          law->updated(StateUpdate::implicit_euler, alpha, V, L, tau);
        for (const double distance : {1e-10, 1e-3, 1., 5.})
          {
            EXPECT_LT(functional(x), functional(x + distance));
            EXPECT_LT(functional(x), functional(x - distance));
          }
      }
}



TEST(StateEvolution, ObservedOrders)
{
  // A slip rate that varies by a decade and a half.
  const auto V = [](const long double t) -> long double {
    return 1e-5L * std::exp(1.7L * std::sin(3.L * t));
  };
  const double alpha = 1.5, end = 2.;
  for (const StateLaw *const law : laws)
    {
      const double exact = static_cast<double>(integrate(law, alpha, V, end));
      for (const StateUpdate update : updates)
        {
          const bool exponential = (update == StateUpdate::exponential);
          const auto error       = [&](const unsigned int n_steps) {
            const double tau = end / n_steps;
            double       x   = alpha;
            for (unsigned int i = 0; i < n_steps; ++i)
              {
                const double V0 = static_cast<double>(V(i * tau));
                const double V1 = static_cast<double>(V((i + 1) * tau));
                x               = law->updated(
                  update, x, exponential ? 0.5 * (V0 + V1) : V1, L, tau);
              }
            return std::abs(x - exact);
          };
          const double coarse = error(400), fine = error(800);
          EXPECT_NEAR(std::log2(coarse / fine), exponential ? 2. : 1., 0.05)
            << "law " << (law == &slip) << ", errors " << coarse << ", "
            << fine;
          EXPECT_LT(fine, exponential ? 1e-4 : 2e-2);
        }
    }
}



TEST(StateEvolution, ExtremeValuesAreHarmless)
{
  for (const StateLaw *const law : laws)
    for (const StateUpdate update : updates)
      for (const double alpha : {-700., -40., 0., 40., 700.})
        for (const double tau : {0., 1e-300, 1e-10, 1., 1e8})
          {
            double last = std::numeric_limits<double>::infinity();
            for (const double V : {0., 1e-320, 1e-300, 1e-30, 1e-3, 1e3, 1e9})
              {
                const double x = law->updated(update, alpha, V, L, tau);
                EXPECT_TRUE(std::isfinite(x));
                // Under the aging law slip only ever shortens the contacts.
                if (law == &aging)
                  {
                    EXPECT_LE(x, last + 1e-12);
                  }
                last = x;
                if (tau == 0.)
                  {
                    EXPECT_NEAR(x, alpha, epsilon * std::abs(alpha));
                  }
              }
            // At rest, theta grows with time or not at all.
            const double at_rest = law->updated(update, alpha, 0., L, tau);
            if (law == &slip)
              {
                EXPECT_EQ(at_rest, alpha);
              }
            else
              {
                EXPECT_GE(at_rest, alpha);
              }
          }
}
