// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_spatial_problem_h
#define stickslip_problem_spatial_problem_h

#include <stickslip/faults/prescribed_slip.h>
#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/jump_basis.h>
#include <stickslip/multigrid/level_hierarchy.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The problem after discretisation in space,
   *
   *   M u_tt + C u_t + K u + friction = f,
   *
   * in the jump basis that belongs to the current contact mapping, with the
   * level hierarchy of those of M, C and K that are there: M only if inertia is
   * asked for, C only if a body is viscous. Vectors of displacement, velocity
   * and load are nodal; the hierarchy works on unknowns w of the jump basis,
   * u = B w. Both have the same owned entries, and different ghosts; those of
   * the jump basis change with the contact mapping.
   */
  template <int dim>
  class SpatialProblem
  {
  public:
    /** Terms of the equation, in this order. */
    enum Term : unsigned int
    {
      mass      = 0,
      damping   = 1,
      stiffness = 2
    };

    /** @p materials in the order of the bodies; @p gravity: its acceleration,
     * m/s^2. Without inertia M is never assembled. @p slip_rates: where the
     * slip rate is known, one entry a fault, or none at all. */
    SpatialProblem(const MeshHierarchy<dim>          &meshes,
                   const std::vector<MaterialFields> &materials,
                   BoundaryValues<dim>               &boundary_values,
                   const Tensor<1, dim>              &gravity,
                   const bool                         with_inertia = true,
                   const std::vector<SlipRates<dim>> &slip_rates   = {});

    /** True if the equation has this term. */
    bool
    has(const Term term) const;

    /** A term that it has, on the finest level in the jump basis. */
    const BlockMatrix<dim> &
    term(const Term term) const;

    /** Set the operator to a combination of M, C and K; what the equation does
     * not have is left out. Collective. */
    void
    combine(const std::vector<double> &coefficients);

    /**
     * Couple the faults as they are after a displacement, with everything that
     * depends on it. Throws AgreedFailure if the sides of a fault do not touch
     * any more; all is as before then. Collective.
     */
    void
    build_contact(const NodalVector &displacement);

    /** True if the last attempt to do so has succeeded; if not, there are no
     * levels. */
    bool
    is_coupled() const;

    const MeshHierarchy<dim> &
    meshes() const;

    /** The operator on the finest level, and its terms. */
    OperatorSum<dim> &
    operators();

    const OperatorSum<dim> &
    operators() const;

    /** The preconditioner. */
    LevelHierarchy<dim> &
    hierarchy();

    const LevelHierarchy<dim> &
    hierarchy() const;

    /** The jump basis of the finest level. */
    const JumpBasis<dim> &
    jump_basis() const;

    /** w = B^-1 u. This and the next three are collective. */
    void
    to_jumps(NodalVector &w, const NodalVector &u) const;

    /** u = B w. */
    void
    to_nodal(NodalVector &u, const NodalVector &w) const;

    /** B^T f of nodal forces: a dual vector of the jump basis. */
    NodalVector
    to_dual(const NodalVector &f) const;

    /** The load at @p time as a dual vector of the jump basis. */
    NodalVector
    load(const double time);

    BoundaryValues<dim> &
    boundary_values();

    /** Set what is known of a vector of the jump basis, m/s: zero normal jumps,
     * and the slip rates that are prescribed at @p time. */
    void
    set_known_jumps(const double time, NodalVector &w) const;

    /** The length of the longest ramp of boundary values and slip rates, s. */
    double
    longest_ramp() const;

    /** A zero vector of the jump basis. */
    NodalVector
    make_vector() const;

    /** A zero vector of nodal values. */
    NodalVector
    make_nodal_vector() const;

    /** Number of times build_contact() was called. */
    unsigned int
    n_builds() const;

  private:
    /** Everything that depends on the jump bases, one for each level. */
    void
    build(const std::vector<JumpBasis<dim>> &bases);

    /** Masks and nonsmooth nodes of all levels. */
    void
    describe(std::vector<LevelDescription<dim>> &descriptions,
             const std::vector<JumpBasis<dim>>  &bases) const;

    const MeshHierarchy<dim> &mesh_hierarchy;
    BoundaryValues<dim>      &boundary;
    std::vector<FaultSides>   sides;
    /** The terms of the equation in the nodal basis, and which each is. */
    std::vector<BlockMatrix<dim>> nodal_terms;
    std::vector<Term>             terms;
    /** Empty without gravity. */
    NodalVector           gravity_load;
    std::vector<NodeMask> dirichlet_masks;
    /** None where friction acts on all faults. */
    std::unique_ptr<PrescribedSlip<dim>>  prescribed_slip;
    std::unique_ptr<JumpBasis<dim>>       finest_basis;
    std::unique_ptr<GalerkinProduct<dim>> to_jump_basis;
    TransferMatrix                        B_inverse;
    std::unique_ptr<OperatorSum<dim>>     operator_sum;
    std::unique_ptr<LevelHierarchy<dim>>  levels;
    unsigned int                          builds = 0;
  };
} // namespace StickSlip

#endif
