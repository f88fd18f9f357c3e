// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/fault_functional.h>

namespace StickSlip
{
  template <int dim, int n_components>
  std::unique_ptr<FaultFriction<n_components>>
  make_fault_friction(const FaultNodes<dim>     &nodes,
                      const NodeLaws            &laws,
                      const std::vector<double> &normal_stress)
  {
    AssertDimension(laws.of_node.size(), nodes.size());
    std::vector<unsigned int>                       term_nodes, law_indices;
    std::vector<double>                             damping;
    std::vector<std::shared_ptr<const FrictionLaw>> friction_laws;
    for (const unsigned int k : nodes.owned_contact())
      {
        term_nodes.push_back(nodes.node(k));
        law_indices.push_back(laws.of_node[k]);
        damping.push_back(laws[k].radiation_damping);
      }
    for (const FaultLaw &law : laws.laws)
      friction_laws.push_back(law.friction);
    auto functional = std::make_unique<FaultFriction<n_components>>(
      term_nodes,
      nodes.at_owned_contact(nodes.weights()),
      nodes.at_owned_contact(normal_stress),
      friction_laws,
      law_indices);
    functional->set_damping(damping);
    return functional;
  }



  template decltype(make_fault_friction<2>)    make_fault_friction<2>;
  template decltype(make_fault_friction<3>)    make_fault_friction<3>;
  template decltype(make_fault_friction<2, 1>) make_fault_friction<2, 1>;
} // namespace StickSlip
