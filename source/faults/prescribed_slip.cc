// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/prescribed_slip.h>
#include <stickslip/mechanics/boundary_condition.h>

#include <algorithm>
#include <map>

namespace StickSlip
{
  template <int dim>
  PrescribedSlip<dim>::PrescribedSlip(const MeshHierarchy<dim>          &meshes,
                                      const std::vector<FaultSides>     &sides,
                                      const std::vector<SlipRates<dim>> &rates)
  {
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      {
        const MeshLevel<dim> &level = meshes.level(l);
        std::map<types::global_dof_index, SlipRate<dim>> known;
        for (unsigned int f = 0; f < rates.size(); ++f)
          {
            if (!rates[f])
              continue;
            const FaultSurface<dim> &slave = level.surface(f, sides[f].slave);
            const std::vector<std::optional<SlipRate<dim>>> values =
              rates[f](slave.points);
            for (unsigned int k = 0; k < slave.nodes.size(); ++k)
              if (values[k])
                {
                  SlipRate<dim> &rate = known[slave.nodes[k]];
                  rate                = *values[k];
                  rate.value *= sides[f].sign();
                }
          }
        nodes_of_level.emplace_back();
        finest_rates.clear();
        for (const auto &[node, rate] : known)
          {
            nodes_of_level.back().push_back(node);
            finest_rates.push_back(rate);
          }
      }
  }



  template <int dim>
  const std::vector<types::global_dof_index> &
  PrescribedSlip<dim>::nodes(const unsigned int l) const
  {
    return nodes_of_level[l];
  }



  template <int dim>
  void
  PrescribedSlip<dim>::set_slip_rates(const double          time,
                                      const JumpBasis<dim> &basis,
                                      const NodePartition  &partition,
                                      NodalVector          &w) const
  {
    const std::vector<types::global_dof_index> &contact = basis.contact_nodes();
    const std::vector<types::global_dof_index> &nodes   = nodes_of_level.back();
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (partition.owned().is_element(nodes[i]) &&
          std::binary_search(contact.begin(), contact.end(), nodes[i]))
        {
          const unsigned int node = partition.local_index(nodes[i]);
          const double ramp = smooth_ramp(time, finest_rates[i].ramp_length);
          for (unsigned int d = 0; d < dim - 1; ++d)
            w.local_element(node * partition.n_components() + d) =
              ramp * finest_rates[i].value[d];
        }
  }



  template <int dim>
  double
  PrescribedSlip<dim>::longest_ramp() const
  {
    double longest = 0;
    for (const SlipRate<dim> &rate : finest_rates)
      longest = std::max(longest, rate.ramp_length);
    return longest;
  }



  template class PrescribedSlip<2>;
  template class PrescribedSlip<3>;
} // namespace StickSlip
