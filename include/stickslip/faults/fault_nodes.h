// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_fault_nodes_h
#define stickslip_faults_fault_nodes_h

#include <stickslip/friction/fault_friction.h>
#include <stickslip/friction/state_evolution.h>
#include <stickslip/mortar/jump_basis.h>

namespace StickSlip
{
  /**
   * The friction of a fault, or of those of its nodes that have the same
   * parameters.
   */
  struct FaultLaw
  {
    std::shared_ptr<const FrictionLaw> friction;
    /** How the state evolves; null without a state. */
    std::shared_ptr<const StateLaw> state_law;
    /** Characteristic slip L, m: of the state, and the measure of an error of
     * the slip. */
    double characteristic_slip = 0;
    /** Whether the slip rate is known, so that friction has no say. */
    bool is_prescribed = false;
    /** Radiation damping eta, Pa s/m: a traction eta V against the slip. */
    double radiation_damping = 0;
  };

  /**
   * The friction of all slave nodes.
   */
  struct NodeLaws
  {
    /** Those that occur. */
    std::vector<FaultLaw> laws;
    /** For each slave node, the position of its law in laws. */
    std::vector<unsigned int> of_node;
  };

  /**
   * The slave nodes of all faults in one row, fault after fault, each in the
   * order of its surface. Law, state, slip and normal stress are arrays over
   * these nodes; they stay with the nodes when the contact mapping changes.
   * Friction acts on those of them that are in contact.
   *
   * Every process has the arrays of all slave nodes, and computes the same with
   * them: decisions that depend on them need no messages. The functional of
   * friction has the nodes that the process owns.
   */
  template <int dim>
  class FaultNodes
  {
  public:
    FaultNodes() = default;

    /**
     * @p partition: of vectors of the jump basis; @p normal_stress: one entry a
     * slave node, Pa.
     */
    FaultNodes(const JumpBasis<dim>      &basis,
               const NodePartition       &partition,
               const NodeLaws            &laws,
               const std::vector<double> &normal_stress);

    /** Number of slave nodes of all faults. */
    unsigned int
    size() const;

    /** Position of the first node of each fault, and size(). */
    const std::vector<unsigned int> &
    first_of_fault() const;

    /** The fault of a slave node. */
    unsigned int
    fault(const unsigned int k) const;

    const FaultLaw &
    law(const unsigned int k) const;

    const NodeLaws &
    laws() const;

    /** Local index in nodal vectors of a slave node that this process owns. */
    unsigned int
    node(const unsigned int k) const;

    bool
    in_contact(const unsigned int k) const;

    /** Integral of the dual basis function, zero off contact. */
    const std::vector<double> &
    weights() const;

    /** Normal stress, Pa, compression positive. */
    const std::vector<double> &
    normal_stress() const;

    /** Normal stress over its mean on the same fault; zero where there is
     * none. */
    const std::vector<double> &
    relative_normal_stress() const;

    /** The positions of the owned nodes that are in contact, in the order of
     * the terms of friction(). */
    const std::vector<unsigned int> &
    owned_contact() const;

    /** The functional of friction on the owned nodes. */
    FaultFriction<dim> &
    friction();

    const FaultFriction<dim> &
    friction() const;

    /** Change the normal stress, Pa, one entry a slave node, none negative. */
    void
    set_normal_stress(const std::vector<double> &normal_stress);

    /** Hand the state to the functional. */
    void
    set_state(const std::vector<double> &alpha);

    /** The tangential jump at each slave node from a vector of the jump basis,
     * slave relative to master; zero off contact. Collective. */
    std::vector<Tensor<1, dim - 1>>
    tangential_jumps(const NodalVector &w) const;

    /** The norm in L2(faults), sqrt(sum weight value^2), of an array over the
     * slave nodes; nodes off contact do not count. */
    double
    l2_norm(const std::vector<double> &values) const;

  private:
    void
    set_relative_stresses();

    NodeLaws                  node_laws;
    std::vector<unsigned int> first;
    std::vector<unsigned int> fault_of_node;
    NodePartition             partition;
    /** Global numbers. */
    std::vector<types::global_dof_index> nodes;
    std::vector<bool>                    active;
    std::vector<double>                  node_weights;
    std::vector<double>                  stresses;
    std::vector<double>                  relative_stresses;
    std::vector<unsigned int>            contact_positions;
    std::unique_ptr<FaultFriction<dim>>  functional;
  };
} // namespace StickSlip

#endif
