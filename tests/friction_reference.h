// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_friction_reference_h
#define stickslip_tests_friction_reference_h

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <stickslip/friction/rate_and_state.h>

#include <limits>
#include <random>

/**
 * The friction law and its scalar local problem in fifty digits, by methods
 * that share nothing with the library: the definitions and bisection.
 */
namespace Reference
{
  using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                  boost::multiprecision::et_off>;

  constexpr double epsilon = std::numeric_limits<double>::epsilon();

  /**
   * mu / a of rate-and-state friction.
   */
  inline Real
  scaled_coefficient(const StickSlip::Regularisation regularisation,
                     const Real                     &V,
                     const double                    log_vmin)
  {
    if (V == 0)
      return 0;
    if (regularisation == StickSlip::Regularisation::truncated)
      {
        const Real z = log(V) - log_vmin;
        return (z > 0) ? z : Real(0);
      }
    // asinh(x) = ln(x + sqrt(x^2 + 1)), with x + sqrt(x^2 + 1) - 1 rewritten.
    const Real x = exp(log(V) - log_vmin) / 2;
    return log1p(x + x * x / (1 + sqrt(1 + x * x)));
  }

  /**
   * d(mu/a) / dV.
   */
  inline Real
  scaled_derivative(const StickSlip::Regularisation regularisation,
                    const Real                     &V,
                    const double                    log_vmin)
  {
    const Real vmin = exp(Real(log_vmin));
    if (regularisation == StickSlip::Regularisation::truncated)
      return (V > vmin) ? 1 / V : Real(0);
    return 1 / sqrt(V * V + 4 * vmin * vmin);
  }

  /**
   * The solution v > 0 of c v + k a z(v) = r, by bisection for ln(v).
   */
  inline Real
  local_minimiser(const StickSlip::Regularisation regularisation,
                  const double                    c,
                  const double                    r,
                  const Real                     &ka,
                  const double                    log_vmin)
  {
    Real lower = -800;
    Real upper = log(Real(r) / c) + 1e-10;
    while (upper - lower > 1e-18)
      {
        const Real middle = (lower + upper) / 2;
        const Real v      = exp(middle);
        if (c * v + ka * scaled_coefficient(regularisation, v, log_vmin) < r)
          lower = middle;
        else
          upper = middle;
      }
    return exp((lower + upper) / 2);
  }

  /**
   * |computed / exact - 1|.
   */
  inline double
  relative_error(const double computed, const Real &exact)
  {
    return static_cast<double>(abs(computed / exact - 1));
  }

  /**
   * Numbers whose logarithms are evenly distributed.
   */
  class LogUniform
  {
  public:
    LogUniform(const double lower, const double upper)
      : distribution(std::log(lower), std::log(upper))
    {}

    template <typename Engine>
    double
    operator()(Engine &engine)
    {
      return std::exp(distribution(engine));
    }

  private:
    std::uniform_real_distribution<double> distribution;
  };
} // namespace Reference

#endif
