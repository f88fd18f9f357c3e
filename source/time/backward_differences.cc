// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/backward_differences.h>

namespace StickSlip
{
  namespace
  {
    /** w0 and w1. */
    struct Weights
    {
      double of_past, of_end;
    };



    /** @p last: size of the last step, zero if there was none. */
    Weights
    weights(const double tau, const double last)
    {
      return {tau / (last + 2. * tau), (last + tau) / (last + 2. * tau)};
    }



    /** d0, or the velocity at the start. */
    template <int dim>
    const NodalVector &
    past_velocity(const SystemState<dim> &from)
    {
      return from.mean_velocity.size() > 0 ? from.mean_velocity : from.velocity;
    }
  } // namespace



  template <int dim, int n_components>
  void
  BackwardDifferences<dim, n_components>::complete(SystemState<dim>       &to,
                                                   const SystemState<dim> &from,
                                                   const double tau) const
  {
    const Weights w  = weights(tau, from.last_step);
    to.last_step     = tau;
    to.mean_velocity = past_velocity(from);
    to.mean_velocity.sadd(w.of_past, w.of_end, to.velocity);
    to.displacement = from.displacement;
    to.displacement.add(tau, to.mean_velocity);

    to.mean_slip_rate =
      from.mean_slip_rate.empty() ? from.slip_rate : from.mean_slip_rate;
    to.slip = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      {
        to.mean_slip_rate[k] =
          w.of_past * to.mean_slip_rate[k] + w.of_end * to.slip_rate[k];
        to.slip[k] += tau * to.mean_slip_rate[k];
      }
  }



  template <int dim, int n_components>
  GapPath
  BackwardDifferences<dim, n_components>::gap_path(const double tau,
                                                   const double last) const
  {
    const Weights w = weights(tau, last);
    return {tau * w.of_past, tau * w.of_end, 1.};
  }



  template <int dim, int n_components>
  double
  BackwardDifferences<dim, n_components>::error_constant(
    const double tau,
    const double last) const
  {
    return tau * tau * (tau + last) * weights(tau, last).of_end / 6.;
  }



  template <int dim, int n_components>
  std::pair<double, double>
  BackwardDifferences<dim, n_components>::end_weights(const double tau,
                                                      const double last) const
  {
    return {0., tau * weights(tau, last).of_end};
  }



  template <int dim, int n_components>
  NodalVector
  BackwardDifferences<dim, n_components>::known_displacement(
    const SystemState<dim> &from,
    const double            tau) const
  {
    NodalVector u = from.displacement;
    u.add(tau * weights(tau, from.last_step).of_past, past_velocity(from));
    return u;
  }



  template class BackwardDifferences<2>;
  template class BackwardDifferences<3>;
  template class BackwardDifferences<2, 1>;
} // namespace StickSlip
