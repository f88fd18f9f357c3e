// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/fault_snapshots.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  std::vector<FaultSnapshot<dim>>
  make_fault_snapshots(const SystemState<dim>                &state,
                       const FaultNodes<dim>                 &nodes,
                       const std::vector<Tensor<1, dim - 1>> &tractions,
                       const JumpBasis<dim>                  &basis,
                       const std::vector<std::string>        &names,
                       const std::vector<bool>               &may_open)
  {
    std::vector<FaultSnapshot<dim>> snapshots(names.size());
    for (unsigned int f = 0; f < names.size(); ++f)
      {
        FaultSnapshot<dim>      &snapshot = snapshots[f];
        const FaultContact<dim> &contact  = basis.faults()[f];
        const double             sign     = contact.sides.sign();
        snapshot.name                     = names[f];
        snapshot.points                   = contact.slave.points;
        snapshot.weights                  = contact.coupling.weight;
        const unsigned int n_nodes =
          nodes.first_of_fault()[f + 1] - nodes.first_of_fault()[f];
        snapshot.slip.reserve(n_nodes);
        snapshot.slip_rate.reserve(n_nodes);
        snapshot.shear_traction.reserve(n_nodes);
        snapshot.normal_stress.reserve(n_nodes);
        snapshot.state.reserve(n_nodes);
        for (unsigned int k = nodes.first_of_fault()[f];
             k < nodes.first_of_fault()[f + 1];
             ++k)
          {
            const double normal_stress =
              nodes.in_contact(k) ? state.normal_stress[k] : 0.;
            snapshot.slip.push_back(sign * state.slip[k]);
            snapshot.slip_rate.push_back(sign * state.slip_rate[k]);
            snapshot.normal_stress.push_back(normal_stress);
            snapshot.state.push_back(std::exp(state.alpha[k]));
            if (!state.contact_pressure.empty())
              snapshot.contact_pressure.push_back(
                nodes.in_contact(k) ? state.contact_pressure[k] : 0.);
            if (!state.gap.empty() && (may_open.empty() || may_open[f]))
              {
                const bool in_contact = nodes.in_contact(k);
                snapshot.gap.push_back(in_contact ? state.gap[k] : 0.);
                snapshot.opening_rate.push_back(
                  in_contact ? state.opening_rate[k] : 0.);
                snapshot.is_bonded.push_back(state.is_bonded[k]);
              }
            snapshot.shear_traction.push_back(sign * tractions[k]);
          }
      }
    return snapshots;
  }



  template decltype(make_fault_snapshots<2>) make_fault_snapshots<2>;
  template decltype(make_fault_snapshots<3>) make_fault_snapshots<3>;
} // namespace StickSlip
