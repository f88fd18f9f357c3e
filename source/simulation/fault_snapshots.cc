// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/simulation/fault_snapshots.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  std::vector<FaultSnapshot<dim>>
  make_fault_snapshots(const SystemState<dim>         &state,
                       const FaultNodes<dim>          &nodes,
                       const JumpBasis<dim>           &basis,
                       const std::vector<std::string> &names)
  {
    std::vector<FaultSnapshot<dim>> snapshots(names.size());
    for (unsigned int f = 0; f < names.size(); ++f)
      {
        FaultSnapshot<dim>      &snapshot = snapshots[f];
        const FaultContact<dim> &contact  = basis.faults()[f];
        const double             sign     = contact.sides.sign();
        snapshot.name                     = names[f];
        snapshot.points                   = contact.slave_surface.points;
        snapshot.weights                  = contact.coupling.weight;
        for (unsigned int k = nodes.first_of_fault()[f];
             k < nodes.first_of_fault()[f + 1];
             ++k)
          {
            const double normal_stress =
              nodes.in_contact(k) ? nodes.normal_stress()[k] : 0.;
            snapshot.slip.push_back(sign * state.slip[k]);
            snapshot.slip_rate.push_back(sign * state.slip_rate[k]);
            snapshot.normal_stress.push_back(normal_stress);
            snapshot.state.push_back(std::exp(state.alpha[k]));
            if (!state.contact_pressure.empty())
              snapshot.contact_pressure.push_back(
                nodes.in_contact(k) ? state.contact_pressure[k] : 0.);
            snapshot.shear_traction.push_back(sign *
                                              shear_traction(nodes, state, k));
          }
      }
    return snapshots;
  }



  template <int dim>
  double
  largest_slip_rate(const SystemState<dim> &state)
  {
    double largest = 0;
    for (const auto &rate : state.slip_rate)
      largest = std::max(largest, magnitude(rate));
    return largest;
  }



  template <int dim>
  double
  largest_slip(const SystemState<dim>                &state,
               const std::vector<Tensor<1, dim - 1>> &since)
  {
    double largest = 0;
    for (unsigned int k = 0; k < since.size(); ++k)
      largest = std::max(largest, (state.slip[k] - since[k]).norm());
    return largest;
  }



#define STICKSLIP_INSTANTIATE(dim)                                    \
  template std::vector<FaultSnapshot<dim>> make_fault_snapshots<dim>( \
    const SystemState<dim> &,                                         \
    const FaultNodes<dim> &,                                          \
    const JumpBasis<dim> &,                                           \
    const std::vector<std::string> &);                                \
  template double largest_slip_rate<dim>(const SystemState<dim> &);   \
  template double largest_slip<dim>(const SystemState<dim> &,         \
                                    const std::vector<Tensor<1, dim - 1>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
