// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/contact_implicit.h>

namespace StickSlip
{
  template <int dim>
  NodalVector
  ContactImplicit<dim>::right_hand_side(SpatialProblem<dim>    &problem,
                                        const SystemState<dim> &from,
                                        const double            tau) const
  {
    using Problem   = SpatialProblem<dim>;
    NodalVector rhs = problem.load(from.time + tau), w = problem.make_vector(),
                product = w;
    rhs += problem.load(from.time);

    problem.to_jumps(w, from.velocity);
    problem.term(Problem::mass).vmult(product, w);
    rhs.add(2. / tau, product);
    if (problem.has(Problem::damping))
      {
        problem.term(Problem::damping).vmult(product, w);
        rhs -= product;
      }

    // K u at both ends, of the later one what is known.
    NodalVector u = from.displacement;
    u.sadd(2., tau / 2., from.velocity);
    problem.to_jumps(w, u);
    problem.term(Problem::stiffness).vmult(product, w);
    rhs -= product;

    for (const unsigned int k : faults.owned_contact())
      {
        const Tensor<1, dim - 1> traction =
          shear_traction(faults, laws, from, k);
        for (unsigned int d = 0; d < dim - 1; ++d)
          rhs.local_element(faults.node(k) * dim + d) -=
            faults.weights()[k] * traction[d];
      }
    return rhs;
  }



  template <int dim>
  void
  ContactImplicit<dim>::complete(SystemState<dim>       &to,
                                 const SystemState<dim> &from,
                                 const double            tau) const
  {
    Newmark<dim>::complete(to, from, tau);
    to.last_step    = tau;
    to.acceleration = to.velocity;
    to.acceleration -= from.velocity;
    to.acceleration /= tau;
  }



  template class ContactImplicit<2>;
  template class ContactImplicit<3>;
} // namespace StickSlip
