// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/background_stress.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim>
  BackgroundStress<dim>::BackgroundStress(
    const std::vector<FaultParameters> &faults)
  {
    for (const FaultParameters &fault : faults)
      this->faults.push_back({fault.background_stress, fault.section()});
  }



  template <int dim>
  bool
  BackgroundStress<dim>::is_needed() const
  {
    return std::any_of(faults.begin(), faults.end(), [](const OfFault &fault) {
      return fault.stress.is_given();
    });
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  BackgroundStress<dim>::OfFault::tractions(
    const FaultContact<dim> &contact) const
  {
    const std::vector<SymmetricTensor<2, dim>> stresses =
      stress.values(contact.slave.points, section);
    std::vector<Tensor<1, dim>> tractions;
    for (unsigned int k = 0; k < stresses.size(); ++k)
      tractions.push_back(stresses[k] * contact.axes.normal(k));
    return tractions;
  }



  template <int dim>
  std::vector<double>
  BackgroundStress<dim>::normal_stress(const JumpBasis<dim> &basis,
                                       const unsigned int    fault) const
  {
    if (!faults[fault].stress.is_given())
      return {};
    const FaultContact<dim>          &contact = basis.faults()[fault];
    const std::vector<Tensor<1, dim>> tractions =
      faults[fault].tractions(contact);
    std::vector<double> normal_stress;
    for (unsigned int k = 0; k < tractions.size(); ++k)
      normal_stress.push_back(-(contact.axes.normal(k) * tractions[k]));
    return normal_stress;
  }



  template <int dim>
  NodalVector
  BackgroundStress<dim>::load(const JumpBasis<dim> &basis,
                              const NodePartition  &nodes) const
  {
    NodalVector load = nodes.make_vector();
    for (unsigned int f = 0; f < faults.size(); ++f)
      {
        if (!faults[f].stress.is_given())
          continue;
        const FaultContact<dim>          &contact = basis.faults()[f];
        const std::vector<Tensor<1, dim>> tractions =
          faults[f].tractions(contact);
        for (unsigned int k = 0; k < tractions.size(); ++k)
          {
            if (!contact.coupling.active[k] ||
                !nodes.owned().is_element(contact.slave.nodes[k]))
              continue;
            const Tensor<1, dim> along_axes =
              transpose(contact.axes.at(k)) * tractions[k];
            // Unknowns are jumps from master to slave.
            for (unsigned int d = 0; d < dim - 1; ++d)
              load.local_element(nodes.local_index(contact.slave.nodes[k]) *
                                   nodes.n_components() +
                                 d) = contact.sides.sign() *
                                      contact.coupling.weight[k] *
                                      along_axes[d];
          }
      }
    return load;
  }



  template class BackgroundStress<2>;
  template class BackgroundStress<3>;
} // namespace StickSlip
