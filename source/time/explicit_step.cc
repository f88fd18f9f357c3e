// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/faults/contact_pressure.h>
#include <stickslip/faults/fault_norm.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/explicit_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int n_stages = 7;

    /** Weights of the stages before each one, of which the last is the step,
     * the part of the step that is over, and the error. */
    constexpr double weights[n_stages][n_stages - 1] = {
      {},
      {1. / 5.},
      {3. / 40., 9. / 40.},
      {44. / 45., -56. / 15., 32. / 9.},
      {19372. / 6561., -25360. / 2187., 64448. / 6561., -212. / 729.},
      {9017. / 3168., -355. / 33., 46732. / 5247., 49. / 176., -5103. / 18656.},
      {35. / 384., 0., 500. / 1113., 125. / 192., -2187. / 6784., 11. / 84.}};
    constexpr double parts[n_stages] =
      {0., 1. / 5., 3. / 10., 4. / 5., 8. / 9., 1., 1.};
    constexpr double error_weights[n_stages] = {71. / 57600.,
                                                0.,
                                                -71. / 16695.,
                                                71. / 1920.,
                                                -17253. / 339200.,
                                                22. / 525.,
                                                -1. / 40.};



    bool
    are_numbers(const std::vector<double> &values)
    {
      return std::all_of(values.begin(), values.end(), [](const double x) {
        return std::isfinite(x);
      });
    }



    /** values += factor * rates. */
    void
    add(std::vector<double>       &values,
        const double               factor,
        const std::vector<double> &rates)
    {
      for (unsigned int k = 0; k < values.size(); ++k)
        values[k] += factor * rates[k];
    }



    /** The sum over all processes of what each has. */
    void
    sum_up(std::vector<double> &values, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        Utilities::MPI::sum(values, communicator, values);
    }
  } // namespace



  template <int dim, int n_components>
  ExplicitStep<dim, n_components>::ExplicitStep(
    SpatialProblem<dim, n_components> &problem,
    const FaultNodes<dim>             &faults,
    const NodeLaws                    &laws,
    const FollowingStress<dim>        &following)
    : problem(problem)
    , faults(faults)
    , laws(laws)
    , following(following)
    , entries(problem.operators().unknowns())
    , friction(make_fault_friction<dim, n_components>(faults,
                                                      laws,
                                                      std::vector<double>(
                                                        faults.size())))
  {
    const std::vector<unsigned int> &nodes = faults.owned_contact();
    std::vector<std::pair<unsigned int, unsigned int>> here(entries.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        for (unsigned int d = 0; d < dim - 1; ++d)
          if (const unsigned int entry = entries.of_node[i][d];
              entry != numbers::invalid_unsigned_int)
            here[entry] = {nodes[i], d};
          else if (laws[nodes[i]].is_prescribed)
            known_entries.push_back(faults.node(nodes[i]) * n_components + d);
        if (following.is_needed() && n_components == dim)
          known_entries.push_back(faults.node(nodes[i]) * n_components +
                                  FaultAxes<dim>::normal_component);
      }
    const MPI_Comm communicator =
      problem.hierarchy().finest().nodes.communicator();
    const auto all = Utilities::MPI::all_gather(communicator, here);
    for (unsigned int p = 0; p < all.size(); ++p)
      {
        if (p == Utilities::MPI::this_mpi_process(communicator))
          first_place = places.size();
        places.insert(places.end(), all[p].begin(), all[p].end());
      }
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::prepare()
  {
    const NodePartition &nodes = problem.hierarchy().finest().nodes;
    condensed = std::make_unique<SchurComplement<n_components>>(
      problem.term(SpatialProblem<dim, n_components>::stiffness),
      nodes,
      problem.operators().unknowns().fixed,
      entries.positions,
      known_entries);
    if (!following.is_needed())
      return;
    NodalVector forces = problem.make_vector();
    pressures_of_slip.reserve(std::size_t(entries.size()) * faults.size());
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        for (unsigned int k = 0; k < known_entries.size(); ++k)
          forces.local_element(known_entries[k]) =
            condensed->row_of_known(k)[i];
        const std::vector<double> column =
          contact_pressures(problem.jump_basis(), nodes, forces);
        if (i >= first_place && i < first_place + entries.size())
          pressures_of_slip.insert(pressures_of_slip.end(),
                                   column.begin(),
                                   column.end());
      }
  }



  template <int dim, int n_components>
  bool
  ExplicitStep<dim, n_components>::slips_freely(const unsigned int k) const
  {
    return faults.in_contact(k) && !laws[k].is_prescribed;
  }



  template <int dim, int n_components>
  NodalVector
  ExplicitStep<dim, n_components>::known_velocities(const double time) const
  {
    NodalVector nodal = problem.make_nodal_vector(), w = problem.make_vector();
    problem.boundary_values().set_velocities(time, nodal);
    problem.to_jumps(w, nodal);
    problem.set_known_jumps(time, w);
    NodalVector free = w;
    problem.operators().unknowns().fixed.apply(free);
    w -= free;
    return w;
  }



  template <int dim, int n_components>
  NodalVector
  ExplicitStep<dim, n_components>::velocities_of_faults(
    const SystemState<dim> &state) const
  {
    NodalVector w = known_velocities(state.time);
    for (const unsigned int k : faults.owned_contact())
      if (slips_freely(k))
        for (unsigned int d = 0; d < dim - 1; ++d)
          w.local_element(faults.node(k) * n_components + d) =
            state.slip_rate[k][d];
    return w;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::restrict_to_eliminated(NodalVector &w) const
  {
    problem.operators().unknowns().fixed.apply(w);
    for (const unsigned int position : entries.positions)
      w.local_element(position) = 0.;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::balance(NodalVector       &w,
                                           const NodalVector &load)
  {
    NodalVector forces = problem.make_vector(), change = forces;
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(forces, load, w);
    restrict_to_eliminated(forces);
    condensed->solve_eliminated(change, forces);
    restrict_to_eliminated(change);
    w += change;
  }



  template <int dim, int n_components>
  typename ExplicitStep<dim, n_components>::Forces
  ExplicitStep<dim, n_components>::forces_of(const NodalVector &w,
                                             const NodalVector &load) const
  {
    NodalVector forces = problem.make_vector();
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(forces, load, w);
    Forces result;
    for (const unsigned int position : entries.positions)
      result.free.push_back(forces.local_element(position));
    for (const unsigned int position : known_entries)
      result.known.push_back(forces.local_element(position));
    if (following.is_needed())
      {
        forces *= -1.;
        result.pressure = contact_pressures(problem.jump_basis(),
                                            problem.hierarchy().finest().nodes,
                                            forces);
      }
    return result;
  }



  template <int dim, int n_components>
  typename ExplicitStep<dim, n_components>::Forces
  ExplicitStep<dim, n_components>::forces_in(const SystemState<dim> &state)
  {
    if (state.fault_force.empty())
      {
        NodalVector u = problem.make_vector();
        problem.to_jumps(u, state.displacement);
        const NodalVector load = problem.load(state.time);
        balance(u, load);
        return forces_of(u, load);
      }
    NodalVector forces = problem.make_vector();
    add_slip(forces, state.fault_force, 1.);
    Forces result;
    for (const unsigned int position : entries.positions)
      result.free.push_back(forces.local_element(position));
    for (const unsigned int position : known_entries)
      result.known.push_back(forces.local_element(position));
    if (following.is_needed())
      result.pressure = state.contact_pressure;
    return result;
  }



  template <int dim, int n_components>
  const typename ExplicitStep<dim, n_components>::Forces &
  ExplicitStep<dim, n_components>::driven_forces(const NodalVector &known,
                                                 const NodalVector &load_rate)
  {
    const bool load_varies = load_rate.linfty_norm() > 0.;
    const bool is_new      = driven_by.size() == 0 || load_varies ||
                        !std::equal(known.begin(),
                                    known.begin() + known.locally_owned_size(),
                                    driven_by.begin());
    if (Utilities::MPI::max(int(is_new), known.get_mpi_communicator()) > 0)
      {
        NodalVector w = known;
        balance(w, load_rate);
        driven    = forces_of(w, load_rate);
        driven_by = load_varies ? NodalVector() : known;
      }
    return driven;
  }



  template <int dim, int n_components>
  NodalVector
  ExplicitStep<dim, n_components>::load_rate(const double time,
                                             const double tau) const
  {
    NodalVector result = problem.load(time);
    result -= problem.load(time - tau);
    if (tau > 0.)
      result /= tau;
    return result;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::set_force_rates(
    Stage        &stage,
    const double  part,
    const Forces &drive,
    const Forces &drive_end) const
  {
    const auto between = [part](std::vector<double>       &result,
                                const std::vector<double> &first,
                                const std::vector<double> &second) {
      result.resize(first.size());
      for (unsigned int i = 0; i < first.size(); ++i)
        result[i] = (1. - part) * first[i] + part * second[i];
    };
    std::vector<double> product;
    condensed->multiply(product, stage.rates);
    between(stage.forces.free, drive.free, drive_end.free);
    add(stage.forces.free, -1., product);
    if (!following.is_needed())
      return;
    std::vector<double> pressure(faults.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      add_multiple(pressure.data(),
                   stage.rates[first_place + i],
                   pressures_of_slip.data() + std::size_t(i) * faults.size(),
                   faults.size());
    sum_up(pressure, problem.hierarchy().finest().nodes.communicator());
    between(stage.forces.pressure, drive.pressure, drive_end.pressure);
    add(stage.forces.pressure, 1., pressure);
  }



  template <int dim, int n_components>
  bool
  ExplicitStep<dim, n_components>::find_rates(
    Stage                     &stage,
    const std::vector<double> &alpha,
    const std::vector<double> &force,
    const std::vector<double> &normal_stress) const
  {
    // All processes have these, and return together.
    if (!are_numbers(alpha) || !are_numbers(normal_stress))
      return false;
    friction->set_normal_stresses(faults.at_owned_contact(normal_stress));
    friction->set_state(faults.at_owned_contact(alpha));
    const std::vector<unsigned int> &nodes = faults.owned_contact();
    const Tensor<2, n_components>    nothing;
    std::vector<double>              rates(entries.size(),
                              std::numeric_limits<double>::quiet_NaN());
    if (are_numbers(force))
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          Tensor<1, n_components>        r, start;
          std::array<bool, n_components> takes_part = {};
          for (unsigned int d = 0; d < dim - 1; ++d)
            if (entries.of_node[i][d] != numbers::invalid_unsigned_int)
              {
                takes_part[d] = true;
                r[d]          = force[entries.of_node[i][d]];
                start[d]      = stage.slip_rate[nodes[i]][d];
              }
          const Tensor<1, n_components> v =
            friction->minimise(i, nothing, r, takes_part, start);
          for (unsigned int d = 0; d < dim - 1; ++d)
            if (takes_part[d])
              rates[entries.of_node[i][d]] = v[d];
        }
    stage.rates = condensed->on_all(rates);
    if (!are_numbers(stage.rates))
      return false;
    for (unsigned int i = 0; i < places.size(); ++i)
      stage.slip_rate[places[i].first][places[i].second] = stage.rates[i];
    stage.state_rate.assign(faults.size(), 0.);
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (slips_freely(k) && laws[k].state_law)
        stage.state_rate[k] =
          laws[k].state_law->rate(alpha[k],
                                  magnitude(stage.slip_rate[k]),
                                  laws[k].characteristic_slip);
    return true;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::add_slip(NodalVector &w,
                                            const Slip  &rates,
                                            const double factor) const
  {
    for (const unsigned int k : faults.owned_contact())
      for (unsigned int d = 0; d < dim - 1; ++d)
        w.local_element(faults.node(k) * n_components + d) +=
          factor * rates[k][d];
  }



  template <int dim, int n_components>
  StepResult<dim>
  ExplicitStep<dim, n_components>::take(const SystemState<dim> &from,
                                        const double            tau,
                                        const double            tolerance,
                                        double                 &error)
  {
    if (!condensed)
      prepare();

    StepResult<dim> result;
    result.step_size                    = tau;
    result.counts.rate_state_iterations = n_stages;
    result.failure = "the estimated error stays above Time/Tolerance";
    error          = std::numeric_limits<double>::quiet_NaN();

    // The start of the step, and what drives it.
    const Forces      start     = forces_in(from);
    const NodalVector load_rate = this->load_rate(from.time + tau, tau),
                      known     = known_velocities(from.time),
                      known_end = known_velocities(from.time + tau);
    const Forces drive          = driven_forces(known, load_rate),
                 drive_end      = driven_forces(known_end, load_rate);

    // Stages, of which the last one is the end.
    std::array<Stage, n_stages> stages;
    // Slip rates that are prescribed may jump at the start of a run.
    const Slip known_slip     = faults.tangential_jumps(known),
               known_slip_end = faults.tangential_jumps(known_end);
    Forces              forces;
    std::vector<double> alpha, normal_stress;
    for (unsigned int i = 0; i < n_stages; ++i)
      {
        alpha  = from.alpha;
        forces = start;
        for (unsigned int j = 0; j < i; ++j)
          if (const double weight = tau * weights[i][j]; weight != 0.)
            {
              add(alpha, weight, stages[j].state_rate);
              add(forces.free, weight, stages[j].forces.free);
              if (following.is_needed())
                add(forces.pressure, weight, stages[j].forces.pressure);
            }
        normal_stress =
          following.is_needed() ?
            following.normal_stress(from.normal_stress, forces.pressure) :
            from.normal_stress;
        stages[i].slip_rate = i == 0 ? from.slip_rate : stages[i - 1].slip_rate;
        for (unsigned int k = 0; k < faults.size(); ++k)
          if (!slips_freely(k))
            stages[i].slip_rate[k] = known_slip_end[k];
        if (!find_rates(stages[i], alpha, forces.free, normal_stress))
          return result;
        // Nothing comes after the last one.
        if (i + 1 < n_stages)
          set_force_rates(stages[i], parts[i], drive, drive_end);
      }

    std::vector<double> state_errors(faults.size()), slip_errors(faults.size());
    SystemState<dim>   &to = result.state;
    to.mean_slip_rate.resize(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        const FaultLaw &law = laws[k];
        if (!slips_freely(k))
          {
            to.mean_slip_rate[k] = 0.5 * (known_slip[k] + known_slip_end[k]);
            if (law.state_law)
              alpha[k] = law.state_law->updated(StateUpdate::exponential,
                                                from.alpha[k],
                                                magnitude(to.mean_slip_rate[k]),
                                                law.characteristic_slip,
                                                tau);
            continue;
          }
        Tensor<1, dim - 1> slip_error;
        for (unsigned int i = 0; i < n_stages; ++i)
          {
            state_errors[k] += tau * error_weights[i] * stages[i].state_rate[k];
            slip_error += tau * error_weights[i] * stages[i].slip_rate[k];
            if (i + 1 < n_stages)
              to.mean_slip_rate[k] +=
                weights[n_stages - 1][i] * stages[i].slip_rate[k];
          }
        slip_errors[k] = magnitude(slip_error) / law.characteristic_slip;
      }
    error = std::hypot(fault_norm(faults, laws, state_errors),
                       fault_norm(faults, laws, slip_errors));
    if (!(error <= tolerance))
      return result;

    // Forces on known entries follow the mean rates.
    std::vector<double> mean_rates, product;
    for (const auto &[k, d] : places)
      mean_rates.push_back(to.mean_slip_rate[k][d]);
    condensed->multiply_known(product, mean_rates);
    add(forces.known, 0.5 * tau, drive.known);
    add(forces.known, 0.5 * tau, drive_end.known);
    add(forces.known, -tau, product);

    to.time                = from.time + tau;
    to.last_step           = tau;
    to.alpha               = alpha;
    to.slip_rate           = stages[n_stages - 1].slip_rate;
    to.normal_stress       = normal_stress;
    NodalVector mean_known = known;
    mean_known += known_end;
    mean_known *= 0.5;
    set_end(to, from, mean_known, forces);
    result.converged = true;
    return result;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::set_end(SystemState<dim>       &to,
                                           const SystemState<dim> &from,
                                           const NodalVector      &mean_known,
                                           const Forces           &end) const
  {
    const double tau = to.last_step;
    to.slip          = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau * to.mean_slip_rate[k];

    NodalVector forces = problem.make_vector();
    for (unsigned int i = 0; i < entries.size(); ++i)
      forces.local_element(entries.positions[i]) = end.free[i];
    for (unsigned int i = 0; i < known_entries.size(); ++i)
      forces.local_element(known_entries[i]) = end.known[i];
    to.fault_force = faults.tangential_jumps(forces);
    if (following.is_needed())
      to.contact_pressure = end.pressure;
    to.balancing_traction =
      balancing_tractions(faults, laws, to, to.fault_force);

    // Driven sides and faults move, and the rest waits.
    NodalVector change = mean_known, nodal = problem.make_nodal_vector();
    for (const unsigned int k : faults.owned_contact())
      if (slips_freely(k))
        for (unsigned int d = 0; d < dim - 1; ++d)
          change.local_element(faults.node(k) * n_components + d) =
            to.mean_slip_rate[k][d];
    problem.to_nodal(nodal, change);
    to.displacement = from.displacement;
    to.displacement.add(tau, nodal);
    to.velocity    = from.velocity;
    to.is_complete = false;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::complete(SystemState<dim> &state)
  {
    if (state.is_complete)
      return;
    if (!condensed)
      prepare();
    NodalVector w = problem.make_vector();
    problem.to_jumps(w, state.displacement);
    balance(w, problem.load(state.time));
    problem.to_nodal(state.displacement, w);
    w = velocities_of_faults(state);
    balance(w, load_rate(state.time, state.last_step));
    problem.to_nodal(state.velocity, w);
    state.is_complete = true;
  }



  template <int dim, int n_components>
  typename ExplicitStep<dim, n_components>::Influence
  ExplicitStep<dim, n_components>::influence(const NodalFunctional &functional)
  {
    NodalVector nodal = problem.make_nodal_vector();
    for (const auto &[entry, weight] : functional)
      nodal.local_element(entry) += weight;
    const NodalVector e = problem.to_dual(nodal);
    Influence         result;
    result.of_loads = problem.make_vector();
    balance(result.of_loads, e);
    NodalVector known = problem.make_vector();
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(known, e, result.of_loads);
    NodalVector rest = known;
    restrict_to_eliminated(rest);
    known -= rest;
    for (unsigned int i = 0; i < known.locally_owned_size(); ++i)
      if (known.local_element(i) != 0.)
        result.of_known.emplace_back(i, known.local_element(i));
    return result;
  }



  template <int dim, int n_components>
  FunctionalValues
  ExplicitStep<dim, n_components>::body_values(
    const SystemState<dim>             &state,
    const std::vector<NodalFunctional> &functionals)
  {
    if (functionals.empty())
      return {};
    if (!condensed)
      prepare();
    while (influences.size() < functionals.size())
      influences.push_back(influence(functionals[influences.size()]));

    const auto values_of = [&](const NodalVector &w, const NodalVector &load) {
      std::vector<double> result;
      for (const Influence &influence : influences)
        result.push_back(part_of_value(influence.of_known, w));
      sum_up(result, problem.hierarchy().finest().nodes.communicator());
      if (load.linfty_norm() > 0.)
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] += influences[i].of_loads * load;
      return result;
    };
    NodalVector w = problem.make_vector();
    problem.to_jumps(w, state.displacement);
    return {values_of(w, problem.load(state.time)),
            values_of(velocities_of_faults(state),
                      load_rate(state.time, state.last_step))};
  }



  template class ExplicitStep<2>;
  template class ExplicitStep<3>;
  template class ExplicitStep<2, 1>;
} // namespace StickSlip
