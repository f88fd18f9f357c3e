// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_equation_of_motion_h
#define stickslip_problem_equation_of_motion_h

#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/mechanics/material_fields.h>
#include <stickslip/multigrid/level_hierarchy.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/partner_force.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * The equation of motion of all bodies,
   *
   *   B^T (M B w_tt + C B w_t + K B w) + friction = B^T f,
   *
   * in the jump basis B of a contact space: mass, damping and stiffness, the
   * load f of gravity and tractions, that of a background stress on the faults
   * which has no part in the bodies, a PartnerForce, boundary values, and the
   * level hierarchy of a combination of the terms. M is there only if inertia
   * is asked for, C only if a body is viscous.
   */
  template <int dim, int n_components = dim>
  class EquationOfMotion
  {
  public:
    /** Terms of the equation, in this order. */
    enum Term : unsigned int
    {
      mass      = 0,
      damping   = 1,
      stiffness = 2
    };

    /** @p space must outlive this object; @p materials in the order of the
     * bodies; @p gravity: its acceleration, m/s^2. Without inertia M is never
     * assembled. */
    EquationOfMotion(const ContactSpace<dim, n_components> &space,
                     const std::vector<MaterialFields>     &materials,
                     BoundaryValues<dim, n_components>     &boundary_values,
                     const Tensor<1, dim>                  &gravity,
                     const bool                             with_inertia);

    /** True if the equation has this term. */
    bool
    has(const Term term) const
    {
      return std::find(terms.begin(), terms.end(), term) != terms.end();
    }

    /** The mass of each owned node, kg/m^(3-d), in the order of nodal vectors:
     * sums of rows of M in the nodal basis; empty without inertia. */
    const std::vector<double> &
    nodal_masses() const
    {
      return masses;
    }

    /** A term that it has, on the finest level in the jump basis. */
    const TermMatrix<n_components> &
    term(const Term term) const;

    /** Set the operator to a combination of M, C and K; what the equation does
     * not have is left out. Collective. */
    void
    combine(const std::vector<double> &coefficients);

    /** True if there are levels: not after an attempt to make them that has
     * failed. */
    bool
    is_coupled() const
    {
      return levels != nullptr;
    }

    /** The operator on the finest level, and its terms. */
    OperatorSum<n_components> &
    operators()
    {
      return *operator_sum;
    }

    const OperatorSum<n_components> &
    operators() const
    {
      return *operator_sum;
    }

    /** The preconditioner. */
    LevelHierarchy<n_components> &
    hierarchy()
    {
      return *levels;
    }

    const LevelHierarchy<n_components> &
    hierarchy() const
    {
      return *levels;
    }

    /** The load at @p time as a dual vector of the jump basis. Collective. */
    NodalVector
    load(const double time);

    /** True if the load does not depend on the time. */
    bool
    has_constant_load() const
    {
      return !boundary.has_tractions() && !partners.is_there();
    }

    /** The time, s, until which the load changes at the rate that it has at
     * @p time; @p time itself where that is not known. */
    double
    constant_rate_until(const double time) const;

    /** The rate where it is known, N/s. */
    NodalVector
    load_rate(const double time) const;

    /** Let a force be part of the load, as long as the contact mapping is this
     * one. */
    void
    set_partner_force(PartnerForce force);

    const PartnerForce &
    partner_force() const
    {
      return partners;
    }

    BoundaryValues<dim, n_components> &
    boundary_values()
    {
      return boundary;
    }

    /** The length of the longest ramp of boundary values and slip rates, s. */
    double
    longest_ramp() const
    {
      return std::max(boundary.longest_ramp(), space.longest_slip_ramp());
    }

  protected:
    /** Sparsity of the terms in the nodal basis, which are assembled if they
     * are not there. */
    const BlockSparsity &
    nodal_sparsity();

    /** Remove operator and levels. */
    void
    clear_operator()
    {
      constant_load.reset();
      partners = PartnerForce();
      levels.reset();
      operator_sum.reset();
    }

    /** Set the load of a background stress on the faults, a dual vector of the
     * jump basis; empty for none. */
    void
    set_fault_load(NodalVector load)
    {
      constant_load.reset();
      fault_load = std::move(load);
    }

    /** Make operator and levels of the terms in the nodal basis; @p product, @p
     * rotation: to the jump basis, @p descriptions: of the levels of the
     * contact space. Collective. */
    void
    make_operator(GalerkinProduct<n_components>              &product,
                  const RotationCoupling<dim, n_components>  &rotation,
                  std::vector<LevelDescription<n_components>> descriptions);

  private:
    /** The load without the PartnerForce. */
    NodalVector
    external_load(const double time);

    /** The matrix of a term; none where there is no such term. */
    static TermMatrix<n_components> &
    matrix_of(ElasticMatrices<n_components> &matrices, const Term term);

    /** Assemble the terms in the nodal basis. */
    void
    assemble();

    /** The nodes of nearly incompressible bodies, from the assembled terms. */
    StiffVolumes
    stiff_volumes() const;

    const ContactSpace<dim, n_components> &space;
    BoundaryValues<dim, n_components>     &boundary;
    const std::vector<MaterialFields>      materials;
    const bool                             with_inertia;

    /** Terms in the nodal basis until an operator is made of them: they would
     * be a third of the memory, and to assemble them anew takes as long as the
     * rest of a new contact mapping. */
    std::unique_ptr<ElasticMatrices<n_components>> nodal_terms;
    /** Terms that there are. */
    std::vector<Term>   terms;
    std::vector<double> masses;
    /** Empty without gravity. */
    NodalVector gravity_load;
    /** In the jump basis, empty without a background stress. */
    NodalVector  fault_load;
    PartnerForce partners;
    /** The constant part of the load if tractions are, once somebody has asked
     * for it with this contact mapping. */
    std::unique_ptr<const NodalVector> constant_load;

    std::unique_ptr<OperatorSum<n_components>>    operator_sum;
    std::unique_ptr<LevelHierarchy<n_components>> levels;
  };
} // namespace StickSlip

#endif
