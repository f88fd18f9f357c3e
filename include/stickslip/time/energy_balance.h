// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_energy_balance_h
#define stickslip_time_energy_balance_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/lumped_mass.h>
#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace StickSlip
{
  /**
   * Changes of the energy of the bodies, J (per m in plane strain).
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
    /** Taken by sides that come together and by bonds that break, positive. */
    double contact = 0;
    /** Added by new contact mappings: velocities that change there, and
     * work of the PartnerForce. */
    double mappings = 0;

    /** Sum of all, as it adds to the kinetic and elastic energy. */
    double
    gain() const
    {
      return loads + driven_sides + mappings - viscosity - friction -
             radiation - contact;
    }

    /** The largest of all, without its sign. */
    double
    largest() const
    {
      return std::max({std::abs(loads),
                       std::abs(driven_sides),
                       viscosity,
                       friction,
                       radiation,
                       contact});
    }

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &loads &driven_sides &viscosity &friction &radiation &contact
        &mappings;
    }
  };

  /**
   * Account of the energy since the start of a run.
   */
  struct EnergyAccount
  {
    /** Kinetic and elastic energy at the start, J. */
    double initial_energy = 0;

    /** Forces of friction and of radiation damping in the last state taken in,
     * over the slave nodes, N: of the first component of all, then of the
     * next. */
    std::vector<double> friction_forces, radiation_forces;

    /** Work since the start. */
    EnergyTerms work;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &initial_energy &friction_forces &radiation_forces &work;
    }
  };

  /**
   * Keeps account of the energy in a run. With the equation of motion
   *
   *   M a + C v + K u + friction + radiation = f + forces at driven sides,
   *
   * kinetic and elastic energy change by the work of the loads and of the
   * driven sides less what viscosity, friction and radiation damping dissipate.
   * Without inertia there is no kinetic energy. The work of a force in a step
   * is the mean of the force at both ends on the change of the displacement,
   * as Newmark's method has it, and the equation at both ends without mass: the
   * balance is exact then. Central differences have it so as well, with the
   * viscous forces half a step before and with
   *
   *   1/2 v . M v - tau^2/8 a . M a
   *
   * as kinetic energy, the product of the velocities half a step before and
   * after, where the step was of size tau. Friction is taken from the law at
   * the state and slip rate that are written, so that what is missing is what
   * iterations leave of the step.
   */
  template <int dim, int n_components = dim>
  class EnergyBalance
  {
  public:
    /** Work with one contact mapping. @p lumped_mass: of central differences,
     * null for other steps. All must live longer. */
    EnergyBalance(SpatialProblem<dim, n_components>   &problem,
                  const FaultNodes<dim>               &faults,
                  const NodeLaws                      &laws,
                  EnergyAccount                       &account,
                  const LumpedMass<dim, n_components> *lumped_mass = nullptr);

    /** Keep the account from @p state on. Collective, as the next three. */
    void
    start(const SystemState<dim> &state);

    /** Go on with a new contact mapping and the velocities of @p state; @p
     * kinetic_energy: before that, J. */
    void
    restart(const SystemState<dim> &state, const double kinetic_energy);

    /** Go on from the last state taken in, which is @p state. */
    void
    resume(const SystemState<dim> &state);

    /** Add a step from the last state taken in. @p tractions: those at its
     * end, by shear_tractions(), which others need as well. */
    void
    add(const StepResult<dim>                 &step,
        const std::vector<Tensor<1, dim - 1>> &tractions);

    /** Work since the start. */
    const EnergyTerms &
    work() const
    {
      return account.work;
    }

    /** Kinetic energy, see above, and 1/2 u . K u, J. Collective. */
    double
    kinetic_energy(const SystemState<dim> &state) const;

    double
    elastic_energy(const SystemState<dim> &state) const;

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
    /** Add a step of size @p tau that is one. */
    void
    add_part(const StepResult<dim>                 &step,
             const double                           tau,
             const std::vector<Tensor<1, dim - 1>> &tractions);

    /** Set the forces of faults to those of these tractions and slip rates. */
    void
    set_fault_forces(const std::vector<Tensor<1, dim - 1>> &tractions,
                     const std::vector<Tensor<1, dim - 1>> &slip_rate);

    /** One time of the run, in the jump basis. */
    struct Moment
    {
      double      time = 0.;
      NodalVector displacement, velocity;
      /** The velocity half a step before; empty but with central differences.
       */
      NodalVector velocity_before;
      /** Empty where the load is constant. */
      NodalVector load;

      /** The velocity that viscous forces are of. */
      const NodalVector &
      viscous_velocity() const
      {
        return velocity_before.size() > 0 ? velocity_before : velocity;
      }

      /** Force without inertia, N, and momentum, kg m/s, at the entries of
       * driven; NaN where nobody has asked. */
      std::vector<double> force, momentum;
    };

    /** Set a moment to that of @p state, at another @p velocity. */
    void
    set(Moment                 &moment,
        const SystemState<dim> &state,
        const NodalVector      &velocity) const;

    /** The load at a moment, N. */
    const NodalVector &
    load(const Moment &moment) const
    {
      return problem.has_constant_load() ? constant_load : moment.load;
    }

    /** Work of the loads in the change of the displacement, and what viscosity
     * dissipates, J, between last and end, a time @p tau from each other.
     * @p has_mean: if the change is not that of the mean of both velocities.
     * Collective, as the next three. */
    double
    loads_work() const;

    /** The part of loads_work() that the PartnerForce does. */
    double
    partner_work() const;

    double
    viscous_work(const double tau, const bool has_mean) const;

    /** Work of forces at sides of prescribed velocity, J, between last and end,
     * a time @p tau from each other. */
    double
    driven_work(const double tau) const;

    /** Find force and momentum of a moment at the k-th entry of driven, if they
     * are not known. */
    void
    find_force(Moment &moment, const unsigned int k) const;

    /** Work that sides of prescribed velocity do in impacts, J: the impulses
     * that keep them at their velocities of end, while those of bodies jump by
     * @p velocity_change, in the jump basis. */
    double
    driven_work_of_impacts(const NodalVector &velocity_change) const;

    /** 1/2 x . A x of nodal values and a matrix in the jump basis. */
    template <typename Matrix>
    double
    quadratic_form(const Matrix &A, const NodalVector &x) const;

    SpatialProblem<dim, n_components> &problem;
    const FaultNodes<dim>             &faults;
    const NodeLaws                    &laws;
    EnergyAccount                     &account;
    /** Null where the mass is that of the problem. */
    const LumpedMass<dim, n_components> *const lumped_mass;

    /** Entries of owned nodes that are fixed, node after node. */
    const std::vector<unsigned int> driven;

    /** Empty where the load changes in time. */
    NodalVector constant_load;

    /** The last state taken in, the end of a step, and the change of the
     * displacement in it. */
    std::unique_ptr<Moment> last, end;
    NodalVector             change;

    /** Slip rates of the last state taken in, m/s. */
    std::vector<Tensor<1, dim - 1>> last_slip_rate;
  };
} // namespace StickSlip

#endif
