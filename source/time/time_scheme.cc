// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/time_scheme.h>

namespace StickSlip
{
  template <int dim, int n_components>
  std::vector<double>
  TimeScheme<dim, n_components>::operator_coefficients(const double tau,
                                                       const double last) const
  {
    const auto [of_mass, of_stiffness] = end_weights(tau, last);
    return {of_mass, 1., of_stiffness};
  }



  template <int dim, int n_components>
  NodalVector
  TimeScheme<dim, n_components>::right_hand_side(
    SpatialProblem<dim, n_components> &problem,
    const SystemState<dim>            &from,
    const double                       tau) const
  {
    using Problem   = SpatialProblem<dim, n_components>;
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



  template <int dim, int n_components>
  NodalVector
  TimeScheme<dim, n_components>::known_acceleration(
    const SystemState<dim> &from,
    const double) const
  {
    NodalVector zero = from.velocity;
    zero             = 0.;
    return zero;
  }



  template class TimeScheme<2>;
  template class TimeScheme<3>;
  template class TimeScheme<2, 1>;
} // namespace StickSlip
