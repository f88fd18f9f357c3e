// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_friction_law_h
#define stickslip_friction_friction_law_h

namespace StickSlip
{
  /**
   * A pointwise friction law: the friction coefficient mu as a function of the
   * slip rate V >= 0 (m/s), nondecreasing, so that its integral
   *
   *   Phi(V) = int_0^V mu(s) ds
   *
   * is convex. A law may also depend on the state alpha = ln(theta / 1 s) of
   * the place where it acts. That dependence goes through one number per node,
   * node_data(), which is computed once whenever the state changes and handed
   * to all other functions. A law without state ignores it.
   *
   * A law with mu(0) > 0 (a threshold, as Coulomb's) is meant to return that
   * value as coefficient(0, data): it is the one-sided derivative of Phi.
   *
   * A new law has to say coefficient(), derivative() and potential(); all other
   * functions have an answer that fits laws without state. doc/adding_a_law.md
   * shows what else it takes.
   */
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /**
     * Number that the law needs to know of a node with state alpha; zero
     * unless a law says something else.
     */
    virtual double
    node_data(const double) const
    {
      return 0.;
    }

    /**
     * The friction coefficient mu(V), dimensionless; at V = 0 the limit from
     * above.
     */
    virtual double
    coefficient(const double V, const double data) const = 0;

    /**
     * d mu / dV, s/m. Infinity where it exceeds the largest number.
     */
    virtual double
    derivative(const double V, const double data) const = 0;

    /**
     * The slope of the chord of mu between V and the slip rate at which mu has
     * changed by the second argument, or where it has fallen to mu(0) if that
     * comes first, s/m. Tends to the derivative for small changes, which is
     * what is returned where a law has nothing better to say.
     */
    virtual double
    chord(const double V, const double, const double data) const
    {
      return derivative(V, data);
    }

    /**
     * Phi(V), m/s.
     */
    virtual double
    potential(const double V, const double data) const = 0;

    /**
     * True if v -> Phi(|v|) is twice differentiable in a neighbourhood of
     * |v| = V: everywhere but at V = 0 of a law with a threshold, unless a law
     * says something else.
     */
    virtual bool
    is_smooth(const double V, const double data) const
    {
      return V > 0. || coefficient(0., data) == 0.;
    }

    /**
     * The minimiser V >= 0 of
     *
     *   1/2 c V^2 - r V + k Phi(V),   c > 0, r >= 0, k >= 0,
     *
     * exact up to rounding. Problems with other signs or in several
     * dimensions are reduced to this one, see local_problem.h.
     *
     * Newton's method between bounds that close in on the minimiser, unless a
     * law knows a faster way.
     */
    virtual double
    minimiser(const double c,
              const double r,
              const double k,
              const double data) const;

    /**
     * Change of mu, about, where the slip rate changes by a factor of e: the
     * measure of an error of mu for the control of the step size. Zero,
     * the answer unless a law says something else, where mu tells nothing of
     * the slip rate; errors then are those of the slip rate alone.
     */
    virtual double
    rate_scale() const
    {
      return 0.;
    }
  };
} // namespace StickSlip

#endif
