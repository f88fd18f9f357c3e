// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_initial_equilibrium_h
#define stickslip_problem_initial_equilibrium_h

#include <stickslip/problem/spatial_problem.h>

namespace StickSlip
{
  /**
   * The static equilibrium under gravity with all faults stuck, from which a
   * run starts.
   */
  template <int dim>
  struct InitialEquilibrium
  {
    /** Nodal displacement, m. */
    NodalVector displacement;

    /** Contact pressure at each slave node, Pa, see contact_pressures(). */
    std::vector<double> contact_pressure;

    /** Shear traction at each slave node that keeps the fault stuck, slave
     * relative to master, Pa; zero off contact. */
    std::vector<Tensor<1, dim - 1>> shear_traction;

    unsigned int iterations = 0;
  };

  /**
   * Solve K w = load, in the jump basis, for all components that are not fixed
   * but the jumps, which stay as they are in @p w, and so do those that are
   * fixed: by CG with a V-cycle. Returns the number of iterations. Throws
   * AgreedFailure if that does not converge. Changes the operator and its
   * linearisation. Collective.
   */
  template <int dim, int n_components = dim>
  unsigned int
  solve_with_known_jumps(SpatialProblem<dim, n_components> &problem,
                         const NodalVector                 &load,
                         NodalVector                       &w);

  /**
   * Solve for the equilibrium by CG with a V-cycle. Prescribed velocities count
   * as zero displacements. Throws AgreedFailure if that does not converge.
   */
  template <int dim, int n_components = dim>
  InitialEquilibrium<dim>
  solve_initial_equilibrium(SpatialProblem<dim, n_components> &problem);
} // namespace StickSlip

#endif
