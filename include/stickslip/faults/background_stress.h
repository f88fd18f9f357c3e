// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_background_stress_h
#define stickslip_faults_background_stress_h

#include <stickslip/friction/fault_parameters.h>
#include <stickslip/mortar/jump_basis.h>

#include <vector>

namespace StickSlip
{
  /**
   * A stress S that is there before the bodies deform, and that they do not
   * carry: it acts on faults only. With the normal n and the tangents t of a
   * slave node it adds -n.S n to the normal stress of friction, and t.S n to
   * the shear traction that drives the slip of the second side relative to the
   * first. It is that of the nodes' reference positions, whatever the
   * slip, resolved along the axes that the basis has.
   */
  template <int dim>
  class BackgroundStress
  {
  public:
    /** No stress. */
    BackgroundStress() = default;

    /** The stress that these faults have. */
    explicit BackgroundStress(const std::vector<FaultParameters> &faults);

    /** True if any fault has one. */
    bool
    is_needed() const;

    /** The normal stress at the slave nodes of a fault, Pa, compression
     * positive; empty if it has none. Throws InputError, see
     * StressField::values(). */
    std::vector<double>
    normal_stress(const JumpBasis<dim> &basis, const unsigned int fault) const;

    /** The forces of the shear tractions, a dual vector of the jump basis,
     * partitioned as @p nodes. Throws as normal_stress(). */
    NodalVector
    load(const JumpBasis<dim> &basis, const NodePartition &nodes) const;

  private:
    struct OfFault
    {
      StressField stress;
      /** The subsection of its entries, for messages. */
      std::string section;

      /** Tractions S n at the slave nodes of the fault, Pa. */
      std::vector<Tensor<1, dim>>
      tractions(const FaultContact<dim> &contact) const;
    };

    std::vector<OfFault> faults;
  };
} // namespace StickSlip

#endif
