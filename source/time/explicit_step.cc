// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

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



    std::vector<double>
    between(const double               part,
            const std::vector<double> &first,
            const std::vector<double> &second)
    {
      std::vector<double> result(first.size());
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = (1. - part) * first[i] + part * second[i];
      return result;
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
  {}



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::prepare()
  {
    const BlockMatrix<n_components> &K =
      problem.term(SpatialProblem<dim, n_components>::stiffness);
    condensed = std::make_unique<CondensedOperator<n_components>>(entries);
    condensed->set_matrix(K, problem.operators().unknowns().fixed);
    if (!following.is_needed())
      return;
    const NodalVector no_load = problem.make_vector();
    pressures_of_slip.reserve(std::size_t(entries.size()) * faults.size());
    for (const unsigned int position : entries.positions)
      {
        NodalVector w             = problem.make_vector();
        w.local_element(position) = 1.;
        balance(w, no_load);
        const std::vector<double> column = forces_of(w, no_load).pressure;
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
  void
  ExplicitStep<dim, n_components>::balance(NodalVector       &w,
                                           const NodalVector &load)
  {
    const auto restrict = [&](NodalVector &vector) {
      problem.operators().unknowns().fixed.apply(vector);
      for (const unsigned int position : entries.positions)
        vector.local_element(position) = 0.;
    };
    NodalVector forces = problem.make_vector(), change = forces;
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(forces, load, w);
    restrict(forces);
    condensed->solve_eliminated(change, forces);
    restrict(change);
    w += change;
  }



  template <int dim, int n_components>
  typename ExplicitStep<dim, n_components>::ForceRates
  ExplicitStep<dim, n_components>::forces_of(const NodalVector &w,
                                             const NodalVector &load) const
  {
    NodalVector forces = problem.make_vector();
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(forces, load, w);
    ForceRates result;
    for (const unsigned int position : entries.positions)
      result.force.push_back(forces.local_element(position));
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
  void
  ExplicitStep<dim, n_components>::set_force_rates(
    Stage            &stage,
    const ForceRates &drive) const
  {
    std::vector<double>              rates(entries.size());
    const std::vector<unsigned int> &nodes = faults.owned_contact();
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (entries.of_node[i][d] != numbers::invalid_unsigned_int)
          rates[entries.of_node[i][d]] = stage.slip_rate[nodes[i]][d];
    stage.forces = drive;
    std::vector<double> product;
    condensed->vmult(product, rates);
    for (unsigned int i = 0; i < rates.size(); ++i)
      stage.forces.force[i] -= product[i];
    if (following.is_needed())
      for (unsigned int i = 0; i < rates.size(); ++i)
        add_multiple(stage.forces.pressure.data(),
                     rates[i],
                     pressures_of_slip.data() + std::size_t(i) * faults.size(),
                     faults.size());
  }



  template <int dim, int n_components>
  bool
  ExplicitStep<dim, n_components>::find_rates(
    Stage                     &stage,
    const std::vector<double> &alpha,
    const std::vector<double> &force,
    const std::vector<double> &normal_stress) const
  {
    if (!are_numbers(alpha) || !are_numbers(force) ||
        !are_numbers(normal_stress))
      return false;
    friction->set_normal_stresses(faults.at_owned_contact(normal_stress));
    friction->set_state(faults.at_owned_contact(alpha));
    const std::vector<unsigned int> &nodes = faults.owned_contact();
    const Tensor<2, n_components>    nothing;
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
            stage.slip_rate[nodes[i]][d] = v[d];
      }
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
    const std::vector<unsigned int> &nodes = faults.owned_contact();
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (const unsigned int entry = entries.of_node[i][d];
            entry != numbers::invalid_unsigned_int)
          w.local_element(entries.positions[entry]) +=
            factor * rates[nodes[i]][d];
  }



  template <int dim, int n_components>
  StepResult<dim>
  ExplicitStep<dim, n_components>::take(const SystemState<dim> &from,
                                        const double            tau,
                                        const double            tolerance,
                                        double                 &error)
  {
    const BlockMatrix<n_components> &K =
      problem.term(SpatialProblem<dim, n_components>::stiffness);
    if (!condensed)
      prepare();

    StepResult<dim> result;
    result.step_size                    = tau;
    result.counts.rate_state_iterations = n_stages;
    result.failure = "the estimated error stays above Time/Tolerance";
    error          = std::numeric_limits<double>::quiet_NaN();

    // The start of the step, and what drives it.
    NodalVector u = problem.make_vector();
    problem.to_jumps(u, from.displacement);
    const NodalVector load     = problem.load(from.time),
                      load_end = problem.load(from.time + tau);
    const ForceRates start     = forces_of(u, load);
    NodalVector      load_rate(load_end);
    load_rate -= load;
    load_rate /= tau;
    const bool load_varies = load_rate.linfty_norm() > 0.;

    const auto drive_of = [&](const NodalVector &known) {
      if (driven_by.size() == 0 || load_varies ||
          !std::equal(known.begin(),
                      known.begin() + known.locally_owned_size(),
                      driven_by.begin()))
        {
          NodalVector w = known;
          balance(w, load_rate);
          driven    = forces_of(w, load_rate);
          driven_by = load_varies ? NodalVector() : known;
        }
      return driven;
    };
    const NodalVector known     = known_velocities(from.time),
                      known_end = known_velocities(from.time + tau);
    const ForceRates drive = drive_of(known), drive_end = drive_of(known_end);

    // Stages, of which the last one is the end.
    std::array<Stage, n_stages> stages;
    // Slip rates that are prescribed may jump at the start of a run.
    const Slip known_slip     = faults.tangential_jumps(known),
               known_slip_end = faults.tangential_jumps(known_end);
    std::vector<double> alpha, force, pressure, normal_stress;
    for (unsigned int i = 0; i < n_stages; ++i)
      {
        alpha    = from.alpha;
        force    = start.force;
        pressure = start.pressure;
        for (unsigned int j = 0; j < i; ++j)
          if (const double weight = tau * weights[i][j]; weight != 0.)
            {
              const auto add = [weight](std::vector<double>       &values,
                                        const std::vector<double> &rates) {
                for (unsigned int k = 0; k < values.size(); ++k)
                  values[k] += weight * rates[k];
              };
              add(alpha, stages[j].state_rate);
              add(force, stages[j].forces.force);
              add(pressure, stages[j].forces.pressure);
            }
        normal_stress =
          following.is_needed() ?
            following.normal_stress(from.normal_stress, pressure) :
            from.normal_stress;
        stages[i].slip_rate = i == 0 ? from.slip_rate : stages[i - 1].slip_rate;
        for (unsigned int k = 0; k < faults.size(); ++k)
          if (!slips_freely(k))
            stages[i].slip_rate[k] = known_slip_end[k];
        if (!find_rates(stages[i], alpha, force, normal_stress))
          return result;
        // Nothing comes after the last one.
        if (i + 1 < n_stages)
          set_force_rates(
            stages[i],
            {between(parts[i], drive.force, drive_end.force),
             between(parts[i], drive.pressure, drive_end.pressure)});
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

    // Bodies in equilibrium at the end, and their velocities.
    NodalVector w = known;
    w += known_end;
    w *= 0.5 * tau;
    w += u;
    add_slip(w, to.mean_slip_rate, tau);
    balance(w, load_end);
    NodalVector velocity = known_end;
    add_slip(velocity, stages[n_stages - 1].slip_rate, 1.);
    balance(velocity, load_rate);

    to.time      = from.time + tau;
    to.last_step = tau;
    to.alpha     = alpha;
    to.slip      = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau * to.mean_slip_rate[k];
    to.slip_rate    = stages[n_stages - 1].slip_rate;
    to.displacement = to.velocity = problem.make_nodal_vector();
    problem.to_nodal(to.displacement, w);
    problem.to_nodal(to.velocity, velocity);
    to.mean_velocity = to.displacement;
    to.mean_velocity -= from.displacement;
    to.mean_velocity /= tau;
    to.normal_stress = normal_stress;
    if (following.is_needed())
      {
        to.contact_pressure = forces_of(w, load_end).pressure;
        to.normal_stress =
          following.normal_stress(from.normal_stress, to.contact_pressure);
      }
    to.balancing_traction =
      balancing_tractions(faults, laws, to, K, load_end, w);
    result.converged = std::isfinite(to.displacement.l2_norm());
    return result;
  }



  template class ExplicitStep<2>;
  template class ExplicitStep<3>;
  template class ExplicitStep<2, 1>;
} // namespace StickSlip
