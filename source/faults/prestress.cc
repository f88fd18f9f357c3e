// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/prestress.h>

namespace StickSlip
{
  template <int dim>
  void
  add_prestress(const JumpBasis<dim>                  &basis,
                const NodePartition                   &nodes,
                const std::vector<Tensor<1, dim - 1>> &shear_stress,
                NodalVector                           &load)
  {
    unsigned int first = 0;
    for (const FaultContact<dim> &contact : basis.faults())
      {
        for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
          if (contact.coupling.active[k] &&
              nodes.owned().is_element(contact.slave.nodes[k]))
            for (unsigned int d = 0; d < dim - 1; ++d)
              load.local_element(nodes.local_index(contact.slave.nodes[k]) *
                                   nodes.n_components() +
                                 d) +=
                contact.coupling.weight[k] * shear_stress[first + k][d];
        first += contact.slave.nodes.size();
      }
  }



  template decltype(add_prestress<2>) add_prestress<2>;
  template decltype(add_prestress<3>) add_prestress<3>;
} // namespace StickSlip
