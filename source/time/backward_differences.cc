// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/backward_differences.h>

namespace StickSlip
{
  namespace BackwardDifferences
  {
    namespace
    {
      /** The displacement changes by tau (of_past d0 + of_end v1). */
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
        return from.mean_velocity.size() > 0 ? from.mean_velocity :
                                               from.velocity;
      }
    } // namespace



    template <int dim>
    std::vector<double>
    operator_coefficients(const SystemState<dim> &from, const double tau)
    {
      return {0., 1., tau * weights(tau, from.last_step).of_end};
    }



    template <int dim>
    NodalVector
    right_hand_side(SpatialProblem<dim>    &problem,
                    const SystemState<dim> &from,
                    const double            tau)
    {
      NodalVector nodal = from.displacement;
      nodal.add(tau * weights(tau, from.last_step).of_past,
                past_velocity(from));
      NodalVector w = problem.make_vector(), product = w;
      problem.to_jumps(w, nodal);
      problem.term(SpatialProblem<dim>::stiffness).vmult(product, w);
      NodalVector rhs = problem.load(from.time + tau);
      rhs -= product;
      return rhs;
    }



    template <int dim>
    void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau)
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



    double
    error_constant(const double tau, const double last)
    {
      return tau * tau * (tau + last) * weights(tau, last).of_end / 6.;
    }



#define STICKSLIP_INSTANTIATE(dim)                                    \
  template std::vector<double> operator_coefficients<dim>(            \
    const SystemState<dim> &, const double);                          \
  template NodalVector right_hand_side<dim>(SpatialProblem<dim> &,    \
                                            const SystemState<dim> &, \
                                            const double);            \
  template void        complete<dim>(SystemState<dim> &,              \
                              const SystemState<dim> &,        \
                              const double);

    STICKSLIP_INSTANTIATE(2)
    STICKSLIP_INSTANTIATE(3)
  } // namespace BackwardDifferences
} // namespace StickSlip
