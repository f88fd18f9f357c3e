// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/fault_nodes.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  FaultNodes<dim>::FaultNodes(const JumpBasis<dim> &basis,
                              const NodePartition  &partition)
    : first{0}
    , partition(partition)
  {
    for (const FaultContact<dim> &contact : basis.faults())
      first.push_back(first.back() + contact.slave.nodes.size());
    fault_of_node.reserve(first.back());
    nodes.reserve(first.back());
    active.reserve(first.back());
    node_weights.reserve(first.back());
    opening_signs.reserve(first.back());
    for (unsigned int f = 0; f < basis.faults().size(); ++f)
      {
        const FaultContact<dim> &contact = basis.faults()[f];
        for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
          {
            fault_of_node.push_back(f);
            nodes.push_back(contact.slave.nodes[k]);
            active.push_back(contact.coupling.active[k]);
            node_weights.push_back(contact.coupling.weight[k]);
            opening_signs.push_back(contact.opening_sign(k));
          }
      }

    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (active[k] && partition.owned().is_element(nodes[k]))
        contact_positions.push_back(k);
    std::sort(contact_positions.begin(),
              contact_positions.end(),
              [&](const unsigned int k, const unsigned int m) {
                return nodes[k] < nodes[m];
              });
  }



  template <int dim>
  std::vector<double>
  FaultNodes<dim>::at_owned_contact(const std::vector<double> &values) const
  {
    AssertDimension(values.size(), nodes.size());
    std::vector<double> result;
    result.reserve(contact_positions.size());
    for (const unsigned int k : contact_positions)
      result.push_back(values[k]);
    return result;
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
  std::vector<double>
  FaultNodes<dim>::opening_jumps(const NodalVector &w) const
  {
    const std::vector<Tensor<1, dim>> values =
      gather_nodes<dim>(w, partition, nodes);
    std::vector<double> jumps(nodes.size(), 0.);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (active[k])
        jumps[k] = opening_signs[k] * values[k][dim - 1];
    return jumps;
  }



  template <int dim>
  std::vector<double>
  FaultNodes<dim>::over_mean(const std::vector<double> &values) const
  {
    AssertDimension(values.size(), nodes.size());
    std::vector<double> result(nodes.size(), 0.);
    for (unsigned int f = 0; f + 1 < first.size(); ++f)
      {
        double sum = 0, area = 0;
        for (unsigned int k = first[f]; k < first[f + 1]; ++k)
          if (active[k])
            {
              sum += node_weights[k] * values[k];
              area += node_weights[k];
            }
        if (sum > 0.)
          for (unsigned int k = first[f]; k < first[f + 1]; ++k)
            result[k] = values[k] * area / sum;
      }
    return result;
  }



  template class FaultNodes<2>;
  template class FaultNodes<3>;
} // namespace StickSlip
