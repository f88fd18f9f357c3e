// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/problem/known_velocities.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/energy_balance.h>

#include <limits>
#include <vector>

namespace StickSlip
{
  namespace
  {
    /** One component of one row of A x; @p buffer is memory for the row. */
    template <int n_components>
    double
    row_product(const TermMatrix<n_components> &A,
                const unsigned int              row,
                const unsigned int              component,
                const NodalVector              &x,
                std::vector<double>            &buffer)
    {
      const BlockSparsity &sparsity = A.sparsity();
      const double *numbers = A.row(row, buffer) + component * n_components;
      double        sum     = 0.;
      for (unsigned int position = sparsity.row_start[row];
           position < sparsity.row_start[row + 1];
           ++position, numbers += n_components * n_components)
        for (unsigned int d = 0; d < n_components; ++d)
          sum += numbers[d] *
                 x.begin()[sparsity.column[position] * n_components + d];
      return sum;
    }
  } // namespace



  template <int dim, int n_components>
  EnergyBalance<dim, n_components>::EnergyBalance(
    SpatialProblem<dim, n_components>   &problem,
    const FaultNodes<dim>               &faults,
    const NodeLaws                      &laws,
    EnergyAccount                       &account,
    const LumpedMass<dim, n_components> *lumped_mass)
    : problem(problem)
    , faults(faults)
    , laws(laws)
    , account(account)
    , lumped_mass(lumped_mass)
    , driven(fixed_entries(problem.operators().unknowns()))
    , last(std::make_unique<Moment>())
    , end(std::make_unique<Moment>())
    , change(problem.make_vector())
  {
    last->displacement = last->velocity = change;
    *end                                = *last;
  }



  template <int dim, int n_components>
  template <typename Matrix>
  double
  EnergyBalance<dim, n_components>::quadratic_form(const Matrix      &A,
                                                   const NodalVector &x) const
  {
    NodalVector w = problem.make_vector(), product = w;
    problem.to_jumps(w, x);
    A.vmult(product, w);
    return 0.5 * (w * product);
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::kinetic_energy(
    const SystemState<dim> &state) const
  {
    using Problem = SpatialProblem<dim, n_components>;
    if (lumped_mass)
      return quadratic_form(*lumped_mass, state.velocity) -
             state.last_step * state.last_step / 4. *
               quadratic_form(*lumped_mass, state.acceleration);
    return problem.has(Problem::mass) ?
             quadratic_form(problem.term(Problem::mass), state.velocity) :
             0.;
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::elastic_energy(
    const SystemState<dim> &state) const
  {
    return quadratic_form(problem.term(
                            SpatialProblem<dim, n_components>::stiffness),
                          state.displacement);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::start(const SystemState<dim> &state)
  {
    account                = EnergyAccount();
    account.initial_energy = kinetic_energy(state) + elastic_energy(state);
    resume(state);
    set_fault_forces(shear_tractions(faults, laws, state), state.slip_rate);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::restart(const SystemState<dim> &state,
                                            const double kinetic_energy)
  {
    account.work.mappings += this->kinetic_energy(state) - kinetic_energy;
    resume(state);
    set_fault_forces(shear_tractions(faults, laws, state), state.slip_rate);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::resume(const SystemState<dim> &state)
  {
    if (problem.has_constant_load())
      constant_load = problem.load(state.time);
    set(*last, state, state.velocity);
    last_slip_rate = state.slip_rate;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::set(Moment                 &moment,
                                        const SystemState<dim> &state,
                                        const NodalVector      &velocity) const
  {
    moment.time = state.time;
    problem.to_jumps(moment.displacement, state.displacement);
    problem.to_jumps(moment.velocity, velocity);
    if (!problem.has_constant_load())
      moment.load = problem.load(state.time);
    update_ghosts(moment.displacement);
    update_ghosts(moment.velocity);
    moment.force.assign(driven.size(),
                        std::numeric_limits<double>::quiet_NaN());
    moment.momentum = moment.force;
    if (!lumped_mass)
      return;
    NodalVector product = problem.make_vector();
    lumped_mass->vmult(product, moment.velocity);
    for (unsigned int k = 0; k < driven.size(); ++k)
      moment.momentum[k] = product.local_element(driven[k]);
    moment.velocity_before = moment.velocity;
    if (state.mean_velocity.size() > 0)
      {
        problem.to_jumps(moment.velocity_before, state.mean_velocity);
        update_ghosts(moment.velocity_before);
      }
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::add(
    const StepResult<dim>                 &step,
    const std::vector<Tensor<1, dim - 1>> &tractions)
  {
    double tau = step.step_size;
    if (const auto &before = step.before_contact)
      {
        add_part(*before,
                 before->step_size,
                 shear_tractions(faults, laws, before->state));
        tau -= before->step_size;
      }
    add_part(step, tau, tractions);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::add_part(
    const StepResult<dim>                 &step,
    const double                           tau,
    const std::vector<Tensor<1, dim - 1>> &tractions)
  {
    const SystemState<dim> &to = step.state;
    const bool  has_impact     = step.velocity_before_impacts.size() > 0;
    const auto &slip_rate =
      has_impact ? step.slip_rate_before_impacts : to.slip_rate;

    set(*end, to, has_impact ? step.velocity_before_impacts : to.velocity);
    const bool has_mean = to.mean_velocity.size() > 0;
    if (has_mean)
      {
        if (lumped_mass)
          change = end->velocity_before;
        else
          problem.to_jumps(change, to.mean_velocity);
        change *= tau;
      }
    else
      {
        const unsigned int  n      = change.locally_owned_size();
        const double *const v_last = last->velocity.begin();
        const double *const v_end  = end->velocity.begin();
        double *const       du     = change.begin();
        for (unsigned int i = 0; i < n; ++i)
          du[i] = tau * (0.5 * v_last[i] + 0.5 * v_end[i]);
      }

    EnergyTerms &work        = account.work;
    const double of_partners = partner_work();
    work.mappings += of_partners;
    work.loads += loads_work() - of_partners;
    if (problem.has(SpatialProblem<dim, n_components>::damping))
      work.viscosity += viscous_work(tau, has_mean);
    work.driven_sides += driven_work(tau);
    if (has_impact)
      {
        change = end->velocity;
        set(*end, to, to.velocity);
        change.sadd(-1., 1., end->velocity);
        work.driven_sides += driven_work_of_impacts(change);
      }
    std::swap(last, end);

    const std::vector<double> friction_before =
                                std::move(account.friction_forces),
                              radiation_before =
                                std::move(account.radiation_forces);
    set_fault_forces(has_impact ? shear_tractions(faults, laws, to, slip_rate) :
                                  tractions,
                     slip_rate);
    for (unsigned int d = 0, i = 0; d < dim - 1; ++d)
      for (unsigned int k = 0; k < faults.size(); ++k, ++i)
        {
          const double slip =
            tau * (to.mean_slip_rate.empty() ?
                     0.5 * (last_slip_rate[k][d] + slip_rate[k][d]) :
                     to.mean_slip_rate[k][d]);
          work.friction +=
            0.5 * (friction_before[i] + account.friction_forces[i]) * slip;
          work.radiation +=
            0.5 * (radiation_before[i] + account.radiation_forces[i]) * slip;
        }
    last_slip_rate = to.slip_rate;
    work.contact += step.contact_energy.lost;
    work.loads += step.contact_energy.of_offset;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::set_fault_forces(
    const std::vector<Tensor<1, dim - 1>> &tractions,
    const std::vector<Tensor<1, dim - 1>> &slip_rate)
  {
    account.friction_forces.assign((dim - 1) * faults.size(), 0.);
    account.radiation_forces = account.friction_forces;
    for (unsigned int k = 0; k < faults.size(); ++k)
      // Forces at nodes of known slip rate are those of driven sides.
      if (faults.in_contact(k) && !laws[k].is_prescribed)
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const unsigned int i       = d * faults.size() + k;
            account.friction_forces[i] = faults.weights()[k] * tractions[k][d];
            account.radiation_forces[i] =
              faults.weights()[k] * laws[k].radiation_damping * slip_rate[k][d];
          }
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::loads_work() const
  {
    if (problem.has_constant_load())
      return constant_load * change;
    return 0.5 * (last->load * change + end->load * change);
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::partner_work() const
  {
    const PartnerForce &partners = problem.partner_force();
    if (!partners.is_there())
      return 0.;
    NodalVector force = problem.make_vector();
    for (const Moment *moment : {last.get(), end.get()})
      partners.add(moment->time, 0.5, force);
    return force * change;
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::viscous_work(const double tau,
                                                 const bool   has_mean) const
  {
    const TermMatrix<n_components> &C =
      problem.term(SpatialProblem<dim, n_components>::damping);
    if (has_mean)
      {
        NodalVector force = change;
        C.vmult(force, change);
        return 0.5 * (force * last->viscous_velocity() +
                      force * end->viscous_velocity());
      }
    return C.quadratic_form(change) / tau;
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::driven_work(const double tau) const
  {
    // Prescribed velocities are the only ones that are not zero where a
    // component is fixed; without mass, normal jumps are not zero in the first
    // step with a new contact mapping.
    const bool has_mass = problem.has(SpatialProblem<dim, n_components>::mass);
    double     work     = 0.;
    for (unsigned int k = 0; k < driven.size(); ++k)
      {
        const unsigned int entry = driven[k];
        if (last->velocity.local_element(entry) == 0. &&
            end->velocity.local_element(entry) == 0.)
          continue;
        find_force(*last, k);
        find_force(*end, k);
        double force = 0.5 * (last->force[k] + end->force[k]);
        if (has_mass)
          force += (end->momentum[k] - last->momentum[k]) / tau;
        work += force * change.local_element(entry);
      }
    return Utilities::MPI::sum(work, change.get_mpi_communicator());
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::find_force(Moment            &moment,
                                               const unsigned int k) const
  {
    using Problem = SpatialProblem<dim, n_components>;
    if (!std::isnan(moment.force[k]))
      return;
    const unsigned int row       = driven[k] / n_components,
                       component = driven[k] % n_components;
    std::vector<double> buffer;
    const auto          product = [&](const typename Problem::Term term,
                             const NodalVector           &x) {
      return row_product(problem.term(term), row, component, x, buffer);
    };
    moment.force[k] = product(Problem::stiffness, moment.displacement) -
                      load(moment).local_element(driven[k]);
    if (problem.has(Problem::damping))
      moment.force[k] += product(Problem::damping, moment.viscous_velocity());
    if (problem.has(Problem::mass) && !lumped_mass)
      moment.momentum[k] = product(Problem::mass, moment.velocity);
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::driven_work_of_impacts(
    const NodalVector &velocity_change) const
  {
    const TermMatrix<n_components> &mass =
      problem.term(SpatialProblem<dim, n_components>::mass);
    update_ghosts(velocity_change);
    std::vector<double> buffer;
    double              work = 0.;
    for (const unsigned int entry : driven)
      if (const double velocity = end->velocity.local_element(entry);
          velocity != 0.)
        work += velocity * row_product(mass,
                                       entry / n_components,
                                       entry % n_components,
                                       velocity_change,
                                       buffer);
    return Utilities::MPI::sum(work, change.get_mpi_communicator());
  }



  template class EnergyBalance<2>;
  template class EnergyBalance<3>;
  template class EnergyBalance<2, 1>;
} // namespace StickSlip
