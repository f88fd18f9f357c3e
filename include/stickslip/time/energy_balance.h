// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_energy_balance_h
#define stickslip_time_energy_balance_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * Rates at which the energy of the bodies changes, W (per m in plane
   * strain), or their integrals over time, J.
   */
  struct EnergyTerms
  {
    /** Gravity, prescribed tractions and background stresses on faults. */
    double loads = 0;
    /** Forces that prescribed velocities need. */
    double driven_sides = 0;
    /** Dissipated by viscosity, by friction and by radiation damping,
     * positive. */
    double viscosity = 0, friction = 0, radiation = 0;
    /** Taken by sides that come together and by bonds that break, positive:
     * step by step, not as a power. */
    double contact = 0;

    /** Sum of all, as it adds to the kinetic and elastic energy. */
    double
    gain() const
    {
      return loads + driven_sides - viscosity - friction - radiation - contact;
    }

    /** *this += factor * other. */
    void
    add(const double factor, const EnergyTerms &other);

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &loads &driven_sides &viscosity &friction &radiation &contact;
    }
  };

  /**
   * Account of the energy since the start of a run.
   */
  struct EnergyAccount
  {
    /** Kinetic and elastic energy at the start, J. */
    double initial_energy = 0;

    /** Powers in the last state taken in. */
    EnergyTerms last_powers;

    /** Work since the start. */
    EnergyTerms work;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &initial_energy &last_powers &work;
    }
  };

  /**
   * Keeps account of the energy in a run. With the equation of motion
   *
   *   M a + C v + K u + friction + radiation = f + forces at driven sides,
   *
   * kinetic and elastic energy change by the work of the loads and of the
   * driven sides less what viscosity, friction and radiation damping dissipate.
   * Without inertia there is no kinetic energy. Friction is taken
   * from the law, not from the equation; its forces and all others are
   * integrated over time by the trapezoidal rule. The defect then is the error
   * of time stepping and solver as the energy sees it, of second order in the
   * step size.
   */
  template <int dim, int n_components = dim>
  class EnergyBalance
  {
  public:
    /** Powers with one contact mapping. All must live longer. */
    EnergyBalance(SpatialProblem<dim, n_components> &problem,
                  const FaultNodes<dim>             &faults,
                  const NodeLaws                    &laws,
                  EnergyAccount                     &account)
      : problem(problem)
      , faults(faults)
      , laws(laws)
      , account(account)
    {}

    /** Keep the account from @p state on. Collective, as the next two. */
    void
    start(const SystemState<dim> &state);

    /** Add a step to @p state of size @p tau, before the contact mapping
     * follows it; @p contact: what goes the way of faults that open in it. */
    void
    add(const SystemState<dim> &state,
        const double            tau,
        const ContactEnergy    &contact);

    /** Go on from @p state after contact mapping and velocities have changed;
     * the energy that this adds or takes goes into the defect. */
    void
    restart(const SystemState<dim> &state);

    /** Work since the start. */
    const EnergyTerms &
    work() const
    {
      return account.work;
    }

    /** 1/2 v . M v and 1/2 u . K u, J. Collective. */
    double
    kinetic_energy(const SystemState<dim> &state) const
    {
      return problem.has(SpatialProblem<dim, n_components>::mass) ?
               quadratic_form(SpatialProblem<dim, n_components>::mass,
                              state.velocity) :
               0.;
    }

    double
    elastic_energy(const SystemState<dim> &state) const
    {
      return quadratic_form(SpatialProblem<dim, n_components>::stiffness,
                            state.displacement);
    }

    /** The change of kinetic and elastic energy since the start that is not
     * in work(), J. Collective. */
    double
    defect(const SystemState<dim> &state) const
    {
      return missing(kinetic_energy(state) + elastic_energy(state));
    }

    /** Defect where the sum of kinetic and elastic energy is known. */
    double
    missing(const double energy) const
    {
      return energy - account.initial_energy - account.work.gain();
    }

  private:
    /** Powers at one time. */
    EnergyTerms
    powers(const SystemState<dim> &state) const;

    /** 1/2 x . A x of nodal values and a term of the problem. */
    double
    quadratic_form(const typename SpatialProblem<dim, n_components>::Term term,
                   const NodalVector &x) const;

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;
    EnergyAccount                     &account;
  };
} // namespace StickSlip

#endif
