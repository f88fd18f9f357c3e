// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_central_differences_h
#define stickslip_time_central_differences_h

#include <stickslip/faults/fault_functional.h>
#include <stickslip/problem/lumped_mass.h>
#include <stickslip/problem/system_state.h>

#include <memory>
#include <vector>

namespace StickSlip
{
  /**
   * A time step by central differences with a lumped mass (LumpedMass), for
   * bodies with inertia and faults that do not open: with the velocity v* in
   * the middle of a step of size tau,
   *
   *   v* = v0 + tau/2 a0,   u1 = u0 + tau v*,
   *   M a1 = f1 - K u1 - C v* - friction(v1),   v1 = v* + tau/2 a1.
   *
   * The state follows the slip rate of v*. Friction is that of the slip rate at
   * the end, which each node of a fault has by itself, so that faults may stick
   * and no rate problem is solved. All is of second order, but viscous forces
   * that are half a step old.
   *
   * Without friction, and with steps of one size,
   *
   *   1/2 v.M v - tau^2/8 a.M a + 1/2 u.K u
   *
   * changes by the work of all forces, the means of both ends times the change
   * of u, as with Newmark's method; see Belytschko, Liu, Moran and Elkhodary
   * (2014), section 6.2.
   */
  template <int dim, int n_components = dim>
  class CentralDifferences
  {
  public:
    /** Steps with one contact mapping. All must live longer. Collective. */
    CentralDifferences(SpatialProblem<dim, n_components> &problem,
                       const FaultNodes<dim>             &faults,
                       const NodeLaws                    &laws);

    /** A step of size @p tau from @p from; it fails if its end is no number.
     * Collective. */
    StepResult<dim>
    take(const SystemState<dim> &from, const double tau);

    /**
     * The longest step without growing oscillations, s: the largest tau for
     * which
     *
     *   x . (M - tau/2 C - tau^2/4 K) x >= 0
     *
     * for all x, by the power method from below, to a thousandth or so. Faults
     * count as free of friction, which only helps.
     */
    double
    stability_limit() const;

    const LumpedMass<dim, n_components> &
    lumped_mass() const
    {
      return mass;
    }

  private:
    /** Bring known_velocity to @p time. */
    void
    update_known_velocity(const double time);

    /** Forces on the bodies at @p time but friction, in the jump basis, N. */
    NodalVector
    forces(const double       time,
           const NodalVector &displacement,
           const NodalVector &velocity);

    /** Set the accelerations of the jumps of owned nodes under friction in @p
     * a, with those of all other nodes as if no jump changed; returns the
     * forces that friction balances, at the same entries. */
    NodalVector
    accelerate_jumps(NodalVector       &a,
                     const NodalVector &force,
                     const NodalVector &velocity,
                     const double       tau) const;

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;

    const LumpedMass<dim, n_components>          mass;
    std::unique_ptr<FaultFriction<n_components>> friction;

    /** Entries whose velocity is known, this velocity, m/s, in the jump basis,
     * and whether it stays. */
    const std::vector<unsigned int> known_entries;
    NodalVector                     known_velocity;
    bool                            is_known_steady = false;
    /** The load when it was asked for last. */
    NodalVector load;
  };
} // namespace StickSlip

#endif
