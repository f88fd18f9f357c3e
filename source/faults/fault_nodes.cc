// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/fault_nodes.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  FaultNodes<dim>::FaultNodes(const JumpBasis<dim>      &basis,
                              const NodePartition       &partition,
                              const NodeLaws            &laws,
                              const std::vector<double> &normal_stress)
    : node_laws(laws)
    , first{0}
    , partition(partition)
    , stresses(normal_stress)
  {
    for (unsigned int f = 0; f < basis.faults().size(); ++f)
      {
        const FaultContact<dim> &contact = basis.faults()[f];
        for (unsigned int k = 0; k < contact.slave_nodes.size(); ++k)
          {
            fault_of_node.push_back(f);
            nodes.push_back(contact.slave_nodes[k]);
            active.push_back(contact.coupling.active[k]);
            node_weights.push_back(contact.coupling.weight[k]);
          }
        first.push_back(nodes.size());
      }
    AssertDimension(normal_stress.size(), nodes.size());
    AssertDimension(laws.of_node.size(), nodes.size());

    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (active[k] && partition.owned().is_element(nodes[k]))
        contact_positions.push_back(k);
    std::sort(contact_positions.begin(),
              contact_positions.end(),
              [&](const unsigned int k, const unsigned int m) {
                return nodes[k] < nodes[m];
              });

    set_relative_stresses();
    std::vector<unsigned int>                       term_nodes, law_indices;
    std::vector<double>                             term_weights, term_stresses;
    std::vector<std::shared_ptr<const FrictionLaw>> friction_laws;
    for (const unsigned int k : contact_positions)
      {
        term_nodes.push_back(node(k));
        law_indices.push_back(laws.of_node[k]);
        term_weights.push_back(node_weights[k]);
        term_stresses.push_back(stresses[k]);
      }
    for (const FaultLaw &law : laws.laws)
      friction_laws.push_back(law.friction);
    functional = std::make_unique<FaultFriction<dim>>(
      term_nodes, term_weights, term_stresses, friction_laws, law_indices);
    std::vector<double> damping;
    for (const unsigned int k : contact_positions)
      damping.push_back(law(k).radiation_damping);
    functional->set_damping(damping);
  }



  template <int dim>
  unsigned int
  FaultNodes<dim>::size() const
  {
    return nodes.size();
  }



  template <int dim>
  const std::vector<unsigned int> &
  FaultNodes<dim>::first_of_fault() const
  {
    return first;
  }



  template <int dim>
  unsigned int
  FaultNodes<dim>::fault(const unsigned int k) const
  {
    return fault_of_node[k];
  }



  template <int dim>
  const FaultLaw &
  FaultNodes<dim>::law(const unsigned int k) const
  {
    return node_laws.laws[node_laws.of_node[k]];
  }



  template <int dim>
  const NodeLaws &
  FaultNodes<dim>::laws() const
  {
    return node_laws;
  }



  template <int dim>
  unsigned int
  FaultNodes<dim>::node(const unsigned int k) const
  {
    return partition.local_index(nodes[k]);
  }



  template <int dim>
  bool
  FaultNodes<dim>::in_contact(const unsigned int k) const
  {
    return active[k];
  }



  template <int dim>
  const std::vector<double> &
  FaultNodes<dim>::weights() const
  {
    return node_weights;
  }



  template <int dim>
  const std::vector<double> &
  FaultNodes<dim>::normal_stress() const
  {
    return stresses;
  }



  template <int dim>
  const std::vector<double> &
  FaultNodes<dim>::relative_normal_stress() const
  {
    return relative_stresses;
  }



  template <int dim>
  const std::vector<unsigned int> &
  FaultNodes<dim>::owned_contact() const
  {
    return contact_positions;
  }



  template <int dim>
  FaultFriction<dim> &
  FaultNodes<dim>::friction()
  {
    return *functional;
  }



  template <int dim>
  const FaultFriction<dim> &
  FaultNodes<dim>::friction() const
  {
    return *functional;
  }



  template <int dim>
  void
  FaultNodes<dim>::set_relative_stresses()
  {
    relative_stresses.assign(nodes.size(), 0.);
    for (unsigned int f = 0; f + 1 < first.size(); ++f)
      {
        double force = 0, area = 0;
        for (unsigned int k = first[f]; k < first[f + 1]; ++k)
          if (active[k])
            {
              force += node_weights[k] * stresses[k];
              area += node_weights[k];
            }
        if (force > 0.)
          for (unsigned int k = first[f]; k < first[f + 1]; ++k)
            relative_stresses[k] = stresses[k] * area / force;
      }
  }



  template <int dim>
  void
  FaultNodes<dim>::set_normal_stress(const std::vector<double> &normal_stress)
  {
    AssertDimension(normal_stress.size(), nodes.size());
    stresses = normal_stress;
    set_relative_stresses();
    std::vector<double> of_terms;
    of_terms.reserve(contact_positions.size());
    for (const unsigned int k : contact_positions)
      of_terms.push_back(stresses[k]);
    functional->set_normal_stresses(of_terms);
  }



  template <int dim>
  void
  FaultNodes<dim>::set_state(const std::vector<double> &alpha)
  {
    AssertDimension(alpha.size(), nodes.size());
    std::vector<double> of_terms;
    of_terms.reserve(contact_positions.size());
    for (const unsigned int k : contact_positions)
      of_terms.push_back(alpha[k]);
    functional->set_state(of_terms);
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  FaultNodes<dim>::tangential_jumps(const NodalVector &w) const
  {
    const std::vector<Tensor<1, dim>> values =
      gather_nodes<dim>(w, partition, nodes);
    std::vector<Tensor<1, dim - 1>> jumps(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (active[k])
        for (unsigned int d = 0; d < dim - 1; ++d)
          jumps[k][d] = values[k][d];
    return jumps;
  }



  template <int dim>
  double
  FaultNodes<dim>::l2_norm(const std::vector<double> &values) const
  {
    double sum = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (active[k])
        sum += node_weights[k] * values[k] * values[k];
    return std::sqrt(sum);
  }



  template class FaultNodes<2>;
  template class FaultNodes<3>;
} // namespace StickSlip
