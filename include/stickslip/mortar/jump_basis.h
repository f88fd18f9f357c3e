// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_jump_basis_h
#define stickslip_mortar_jump_basis_h

#include <stickslip/algebra/node_frames.h>
#include <stickslip/mesh/nodal_prolongation.h>
#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/fault_axes.h>
#include <stickslip/mortar/fault_displacement.h>

#include <map>

namespace StickSlip
{
  /**
   * One fault on one level: its two sides, which are those of the MeshLevel and
   * are there as long as it is, and their coupling without its rows, which are
   * those of the basis.
   */
  template <int dim>
  struct FaultContact
  {
    const FaultSurface<dim> &slave, &master;
    FaultSides               sides;
    FaultAxes<dim>           axes;
    MortarCoupling<dim>      coupling;

    /** Diameter of the smallest face of the two sides, m. */
    double smallest_face = 0;

    /** True if the two sides are not in one plane. */
    bool is_bent = false;

    /** The sign with which the last component of the jump at the k-th slave
     * node opens the fault. */
    double
    opening_sign(const unsigned int k) const
    {
      return sides.sign() *
             (axes.are_those_of_space() ? axes.normal(k)[dim - 1] : 1.);
    }
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
   * Jumps have components along the axes of their node, R_p, with the normal
   * one last (frames()); everything else keeps the axes of space, and so do the
   * jumps of level faults. Rows of B are the scalars that are common to all
   * components, without rotations:
   *
   *   u_p = R_p w_p / averaging_factor_p + sum_q N_pq u_q + sum_k S_pk u_k .
   *
   * Where a fault is curved, the jump that rotations do not have differs from
   * this one by a term that couples components: see rotation_term(). It is not
   * part of the rows.
   *
   * Nodes that are on more than one side of faults (crosspoints.h) have no
   * jump; they are nodal values.
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
     * @param axes One entry a fault, at its slave nodes.
     * @param displacements One entry a fault, which is coupled as it is after
     *   these.
     * @param excluded One entry a fault: the slave nodes that are no contact
     *   nodes, see excluded_nodes().
     *
     * Collective.
     */
    JumpBasis(const MeshLevel<dim>                      &level,
              const std::vector<FaultSides>             &sides,
              const std::vector<FaultAxes<dim>>         &axes,
              const std::vector<FaultDisplacement<dim>> &displacements,
              const std::vector<std::vector<bool>>      &excluded);

    const std::vector<FaultContact<dim>> &
    faults() const
    {
      return contacts;
    }

    /** Forget faults() and rotation_term(): coarse levels are only asked for
     * rows and frames. */
    void
    forget_faults();

    /** Forget rotation_term(), of which each process needs a part only. */
    void
    forget_rotation_terms();

    /** A row of B. */
    GlobalRow
    to_nodal(const types::global_dof_index node) const;

    /** A row of the inverse of B. */
    GlobalRow
    to_jumps(const types::global_dof_index node) const;

    /** Axes of the jumps of all active slave nodes; empty where these are those
     * of space. */
    const NodeFrames<dim> &
    frames() const
    {
      return jump_frames;
    }

    /** Addition of the rotation-free jump at a node to that of the rows, in the
     * axes of space and before the factor of the row: master nodes q and
     * matrices C_pq that are applied to u_q, see MortarCoupling. All q are in
     * the rows. Empty where there is none. */
    std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>>
    rotation_term(const types::global_dof_index node) const;

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
    /** The position among the active nodes, or their number for any other
     * node. */
    unsigned int
    position(const types::global_dof_index node) const;

    std::vector<FaultContact<dim>>       contacts;
    NodeFrames<dim>                      jump_frames;
    std::vector<types::global_dof_index> active_nodes;

    /** For each active slave node its averaging factor and the partners whose
     * weighted values are the other side of the jump. */
    std::vector<double>                 factors;
    PackedRows<types::global_dof_index> partners;

    /** Terms at nodes of curved faults. */
    std::map<types::global_dof_index,
             std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>>>
      rotation_terms;
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
