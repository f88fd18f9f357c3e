// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/newmark.h>

namespace StickSlip
{
  namespace Newmark
  {
    std::vector<double>
    operator_coefficients(const double tau)
    {
      return {2. / tau, 1., tau / 2.};
    }



    template <int dim>
    NodalVector
    right_hand_side(SpatialProblem<dim>    &problem,
                    const SystemState<dim> &from,
                    const double            tau)
    {
      NodalVector nodal = from.velocity, w = problem.make_vector(), product = w;
      NodalVector rhs = problem.load(from.time + tau);

      nodal.sadd(2. / tau, 1., from.acceleration);
      problem.to_jumps(w, nodal);
      problem.term(SpatialProblem<dim>::mass).vmult(product, w);
      rhs += product;

      nodal = from.displacement;
      nodal.add(tau / 2., from.velocity);
      problem.to_jumps(w, nodal);
      problem.term(SpatialProblem<dim>::stiffness).vmult(product, w);
      rhs -= product;
      return rhs;
    }



    template <int dim>
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau)
    {
      to.displacement = from.displacement;
      to.displacement.add(tau / 2., from.velocity, tau / 2., to.velocity);
      to.acceleration = from.acceleration;
      to.acceleration *= -1.;
      to.acceleration.add(2. / tau, to.velocity, -2. / tau, from.velocity);
    }



#define STICKSLIP_INSTANTIATE(dim)                                    \
  template NodalVector right_hand_side<dim>(SpatialProblem<dim> &,    \
                                            const SystemState<dim> &, \
                                            const double);            \
  template void        complete<dim>(SystemState<dim> &,              \
                              const SystemState<dim> &,        \
                              const double);

    STICKSLIP_INSTANTIATE(2)
    STICKSLIP_INSTANTIATE(3)
  } // namespace Newmark
} // namespace StickSlip
