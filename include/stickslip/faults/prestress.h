// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_prestress_h
#define stickslip_faults_prestress_h

#include <stickslip/mortar/jump_basis.h>

#include <vector>

namespace StickSlip
{
  /**
   * Add the forces of shear stresses that act on the faults only to @p load, a
   * dual vector of the jump basis partitioned as @p nodes. @p shear_stress: at
   * each slave node, fault after fault, Pa, driving the slip of slave relative
   * to master along the axes that the basis has.
   */
  template <int dim>
  void
  add_prestress(const JumpBasis<dim>                  &basis,
                const NodePartition                   &nodes,
                const std::vector<Tensor<1, dim - 1>> &shear_stress,
                NodalVector                           &load);
} // namespace StickSlip

#endif
