// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_lumped_mass_h
#define stickslip_problem_lumped_mass_h

#include <stickslip/problem/spatial_problem.h>

#include <vector>

namespace StickSlip
{
  /**
   * A mass of the bodies in the jump basis that is inverted node by node, for
   * explicit steps.
   *
   * Nodes have the mass of their row sums, m. In the jump basis that of slave
   * nodes p goes to the nodes q that they face as well,
   *
   *   D_q = m_q + sum_p N_pq m_p,   S_pq = m_p N_pq R_p^T R_q / f_p,
   *
   * with the axes R of the nodes and the averaging factor f_p of a jump, and
   * couples jumps w to the velocities u of these nodes. Of these variables and
   *
   *   c_q = u_q + sum_p S_pq^T w_p / D_q
   *
   * the kinetic energy is
   *
   *   1/2 sum_q D_q |c_q|^2 + 1/2 w . (m / f^2 - S D^-1 S^T) w,
   *
   * whose last matrix couples jumps along the fault where nodes do not face
   * each other. It is replaced by the sums of its rows over a motion of all of
   * the slave side in one direction, so that bodies which move as a whole have
   * their kinetic energy, and slave nodes that face a node each have that of
   * both. Components of q that are fixed have c_q = u_q.
   *
   * Jumps that rotations do not have on curved faults (RotationCoupling) are
   * left out.
   */
  template <int dim, int n_components = dim>
  class LumpedMass
  {
  public:
    /** For the contact mapping that @p problem has now. It must live longer.
     * Collective. */
    explicit LumpedMass(const SpatialProblem<dim, n_components> &problem);

    /** p = M w. Collective among neighbours, as the next three. */
    void
    vmult(NodalVector &p, const NodalVector &w) const;

    /** Accelerations of all but the slave nodes as if no jump changed, from
     * dual vectors of forces, and from @p a where components are fixed. */
    void
    accelerate_bodies(NodalVector &a, const NodalVector &force) const;

    /** Let jumps change by the accelerations that @p a has at slave nodes. */
    void
    accelerate_jumps(NodalVector &a) const;

    /** a = M^-1 force, zero where components are fixed. */
    void
    solve(NodalVector &a, const NodalVector &force) const;

    /** The force on the jump of the i-th owned slave node in contact, N, with
     * the result of accelerate_bodies(). */
    Tensor<1, n_components>
    relative_force(const unsigned int i,
                   const NodalVector &force,
                   const NodalVector &a) const;

    /** The mass of each component of that jump, kg/m^(3-d). */
    const Tensor<1, n_components> &
    relative_mass(const unsigned int i) const
    {
      return relative_masses[i];
    }

  private:
    /** A slave node and a node that it faces: the local index of the one that
     * is not said by the place, and S. */
    struct Partner
    {
      unsigned int            node;
      Tensor<2, n_components> coupling;
    };

    /** Nodes with partners, the position of the first one of each, and how many
     * there are. */
    struct PartnerList
    {
      std::vector<unsigned int> nodes, first;
      std::vector<Partner>      partners;
    };

    /** The components of a node. */
    static Tensor<1, n_components>
    values_at(const NodalVector &w, const unsigned int node);

    /** S^T w at the k-th of the nodes that slave nodes face. */
    Tensor<1, n_components>
    jump_momentum(const unsigned int k, const NodalVector &w) const;

    const NodeMask &fixed;

    /** D of each component of owned nodes, and its inverse, zero where it is
     * fixed; of slave nodes in contact zero. */
    std::vector<double> masses, inverse_masses;

    /** Owned slave nodes in contact with the nodes that they face, and owned
     * nodes that are faced with their slave nodes. */
    PartnerList                          of_slaves, of_faced;
    std::vector<Tensor<1, n_components>> relative_masses;
  };
} // namespace StickSlip

#endif
