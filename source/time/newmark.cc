// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/newmark.h>

namespace StickSlip
{
  template <int dim, int n_components>
  void
  Newmark<dim, n_components>::complete(SystemState<dim>       &to,
                                       const SystemState<dim> &from,
                                       const double            tau) const
  {
    NodalVector u = known_displacement(from, tau);
    u.add(tau / 2., to.velocity);
    NodalVector a = from.acceleration;
    a *= -1.;
    a.add(2. / tau, to.velocity, -2. / tau, from.velocity);
    // To assign to vectors without a partition takes messages.
    to.displacement.swap(u);
    to.acceleration.swap(a);
    to.slip = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau / 2. * (from.slip_rate[k] + to.slip_rate[k]);
  }



  template <int dim, int n_components>
  NodalVector
  Newmark<dim, n_components>::known_displacement(const SystemState<dim> &from,
                                                 const double tau) const
  {
    NodalVector u = from.displacement;
    u.add(tau / 2., from.velocity);
    return u;
  }



  template <int dim, int n_components>
  NodalVector
  Newmark<dim, n_components>::known_acceleration(const SystemState<dim> &from,
                                                 const double tau) const
  {
    NodalVector a = from.velocity;
    a.sadd(2. / tau, 1., from.acceleration);
    return a;
  }



  template class Newmark<2>;
  template class Newmark<3>;
  template class Newmark<2, 1>;
} // namespace StickSlip
