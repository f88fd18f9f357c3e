// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_prescribed_slip_h
#define stickslip_faults_prescribed_slip_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/jump_basis.h>

#include <functional>
#include <optional>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A slip rate that is known.
   */
  template <int dim>
  struct SlipRate
  {
    /** Slip rate of the second side relative to the first, m/s. */
    Tensor<1, dim - 1> value;

    /** Time in which it grows from zero, s. */
    double ramp_length = 0;
  };

  /**
   * The known slip rates at some points of a fault in the reference
   * configuration; none where friction acts.
   */
  template <int dim>
  using SlipRates = std::function<std::vector<std::optional<SlipRate<dim>>>(
    const std::vector<Point<dim>> &)>;

  /**
   * Parts of faults whose slip rate is known: zero where a fault is welded, the
   * velocity of a plate where it creeps. Tangential jumps are no unknowns
   * there; they are masked on all levels, as the normal ones are everywhere.
   */
  template <int dim>
  class PrescribedSlip
  {
  public:
    /** @p sides, @p rates: one entry a fault; an empty function for a fault
     * that has no such part. */
    PrescribedSlip(const MeshHierarchy<dim>          &meshes,
                   const std::vector<FaultSides>     &sides,
                   const std::vector<SlipRates<dim>> &rates);

    /** The slave nodes of level @p l where the slip rate is known, ascending
     * global numbers. */
    const std::vector<types::global_dof_index> &
    nodes(const unsigned int l) const;

    /** Set the slip rates that this process owns to those at @p time; @p basis,
     * @p partition: of the vector @p w. */
    void
    set_slip_rates(const double          time,
                   const JumpBasis<dim> &basis,
                   const NodePartition  &partition,
                   NodalVector          &w) const;

    /** The length of the longest ramp, s. */
    double
    longest_ramp() const;

  private:
    std::vector<std::vector<types::global_dof_index>> nodes_of_level;

    /** Rates at the nodes of the finest level, slave relative to master. */
    std::vector<SlipRate<dim>> finest_rates;
  };
} // namespace StickSlip

#endif
