// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_contact_space_h
#define stickslip_problem_contact_space_h

#include <stickslip/faults/prescribed_slip.h>
#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/jump_basis.h>
#include <stickslip/mortar/secant_axes.h>
#include <stickslip/multigrid/level_description.h>
#include <stickslip/problem/contact_components.h>
#include <stickslip/problem/rotation_coupling.h>

#include <memory>
#include <optional>
#include <vector>

namespace StickSlip
{
  /**
   * The space of displacements of bodies in contact: on each level l a jump
   * basis B_l that belongs to the current contact mapping,
   *
   *   u_l = B_l w_l,
   *
   * the transfers B_l^-1 P B_(l-1) between them, components that take no part,
   * and jumps that are known. The B of the finest level has no jump for rigid
   * motions even where faults are curved (RotationCoupling); the transfers are
   * those without this term. Nodes of faults that are not level, and nodes
   * whose components are prescribed along other axes than those of space, have
   * these axes in w (LevelDescription::frames). Nodal vectors u and vectors w
   * of the jump basis have the same owned entries, and different ghosts; those
   * of the jump basis change with the contact mapping.
   *
   * Displacements have @p n_components: those of space, or, in antiplane
   * scenes, the one out of the plane, which has no axes to turn, no normal jump
   * and no rotations, and leaves the contact mapping as it is.
   */
  template <int dim, int n_components = dim>
  class ContactSpace
  {
  public:
    /** @p materials in the order of the bodies; @p slip_rates, @p opening:
     * known slip rates and what may open, one entry a fault, or none at all.
     * Nodes whose slip rate is known do not open. There are no bases yet. */
    ContactSpace(const MeshHierarchy<dim>                &meshes,
                 const std::vector<MaterialFields>       &materials,
                 const BoundaryValues<dim, n_components> &boundary_values,
                 const std::vector<SlipRates<dim>>       &slip_rates,
                 const std::vector<OpeningParts<dim>>    &opening);

    const MeshHierarchy<dim> &
    meshes() const;

    /** The jump basis of the finest level. */
    const JumpBasis<dim> &
    jump_basis() const;

    /** The largest gap of each fault when it was coupled, in the order of the
     * faults; none of faults that are plane. */
    const std::vector<std::optional<LargestGap>> &
    gaps() const;

    /** Return whether the normal jump of a contact node of the finest level,
     * given by its global number, is free, since the node may open. */
    bool
    may_open(const types::global_dof_index node) const;

    /** w = B^-1 u. Collective. */
    void
    to_jumps(NodalVector &w, const NodalVector &u) const;

    /** u = B w. Collective. */
    void
    to_nodal(NodalVector &u, const NodalVector &w) const;

    /** B^T f of nodal forces: a dual vector of the jump basis. Collective. */
    NodalVector
    to_dual(const NodalVector &f) const;

    /** The nodal forces of a dual vector of the jump basis: the inverse of
     * to_dual(). Collective. */
    NodalVector
    to_nodal_forces(const NodalVector &dual) const;

    /** Set what is known of a vector of the jump basis, m/s: zero normal jumps
     * at nodes that cannot open, and the slip rates that are prescribed at
     * @p time. */
    void
    set_known_jumps(const double time, NodalVector &w) const;

    /** The length of the longest ramp of known slip rates, s; zero if there are
     * none. */
    double
    longest_slip_ramp() const;

    /** A zero vector of the jump basis. */
    NodalVector
    make_vector() const;

    /** A zero vector of nodal values. */
    NodalVector
    make_nodal_vector() const;

  protected:
    /** A contact mapping before it is put in place: jump bases of all levels,
     * and gaps(). */
    struct Mapping
    {
      std::vector<JumpBasis<dim>>            bases;
      std::vector<std::optional<LargestGap>> gaps;
    };

    /** The mapping of the faults as they are after a displacement, m.
     * @p expected_slip: of each slave node, fault after fault, until the next
     * mapping, see SecantCoupling; faults that are plane do not look at it.
     * Throws AgreedFailure if the sides of a fault do not touch any more.
     * Collective. */
    Mapping
    make_mapping(const NodalVector                     &displacement,
                 const std::vector<Tensor<1, dim - 1>> &expected_slip) const;

    /** Put a mapping in the place of the one before. @p sparsity: of nodal
     * matrices. Collective. */
    void
    set_mapping(Mapping mapping, const BlockSparsity &sparsity);

    /** Unknowns of all levels and the transfers between them. */
    const std::vector<LevelDescription<n_components>> &
    descriptions() const;

    /** The product of a nodal matrix with the rows of B, and what makes it
     * B^T A B. */
    GalerkinProduct<n_components> &
    jump_product();

    const RotationCoupling<dim, n_components> &
    rotation_coupling() const;

  private:
    /** Let the faults that bend be coupled along chords, all on the finest
     * level: changes their axes and displacements. Returns gaps(). */
    std::vector<std::optional<LargestGap>>
    follow_bends(const std::vector<Tensor<1, dim - 1>> &expected_slip,
                 std::vector<FaultAxes<dim>>           &axes_now,
                 std::vector<FaultDisplacement<dim>>   &displacements) const;

    /** The rows of the prolongation to a level that the local nodes of its jump
     * basis need, which couple with partners anywhere. Collective. */
    NodalProlongation
    prolongation_rows(const unsigned int    level,
                      const JumpBasis<dim> &basis,
                      const NodePartition  &nodes) const;

    /** Find opening_nodes. */
    void
    find_openings(const std::vector<OpeningParts<dim>> &opening);

    /** Set masks and nonsmooth nodes of all levels. Collective among
     * neighbours. */
    void
    describe(std::vector<LevelDescription<n_components>> &levels,
             const std::vector<JumpBasis<dim>>           &bases) const;

    const MeshHierarchy<dim> &mesh_hierarchy;
    std::vector<FaultSides>   sides;
    /** Axes of all faults on the finest level at the start; those of plane
     * faults stay. */
    std::vector<FaultAxes<dim>> axes;
    std::vector<NodeMask>       dirichlet_masks;
    /** See excluded_nodes(), level by level. */
    std::vector<std::vector<std::vector<bool>>> excluded;
    /** Axes of nodes that boundary conditions ask for, level by level. */
    std::vector<NodeFrames<n_components>> boundary_frames;
    /** Null where friction acts on all faults. */
    std::unique_ptr<PrescribedSlip<dim>> prescribed_slip;
    /** Slave nodes whose normal jumps are not fixed, level by level, ascending:
     * on the finest level those that may open, on coarser ones all of their
     * faults, since the masks of linear problems there follow from those of the
     * finest level. */
    std::vector<std::vector<types::global_dof_index>> opening_nodes;

    std::vector<std::optional<LargestGap>> largest_gaps;

    std::unique_ptr<JumpBasis<dim>>                finest_basis;
    std::unique_ptr<GalerkinProduct<n_components>> to_jump_basis;
    TransferMatrix                                 B_inverse;
    RotationCoupling<dim, n_components>            rotation;
    std::vector<LevelDescription<n_components>>    levels;
  };
} // namespace StickSlip

#endif
