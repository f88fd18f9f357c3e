// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/contact_implicit.h>

namespace StickSlip
{
  namespace
  {
    /** Owned entries only: those of the force may have other ghosts. */
    void
    add_owned(NodalVector &sum, const double factor, const NodalVector &vector)
    {
      for (unsigned int i = 0; i < sum.locally_owned_size(); ++i)
        sum.local_element(i) += factor * vector.local_element(i);
    }
  } // namespace



  template <int dim, int n_components>
  NodalVector
  ContactImplicit<dim, n_components>::start_force(
    SpatialProblem<dim, n_components> &problem,
    const SystemState<dim>            &from) const
  {
    using Problem = SpatialProblem<dim, n_components>;
    if (from.force.size() > 0)
      {
        NodalVector force = problem.make_vector();
        add_owned(force, 1., from.force);
        return force;
      }

    NodalVector force = problem.load(from.time), w = problem.make_vector(),
                product = w;
    if (problem.has(Problem::damping))
      {
        problem.to_jumps(w, from.velocity);
        problem.term(Problem::damping).vmult(product, w);
        force -= product;
      }
    problem.to_jumps(w, from.displacement);
    problem.term(Problem::stiffness).vmult(product, w);
    force -= product;
    for (const unsigned int k : faults.owned_contact())
      {
        const Tensor<1, dim - 1> traction =
          shear_traction(faults, laws, from, k);
        for (unsigned int d = 0; d < dim - 1; ++d)
          force.local_element(faults.node(k) * n_components + d) -=
            faults.weights()[k] * traction[d];
      }
    return force;
  }



  template <int dim, int n_components>
  NodalVector
  ContactImplicit<dim, n_components>::right_hand_side(
    SpatialProblem<dim, n_components> &problem,
    const SystemState<dim>            &from,
    const double                       tau) const
  {
    NodalVector rhs =
      Newmark<dim, n_components>::right_hand_side(problem, from, tau);
    rhs += start_force(problem, from);
    return rhs;
  }



  template <int dim, int n_components>
  NodalVector
  ContactImplicit<dim, n_components>::known_acceleration(
    const SystemState<dim> &from,
    const double            tau) const
  {
    NodalVector a = from.velocity;
    a *= 2. / tau;
    return a;
  }



  template <int dim, int n_components>
  void
  ContactImplicit<dim, n_components>::complete(SystemState<dim>       &to,
                                               const SystemState<dim> &from,
                                               const double tau) const
  {
    Newmark<dim, n_components>::complete(to, from, tau);
    to.last_step    = tau;
    to.acceleration = to.velocity;
    to.acceleration -= from.velocity;
    to.acceleration /= tau;
  }



  template <int dim, int n_components>
  void
  ContactImplicit<dim, n_components>::set_end_force(
    SystemState<dim>                  &to,
    const SystemState<dim>            &from,
    const double                       tau,
    SpatialProblem<dim, n_components> &problem,
    const NodalVector                 &w,
    const NodalVector                 &w_stopped,
    const NodalVector                 &reaction) const
  {
    using Problem      = SpatialProblem<dim, n_components>;
    NodalVector change = problem.make_vector(), product = change;
    problem.to_jumps(change, from.velocity);
    change.sadd(-1., 1., w);
    problem.term(Problem::mass).vmult(product, change);
    to.force = product;
    to.force *= 2. / tau;
    add_owned(to.force, -1., start_force(problem, from));
    add_owned(to.force, -1., reaction);
    if (problem.has(Problem::damping))
      {
        change = w;
        change -= w_stopped;
        if (change.linfty_norm() > 0.)
          {
            problem.term(Problem::damping).vmult(product, change);
            to.force += product;
          }
      }
  }



  template class ContactImplicit<2>;
  template class ContactImplicit<3>;
  template class ContactImplicit<2, 1>;
} // namespace StickSlip
