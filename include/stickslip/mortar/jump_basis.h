// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_jump_basis_h
#define stickslip_mortar_jump_basis_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/transfer_matrix.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/dual_mortar.h>

namespace StickSlip
{
  /**
   * Which side of a fault carries the multipliers and the jumps.
   */
  struct FaultSides
  {
    unsigned int       slave_body, master_body;
    types::boundary_id slave_side, master_side;

    bool
    slave_is_upper() const
    {
      return slave_body > master_body;
    }
  };

  /**
   * The sides of the fault between the bodies @p lower and lower + 1: slave is
   * the one with the smaller faces on average; the upper one if they are
   * equal.
   */
  template <int dim>
  FaultSides
  choose_fault_sides(const MeshLevel<dim> &level, const unsigned int lower);

  /**
   * One fault on one level: the local indices of the nodes on both sides, in
   * the order of the surfaces, and how they are coupled.
   */
  template <int dim>
  struct FaultContact
  {
    FaultSides                sides;
    FaultSurface<dim>         slave_surface;
    std::vector<unsigned int> slave_nodes;
    std::vector<unsigned int> master_nodes;
    MortarCoupling            coupling;

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
   */
  template <int dim>
  class JumpBasis
  {
  public:
    /**
     * @param level The meshes.
     * @param sides One entry a fault, from bottom to top.
     * @param displacement Nodal values on this level; the fault is coupled
     *   as it is after this displacement. Entries apart from the faults are
     *   not used.
     * @param dirichlet Nodes with a component masked here are no contact
     *   nodes.
     */
    JumpBasis(const MeshLevel<dim>          &level,
              const std::vector<FaultSides> &sides,
              const NodalVector             &displacement,
              const NodeMask                &dirichlet);

    const std::vector<FaultContact<dim>> &
    faults() const;

    /** B. */
    const TransferMatrix &
    to_nodal() const;

    /** The inverse of B. */
    const TransferMatrix &
    to_jumps() const;

    /** Local indices of the active slave nodes of all faults, ascending. */
    const std::vector<unsigned int> &
    contact_nodes() const;

  private:
    std::vector<FaultContact<dim>> contacts;
    TransferMatrix                 B;
    TransferMatrix                 B_inverse;
    std::vector<unsigned int>      active_nodes;
  };

  /**
   * The prolongation between the jump bases of two levels, B_f^-1 P B_c: jumps
   * stay jumps.
   */
  template <int dim>
  TransferMatrix
  jump_prolongation(const JumpBasis<dim> &coarse,
                    const JumpBasis<dim> &fine,
                    const TransferMatrix &nodal_prolongation);

  /**
   * The values of a nodal vector of the fine level at the nodes of the coarse
   * level that sit at the same places; zero at the others.
   */
  void
  inject(NodalVector          &coarse,
         const NodalVector    &fine,
         const TransferMatrix &nodal_prolongation,
         const unsigned int    components);
} // namespace StickSlip

#endif
