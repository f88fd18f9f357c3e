// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/time_scheme.h>

namespace StickSlip
{
  template <int dim>
  std::vector<double>
  TimeScheme<dim>::operator_coefficients(const double tau,
                                         const double last) const
  {
    const auto [of_mass, of_stiffness] = end_weights(tau, last);
    return {of_mass, 1., of_stiffness};
  }



  template <int dim>
  NodalVector
  TimeScheme<dim>::right_hand_side(SpatialProblem<dim>    &problem,
                                   const SystemState<dim> &from,
                                   const double            tau) const
  {
    using Problem   = SpatialProblem<dim>;
    NodalVector rhs = problem.load(from.time + tau), w = problem.make_vector(),
                product = w;
    if (problem.has(Problem::mass))
      {
        problem.to_jumps(w, known_acceleration(from, tau));
        problem.term(Problem::mass).vmult(product, w);
        rhs += product;
      }
    problem.to_jumps(w, known_displacement(from, tau));
    problem.term(Problem::stiffness).vmult(product, w);
    rhs -= product;
    return rhs;
  }



  template <int dim>
  NodalVector
  TimeScheme<dim>::known_acceleration(const SystemState<dim> &from,
                                      const double) const
  {
    NodalVector zero = from.velocity;
    zero             = 0.;
    return zero;
  }



  template class TimeScheme<2>;
  template class TimeScheme<3>;
} // namespace StickSlip
