// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_newmark_h
#define stickslip_time_newmark_h

#include <stickslip/time/time_scheme.h>

namespace StickSlip
{
  /**
   * Newmark's method with beta = 1/4, gamma = 1/2:
   *
   *   u1 = u0 + tau/2 (v0 + v1),   v1' = 2/tau (v1 - v0) - v0'.
   *
   * Second order, without numerical damping (Newmark 1959; Hairer, Lubich and
   * Wanner 2006).
   */
  template <int dim, int n_components = dim>
  class Newmark : public TimeScheme<dim, n_components>
  {
  public:
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const override;

    GapPath
    gap_path(const double tau, const double) const override
    {
      return {tau / 2., tau / 2., 1.};
    }

    /** Constant of the trapezoidal rule, tau^3/12. */
    double
    error_constant(const double tau, const double) const override
    {
      return tau * tau * tau / 12.;
    }

  protected:
    std::pair<double, double>
    end_weights(const double tau, const double) const override
    {
      return {2. / tau, tau / 2.};
    }

    NodalVector
    known_displacement(const SystemState<dim> &from,
                       const double            tau) const override;

    NodalVector
    known_acceleration(const SystemState<dim> &from,
                       const double            tau) const override;
  };
} // namespace StickSlip

#endif
