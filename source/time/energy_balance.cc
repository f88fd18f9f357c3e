// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/energy_balance.h>

#include <vector>

namespace StickSlip
{
  namespace
  {
    /** One component of one row of A x. */
    template <int n_components>
    double
    row_product(const BlockMatrix<n_components> &A,
                const unsigned int               row,
                const unsigned int               component,
                const NodalVector               &x)
    {
      const BlockSparsity &sparsity = A.sparsity();
      double               sum      = 0.;
      for (unsigned int position = sparsity.row_start[row];
           position < sparsity.row_start[row + 1];
           ++position)
        for (unsigned int d = 0; d < n_components; ++d)
          sum += A.block(position)[component * n_components + d] *
                 x.begin()[sparsity.column[position] * n_components + d];
      return sum;
    }
  } // namespace



  template <int dim, int n_components>
  EnergyBalance<dim, n_components>::EnergyBalance(
    SpatialProblem<dim, n_components> &problem,
    const FaultNodes<dim>             &faults,
    const NodeLaws                    &laws,
    EnergyAccount                     &account)
    : problem(problem)
    , faults(faults)
    , laws(laws)
    , account(account)
    , change(problem.make_vector())
  {
    last.displacement = last.velocity = last.viscous_force = change;
    end                                                    = last;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::start(const SystemState<dim> &state)
  {
    account                = EnergyAccount();
    account.initial_energy = kinetic_energy(state) + elastic_energy(state);
    restart(state);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::restart(const SystemState<dim> &state)
  {
    resume(state);
    set_fault_forces(state, state.slip_rate);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::resume(const SystemState<dim> &state)
  {
    set(last, state, state.velocity);
    last_slip_rate = state.slip_rate;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::set(Moment                 &moment,
                                        const SystemState<dim> &state,
                                        const NodalVector      &velocity) const
  {
    problem.to_jumps(moment.displacement, state.displacement);
    problem.to_jumps(moment.velocity, velocity);
    moment.load = problem.load(state.time);
    if (problem.has(SpatialProblem<dim, n_components>::damping))
      problem.term(SpatialProblem<dim, n_components>::damping)
        .vmult(moment.viscous_force, moment.velocity);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::add(const StepResult<dim> &step)
  {
    double tau = step.step_size;
    if (step.before_contact)
      {
        add_part(*step.before_contact, step.before_contact->step_size);
        tau -= step.before_contact->step_size;
      }
    add_part(step, tau);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::add_part(const StepResult<dim> &step,
                                             const double           tau)
  {
    const SystemState<dim> &to = step.state;
    const bool  has_impact     = step.velocity_before_impacts.size() > 0;
    const auto &slip_rate =
      has_impact ? step.slip_rate_before_impacts : to.slip_rate;

    set(end, to, has_impact ? step.velocity_before_impacts : to.velocity);
    if (to.mean_velocity.size() > 0)
      problem.to_jumps(change, to.mean_velocity);
    else
      {
        change = end.velocity;
        change.sadd(0.5, 0.5, last.velocity);
      }
    change *= tau;

    EnergyTerms &work = account.work;
    work.loads += 0.5 * (last.load * change + end.load * change);
    if (problem.has(SpatialProblem<dim, n_components>::damping))
      work.viscosity +=
        0.5 * (last.viscous_force * change + end.viscous_force * change);
    work.driven_sides += driven_work(tau);
    if (has_impact)
      {
        change = end.velocity;
        set(end, to, to.velocity);
        change.sadd(-1., 1., end.velocity);
        work.driven_sides += driven_work_of_impacts(change);
      }
    std::swap(last, end);

    const std::vector<double> friction_before =
                                std::move(account.friction_forces),
                              radiation_before =
                                std::move(account.radiation_forces);
    set_fault_forces(to, slip_rate);
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
    const SystemState<dim>                &state,
    const std::vector<Tensor<1, dim - 1>> &slip_rate)
  {
    account.friction_forces.assign((dim - 1) * faults.size(), 0.);
    account.radiation_forces = account.friction_forces;
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        // Forces at nodes of known slip rate are those of driven sides.
        if (faults.weights()[k] <= 0. || laws[k].is_prescribed)
          continue;
        const double V = magnitude(slip_rate[k]);
        // Nodes at rest have the traction that balances all others.
        const Tensor<1, dim - 1> traction =
          V == 0. ? shear_traction(faults, laws, state, k) :
                    state.normal_stress[k] *
                      laws[k].friction->coefficient(
                        V, laws[k].friction->node_data(state.alpha[k])) /
                      V * slip_rate[k];
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const unsigned int i       = d * faults.size() + k;
            account.friction_forces[i] = faults.weights()[k] * traction[d];
            account.radiation_forces[i] =
              faults.weights()[k] * laws[k].radiation_damping * slip_rate[k][d];
          }
      }
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::driven_work(const double tau) const
  {
    using Problem = SpatialProblem<dim, n_components>;

    const bool has_mass = problem.has(Problem::mass);
    for (const Moment *const moment : {&last, &end})
      {
        update_ghosts(moment->displacement);
        if (has_mass)
          update_ghosts(moment->velocity);
      }
    // Prescribed velocities are the only ones that are not zero where a
    // component is fixed; without mass, normal jumps are not zero in the first
    // step with a new contact mapping.
    const LevelDescription<n_components> &finest = problem.hierarchy().finest();
    double                                work   = 0.;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const unsigned int position = i * n_components + c;
          if (finest.fixed.is_active(i, c) ||
              (last.velocity.local_element(position) == 0. &&
               end.velocity.local_element(position) == 0.))
            continue;
          double force = 0.;
          for (const Moment *const moment : {&last, &end})
            force += 0.5 * (row_product(problem.term(Problem::stiffness),
                                        i,
                                        c,
                                        moment->displacement) +
                            moment->viscous_force.local_element(position) -
                            moment->load.local_element(position));
          if (has_mass)
            force +=
              (row_product(problem.term(Problem::mass), i, c, end.velocity) -
               row_product(problem.term(Problem::mass), i, c, last.velocity)) /
              tau;
          work += force * change.local_element(position);
        }
    return Utilities::MPI::sum(work, finest.nodes.communicator());
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::driven_work_of_impacts(
    const NodalVector &velocity_change) const
  {
    const LevelDescription<n_components> &finest = problem.hierarchy().finest();
    const BlockMatrix<n_components>      &mass =
      problem.term(SpatialProblem<dim, n_components>::mass);
    update_ghosts(velocity_change);
    double work = 0.;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const double velocity =
            end.velocity.local_element(i * n_components + c);
          if (!finest.fixed.is_active(i, c) && velocity != 0.)
            work += velocity * row_product(mass, i, c, velocity_change);
        }
    return Utilities::MPI::sum(work, finest.nodes.communicator());
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::quadratic_form(
    const typename SpatialProblem<dim, n_components>::Term term,
    const NodalVector                                     &x) const
  {
    NodalVector w = problem.make_vector(), product = w;
    problem.to_jumps(w, x);
    problem.term(term).vmult(product, w);
    return 0.5 * (w * product);
  }



  template class EnergyBalance<2>;
  template class EnergyBalance<3>;
  template class EnergyBalance<2, 1>;
} // namespace StickSlip
