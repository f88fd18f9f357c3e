// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/contact_change.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    void
    change_rates(NodalVector                     &velocity,
                 std::vector<Tensor<1, dim - 1>> &slip_rate,
                 const ContactSpace<dim>         &space,
                 const FaultNodes<dim>           &before,
                 const FaultNodes<dim>           &now)
    {
      NodalVector w = space.make_vector();
      space.to_jumps(w, velocity);
      for (const unsigned int k : now.owned_contact())
        {
          w.local_element(now.node(k) * dim + dim - 1) = 0.;
          if (before.in_contact(k))
            for (unsigned int d = 0; d < dim - 1; ++d)
              w.local_element(now.node(k) * dim + d) = slip_rate[k][d];
        }
      space.to_nodal(velocity, w);
      slip_rate = now.tangential_jumps(w);
    }
  } // namespace



  template <int dim>
  bool
  has_slid(const JumpBasis<dim>                  &basis,
           const std::vector<Tensor<1, dim - 1>> &slip,
           const std::vector<Tensor<1, dim - 1>> &since,
           const double                           fraction)
  {
    double smallest_face = std::numeric_limits<double>::max();
    for (const FaultContact<dim> &contact : basis.faults())
      smallest_face = std::min(smallest_face, contact.smallest_face);
    double largest = 0;
    for (unsigned int k = 0; k < since.size(); ++k)
      largest = std::max(largest, (slip[k] - since[k]).norm());
    return largest > fraction * smallest_face;
  }



  template <int dim>
  void
  change_contact(SystemState<dim>        &state,
                 const ContactSpace<dim> &space,
                 const FaultNodes<dim>   &before,
                 const FaultNodes<dim>   &now)
  {
    change_rates(state.velocity, state.slip_rate, space, before, now);
    if (state.mean_velocity.size() > 0)
      change_rates(
        state.mean_velocity, state.mean_slip_rate, space, before, now);
    // Tractions of nodes off contact mean nothing any more.
    for (unsigned int k = 0; k < state.balancing_traction.size(); ++k)
      if (!now.in_contact(k))
        state.balancing_traction[k] = Tensor<1, dim - 1>();
  }



  template decltype(has_slid<2>)       has_slid<2>;
  template decltype(has_slid<3>)       has_slid<3>;
  template decltype(change_contact<2>) change_contact<2>;
  template decltype(change_contact<3>) change_contact<3>;
} // namespace StickSlip
