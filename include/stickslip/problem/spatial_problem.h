// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_spatial_problem_h
#define stickslip_problem_spatial_problem_h

#include <stickslip/faults/background_stress.h>
#include <stickslip/faults/prestress.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/equation_of_motion.h>

namespace StickSlip
{
  /**
   * The problem after discretisation in space: the contact space and the
   * equation of motion in its jump basis, which change together with the
   * contact mapping.
   */
  template <int dim, int n_components = dim>
  class SpatialProblem : public ContactSpace<dim, n_components>,
                         public EquationOfMotion<dim, n_components>
  {
  public:
    /** Couples the faults as they are without displacement; for the arguments
     * see ContactSpace and EquationOfMotion. Throws InputError if a background
     * stress has no value at a node. */
    SpatialProblem(const MeshHierarchy<dim>             &meshes,
                   const std::vector<MaterialFields>    &materials,
                   BoundaryValues<dim, n_components>    &boundary_values,
                   const Tensor<1, dim>                 &gravity,
                   const bool                            with_inertia = true,
                   const std::vector<SlipRates<dim>>    &slip_rates   = {},
                   const BackgroundStress<dim>          &background_stress = {},
                   const std::vector<OpeningParts<dim>> &opening = {});

    SpatialProblem(const SpatialProblem &) = delete;

    SpatialProblem &
    operator=(const SpatialProblem &) = delete;

    /**
     * Couple the faults as they are after a displacement, m, with everything
     * that depends on it. @p expected_slip: of each slave node until the next
     * time, m, which tells along which chords faults that bend are coupled
     * (SecantCoupling); empty: nothing slides. Throws AgreedFailure if the
     * sides of a fault do not touch any more; all is as before then.
     * Collective.
     */
    void
    build_contact(const NodalVector                     &displacement,
                  const std::vector<Tensor<1, dim - 1>> &expected_slip = {});

    const BackgroundStress<dim> &
    background_stress() const
    {
      return background;
    }

    /** Let shear stresses act on the faults that the bodies do not carry, from
     * now on with any contact mapping: Pa, at each slave node, slave relative
     * to master; empty for none. */
    void
    set_prestress(const std::vector<Tensor<1, dim - 1>> &shear_stress);

  private:
    /** Set the load of what acts on faults only. */
    void
    load_faults();

    BackgroundStress<dim>           background;
    std::vector<Tensor<1, dim - 1>> prestress;
  };
} // namespace StickSlip

#endif
