// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_fault_nodes_h
#define stickslip_faults_fault_nodes_h

#include <stickslip/mortar/jump_basis.h>

namespace StickSlip
{
  /**
   * The slave nodes of all faults in one row, fault after fault, each in the
   * order of its surface. Laws, state, slip and normal stress are arrays over
   * these nodes; they stay with the nodes when the contact mapping changes,
   * while weights and contact follow it. Friction acts on nodes in contact.
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

    /** @p partition: of vectors of the jump basis. */
    FaultNodes(const JumpBasis<dim> &basis, const NodePartition &partition);

    /** Number of slave nodes of all faults. */
    unsigned int
    size() const
    {
      return nodes.size();
    }

    /** Position of the first node of each fault, and size(). */
    const std::vector<unsigned int> &
    first_of_fault() const
    {
      return first;
    }

    /** The fault of a slave node. */
    unsigned int
    fault(const unsigned int k) const
    {
      return fault_of_node[k];
    }

    /** Local index in nodal vectors of a slave node that this process owns. */
    unsigned int
    node(const unsigned int k) const
    {
      return partition.local_index(nodes[k]);
    }

    bool
    in_contact(const unsigned int k) const
    {
      return active[k];
    }

    /** The sign with which the normal jump of a slave node in a vector of the
     * jump basis opens the fault. */
    double
    opening_sign(const unsigned int k) const
    {
      return opening_signs[k];
    }

    /** Integral of the dual basis function, m^(d-1); zero off contact. */
    const std::vector<double> &
    weights() const
    {
      return node_weights;
    }

    /** The positions of the owned nodes that are in contact, in the order of
     * the terms of the functional of friction (fault_functional.h). */
    const std::vector<unsigned int> &
    owned_contact() const
    {
      return contact_positions;
    }

    /** The entries at owned_contact() of an array over the slave nodes. */
    std::vector<double>
    at_owned_contact(const std::vector<double> &values) const;

    /** The tangential jump at each slave node from a vector of the jump basis,
     * slave relative to master; zero off contact. Collective. */
    std::vector<Tensor<1, dim - 1>>
    tangential_jumps(const NodalVector &w) const;

    /** The normal jump at each slave node from a vector of the jump basis,
     * positive where the sides part; zero off contact. Collective. */
    std::vector<double>
    opening_jumps(const NodalVector &w) const;

    /** An array over the slave nodes, none negative, over its mean on the part
     * in contact of the same fault; zero where that mean is zero. */
    std::vector<double>
    over_mean(const std::vector<double> &values) const;

  private:
    std::vector<unsigned int> first;
    std::vector<unsigned int> fault_of_node;
    NodePartition             partition;
    /** Global numbers. */
    std::vector<types::global_dof_index> nodes;
    std::vector<bool>                    active;
    std::vector<double>                  node_weights;
    std::vector<double>                  opening_signs;
    std::vector<unsigned int>            contact_positions;
  };
} // namespace StickSlip

#endif
