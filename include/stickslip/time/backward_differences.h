// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_backward_differences_h
#define stickslip_time_backward_differences_h

#include <stickslip/time/time_scheme.h>

namespace StickSlip
{
  /**
   * The backward differentiation formula of second order with steps of any
   * size (Hairer, Noersett and Wanner 1993), for problems without mass. With
   * the mean velocity d0 over the last step, of size tau0, and r = tau / tau0,
   *
   *   u1 = u0 + tau (w0 d0 + w1 v1),   w0 = r / (1 + 2 r),
   *                                    w1 = (1 + r) / (1 + 2 r).
   *
   * The first step takes the trapezoidal rule with the velocity at the start.
   *
   * Of second order and stiffly accurate: what follows the loads at once, as
   * bodies do that neither mass nor viscosity holds back, has the velocity of
   * its displacements. The trapezoidal rule would let that velocity swing about
   * its mean from step to step, for ever.
   */
  template <int dim, int n_components = dim>
  class BackwardDifferences : public TimeScheme<dim, n_components>
  {
  public:
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const override;

    GapPath
    gap_path(const double tau, const double last) const override;

    double
    error_constant(const double tau, const double last) const override;

  protected:
    std::pair<double, double>
    end_weights(const double tau, const double last) const override;

    NodalVector
    known_displacement(const SystemState<dim> &from,
                       const double            tau) const override;
  };
} // namespace StickSlip

#endif
