// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/output/contact_states.h>

namespace StickSlip
{
  template <int dim>
  std::vector<ContactState>
  contact_states(const FaultSnapshot<dim> &fault, const double slip_rate)
  {
    AssertDimension(fault.is_bonded.size(), fault.gap.size());
    std::vector<ContactState> states;
    states.reserve(fault.gap.size());
    for (unsigned int p = 0; p < fault.gap.size(); ++p)
      if (!(fault.weights[p] > 0) || fault.gap[p] > 0)
        states.push_back(ContactState::open);
      else if (fault.is_bonded[p])
        states.push_back(ContactState::bonded);
      else
        states.push_back(magnitude(fault.slip_rate[p]) > slip_rate ?
                           ContactState::slipping :
                           ContactState::stuck);
    return states;
  }



  template decltype(contact_states<2>) contact_states<2>;
  template decltype(contact_states<3>) contact_states<3>;
} // namespace StickSlip
