// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_rate_and_state_h
#define stickslip_friction_rate_and_state_h

#include <stickslip/friction/law_registry.h>

#include <algorithm>

namespace StickSlip
{
  /**
   * The two convex regularisations of the friction coefficient at V -> 0.
   */
  enum class Regularisation
  {
    /** mu = a max(0, ln(V / Vmin)) */
    truncated,
    /** mu = a asinh(V / (2 Vmin)) */
    arcsinh
  };

  /**
   * Parameters of mu(V, theta) = mu0 + a ln(V/V0) + b ln(V0 theta / L).
   */
  struct RateAndStateParameters
  {
    /** Direct effect a. */
    double a = 0.010;
    /** Evolution effect b. */
    double b = 0.015;
    /** Reference friction coefficient mu0. */
    double reference_friction = 0.6;
    /** Reference slip rate V0, m/s. */
    double reference_slip_rate = 1e-6;
    /** Characteristic slip L, m. */
    double characteristic_slip = 2e-5;
  };

  /**
   * Rate-and-state friction (Ruina 1983) at fixed state, in one of the two
   * forms that are convex in V:
   *
   *   truncated:  mu = a max(0, ln(V/Vmin)),
   *   arcsinh:    mu = a asinh(V / (2 Vmin)).
   *
   * The data of a node is ln(Vmin). Vmin itself is far outside the range of
   * floating point numbers for perfectly ordinary states and is only formed
   * where its under- or overflow does no harm.
   */
  class RateAndStateLaw : public FrictionLaw
  {
  public:
    /**
     * Constructor. Throws unless a, V0 and L are positive and all parameters
     * are finite.
     */
    RateAndStateLaw(const RateAndStateParameters &parameters,
                    const Regularisation          regularisation);

    explicit RateAndStateLaw(const LawValues &values);

    static LawKind
    kind();

    /**
     * Friction without a state, mu0 + a ln(V/V0), as a kind of its own: b is
     * zero.
     */
    static LawKind
    velocity_strengthening_kind();

    /**
     * Data of a node: ln(Vmin / (1 m/s)), where
     *
     *   ln Vmin = ln V0 - (mu0 + b (alpha + ln(V0/L))) / a
     *
     * is the logarithm of the slip rate at which the unregularised law has
     * mu = 0.
     */
    double
    node_data(const double alpha) const override
    {
      return log_vmin_at_zero - parameters.b / parameters.a * alpha;
    }

    double
    coefficient(const double V, const double log_vmin) const override
    {
      return parameters.a * scaled_coefficient(V, log_vmin);
    }

    double
    derivative(const double V, const double log_vmin) const override;

    double
    chord(const double V,
          const double change,
          const double log_vmin) const override;

    double
    potential(const double V, const double log_vmin) const override;

    /**
     * True for the arcsinh form, and for V > Vmin in the truncated one.
     */
    bool
    is_smooth(const double V, const double log_vmin) const override;

    /**
     * Truncated: V = r/c up to Vmin, above it by wright_omega(). Arcsinh:
     * Newton's method in asinh(V / (2 Vmin)), where the equation is convex,
     * from an upper bound that is less than about one too large.
     */
    double
    minimiser(const double c,
              const double r,
              const double k,
              const double log_vmin) const override;

    /**
     * The larger one of a and b.
     */
    double
    rate_scale() const override
    {
      return std::max(parameters.a, parameters.b);
    }

    /**
     * z = mu / a: max(0, ln(V/Vmin)) or asinh(V / (2 Vmin)). Well above Vmin
     * this is the logarithm of the slip rate up to a constant; unlike the
     * logarithm it stays regular at V = 0.
     */
    double
    scaled_coefficient(const double V, const double log_vmin) const;

    const RateAndStateParameters &
    get_parameters() const
    {
      return parameters;
    }

    Regularisation
    get_regularisation() const
    {
      return regularisation;
    }

  private:
    const RateAndStateParameters parameters;
    const Regularisation         regularisation;

    /** ln V0 - (mu0 + b ln(V0/L)) / a: ln Vmin at alpha = 0. */
    const double log_vmin_at_zero;
  };
} // namespace StickSlip

#endif
