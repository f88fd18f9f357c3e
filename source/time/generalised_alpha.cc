// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/generalised_alpha.h>

namespace StickSlip
{
  namespace
  {
    /** At the start of a run the two accelerations are the same. */
    template <int dim>
    const NodalVector &
    auxiliary_acceleration(const SystemState<dim> &state)
    {
      return state.auxiliary_acceleration.size() > 0 ?
               state.auxiliary_acceleration :
               state.acceleration;
    }
  } // namespace



  GeneralisedAlpha::GeneralisedAlpha(const double spectral_radius)
    : alpha_m((2. * spectral_radius - 1.) / (spectral_radius + 1.))
    , alpha_f(spectral_radius / (spectral_radius + 1.))
    , gamma(0.5 - alpha_m + alpha_f)
    , beta(0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f))
  {}



  std::vector<double>
  GeneralisedAlpha::operator_coefficients(const double tau) const
  {
    return {(1. - alpha_m) / ((1. - alpha_f) * gamma * tau),
            1.,
            tau * beta / gamma};
  }



  template <int dim>
  NodalVector
  GeneralisedAlpha::right_hand_side(SpatialProblem<dim>    &problem,
                                    const SystemState<dim> &from,
                                    const double            tau) const
  {
    NodalVector nodal = from.velocity, w = problem.make_vector(), product = w;
    NodalVector rhs            = problem.load(from.time + tau);
    const NodalVector &a       = auxiliary_acceleration(from);
    const double       of_mass = operator_coefficients(tau)[0];

    nodal *= of_mass;
    nodal.add(((1. - alpha_m) * (1. - gamma) / gamma - alpha_m) /
                (1. - alpha_f),
              a,
              alpha_f / (1. - alpha_f),
              from.acceleration);
    problem.to_jumps(w, nodal);
    problem.term(SpatialProblem<dim>::mass).vmult(product, w);
    rhs += product;

    nodal = from.displacement;
    nodal.add(tau * (1. - beta / gamma),
              from.velocity,
              tau * tau * (0.5 - beta / gamma),
              a);
    problem.to_jumps(w, nodal);
    problem.term(SpatialProblem<dim>::stiffness).vmult(product, w);
    rhs -= product;
    return rhs;
  }



  template <int dim>
  void
  GeneralisedAlpha::complete(SystemState<dim>       &to,
                             const SystemState<dim> &from,
                             const double            tau) const
  {
    const NodalVector &a0 = auxiliary_acceleration(from);
    NodalVector        a1 = a0;
    a1 *= -(1. - gamma) / gamma;
    a1.add(1. / (gamma * tau), to.velocity, -1. / (gamma * tau), from.velocity);

    to.displacement = from.displacement;
    to.displacement.add(tau, from.velocity);
    to.displacement.add(tau * tau * (0.5 - beta), a0, tau * tau * beta, a1);

    to.acceleration = from.acceleration;
    to.acceleration *= -alpha_f / (1. - alpha_f);
    to.acceleration.add((1. - alpha_m) / (1. - alpha_f),
                        a1,
                        alpha_m / (1. - alpha_f),
                        a0);
    to.auxiliary_acceleration = a1;
  }



#define STICKSLIP_INSTANTIATE(dim)                                        \
  template NodalVector GeneralisedAlpha::right_hand_side<dim>(            \
    SpatialProblem<dim> &, const SystemState<dim> &, const double) const; \
  template void GeneralisedAlpha::complete<dim>(SystemState<dim> &,       \
                                                const SystemState<dim> &, \
                                                const double) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
