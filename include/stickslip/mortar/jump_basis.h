// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_jump_basis_h
#define stickslip_mortar_jump_basis_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/mesh/nodal_prolongation.h>
#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/fault_axes.h>
#include <stickslip/mortar/fault_displacement.h>

#include <map>

namespace StickSlip
{
  /**
   * One fault on one level: the global numbers of the nodes on both sides, in
   * the order of the surfaces, and their coupling.
   */
  template <int dim>
  struct FaultContact
  {
    FaultSides                           sides;
    FaultAxes<dim>                       axes;
    FaultSurface<dim>                    slave_surface;
    std::vector<types::global_dof_index> slave_nodes;
    std::vector<types::global_dof_index> master_nodes;
    MortarCoupling                       coupling;

    /** Diameter of the smallest face of the two sides, m. */
    double smallest_face = 0;
  };

  /**
   * The basis of one level in which the unknowns at the active slave nodes are
   * jumps across the fault,
   *
   *   w_p = averaging_factor_p (u_p - sum_q N_pq u_q - sum_k S_pk u_k),
   *
   * the mean of the jump over the dual basis function of p, and all other
   * unknowns are nodal values: u = B w. In this basis friction couples no
   * nodes, and the bilateral contact fixes one component of a node.
   *
   * Components keep the axes of space; on a horizontal fault the last one is
   * normal to it, the others are tangential.
   *
   * Every process knows the coupling of all faults. B is the identity but for
   * rows of slave nodes, so that any row is known everywhere.
   */
  template <int dim>
  class JumpBasis
  {
  public:
    /**
     * @param level The meshes.
     * @param sides One entry a fault of the topology.
     * @param displacements One entry a fault, which is coupled as it is after
     *   these.
     * @param dirichlet Nodes with a component masked here are no contact
     *   nodes; over the global numbers of the level.
     */
    JumpBasis(const MeshLevel<dim>                      &level,
              const std::vector<FaultSides>             &sides,
              const std::vector<FaultDisplacement<dim>> &displacements,
              const NodeMask                            &dirichlet);

    const std::vector<FaultContact<dim>> &
    faults() const
    {
      return contacts;
    }

    /** A row of B. */
    GlobalRow
    to_nodal(const types::global_dof_index node) const;

    /** A row of the inverse of B. */
    GlobalRow
    to_jumps(const types::global_dof_index node) const;

    /** Global numbers of the active slave nodes of all faults, ascending. */
    const std::vector<types::global_dof_index> &
    contact_nodes() const
    {
      return active_nodes;
    }

    /** Local indices of the active slave nodes that this process owns,
     * ascending. */
    std::vector<unsigned int>
    owned_contact_nodes(const NodePartition &nodes) const;

  private:
    std::vector<FaultContact<dim>>       contacts;
    std::vector<types::global_dof_index> active_nodes;

    /** For each active slave node its averaging factor and the partners whose
     * weighted values are the other side of the jump. */
    std::map<types::global_dof_index, std::pair<double, GlobalRow>> jumps;
  };

  /**
   * A row of the prolongation between the jump bases of two levels,
   * B_f^-1 P B_c, for a node of the finer one: jumps stay jumps.
   */
  template <int dim>
  GlobalRow
  jump_prolongation(const JumpBasis<dim>         &coarse,
                    const JumpBasis<dim>         &fine,
                    const NodalProlongation      &prolongation,
                    const types::global_dof_index node);
} // namespace StickSlip

#endif
