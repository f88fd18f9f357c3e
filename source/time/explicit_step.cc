// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/magnitude.h>
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
    , bodies(problem, faults, laws, following.is_needed())
    , friction(make_fault_friction<dim, n_components>(faults,
                                                      laws,
                                                      std::vector<double>(
                                                        faults.size())))
  {}



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::set_force_rates(Stage        &stage,
                                                   const double  part,
                                                   const Forces &drive,
                                                   const Forces &drive_end)
  {
    // Values that are driven, and what slip adds to them.
    const auto set = [part](std::vector<double>       &result,
                            const std::vector<double> &first,
                            const std::vector<double> &second,
                            const std::vector<double> &of_slip) {
      result.resize(first.size());
      for (unsigned int i = 0; i < first.size(); ++i)
        result[i] = (1. - part) * first[i] + part * second[i] + of_slip[i];
    };
    const Forces of_slip = bodies.forces_of_slip(stage.rates);
    set(stage.forces.free, drive.free, drive_end.free, of_slip.free);
    if (following.is_needed())
      set(stage.forces.pressure,
          drive.pressure,
          drive_end.pressure,
          of_slip.pressure);
  }



  template <int dim, int n_components>
  bool
  ExplicitStep<dim, n_components>::find_rates(
    Stage                     &stage,
    const std::vector<double> &alpha,
    const std::vector<double> &force,
    const std::vector<double> &normal_stress)
  {
    const CondensedEntries<n_components> &entries = bodies.free_entries();
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
    stage.rates = bodies.on_all(rates);
    if (!are_numbers(stage.rates))
      return false;
    const auto &places = bodies.all_free();
    for (unsigned int i = 0; i < places.size(); ++i)
      stage.slip_rate[places[i].first][places[i].second] = stage.rates[i];
    stage.state_rate.assign(faults.size(), 0.);
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (bodies.slips_freely(k) && laws[k].state_law)
        stage.state_rate[k] =
          laws[k].state_law->rate(alpha[k],
                                  magnitude(stage.slip_rate[k]),
                                  laws[k].characteristic_slip);
    return true;
  }



  template <int dim, int n_components>
  StepResult<dim>
  ExplicitStep<dim, n_components>::take(const SystemState<dim> &from,
                                        const double            tau,
                                        const double            tolerance,
                                        double                 &error)
  {
    StepResult<dim> result;
    result.step_size                    = tau;
    result.counts.rate_state_iterations = n_stages;
    result.failure = "the estimated error stays above Time/Tolerance";
    error          = std::numeric_limits<double>::quiet_NaN();

    // The start of the step, and what drives it.
    const Forces start  = bodies.forces_in(from);
    const auto   drives = bodies.drive(from.time, tau);
    const Drive &drive = *drives.first, &drive_end = *drives.second;

    // Stages, of which the last one is the end.
    std::array<Stage, n_stages> stages;
    Forces                      forces;
    std::vector<double>         alpha, normal_stress;
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
          if (!bodies.slips_freely(k))
            // Prescribed rates may jump at the start of a run.
            stages[i].slip_rate[k] = drive_end.slip_rate[k];
        if (!find_rates(stages[i], alpha, forces.free, normal_stress))
          return result;
        // Nothing comes after the last one.
        if (i + 1 < n_stages)
          set_force_rates(stages[i],
                          parts[i],
                          drive.force_rate,
                          drive_end.force_rate);
      }

    std::vector<double> state_errors(faults.size()), slip_errors(faults.size());
    SystemState<dim>   &to = result.state;
    to.mean_slip_rate.resize(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        const FaultLaw &law = laws[k];
        if (!bodies.slips_freely(k))
          {
            to.mean_slip_rate[k] =
              0.5 * (drive.slip_rate[k] + drive_end.slip_rate[k]);
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

    // Forces on prescribed entries follow the mean rates.
    std::vector<double> mean_rates;
    for (const auto &[k, d] : bodies.all_free())
      mean_rates.push_back(to.mean_slip_rate[k][d]);
    add(forces.prescribed, 0.5 * tau, drive.force_rate.prescribed);
    add(forces.prescribed, 0.5 * tau, drive_end.force_rate.prescribed);
    add(forces.prescribed, tau, bodies.prescribed_forces_of_slip(mean_rates));

    to.time          = from.time + tau;
    to.last_step     = tau;
    to.alpha         = alpha;
    to.slip_rate     = stages[n_stages - 1].slip_rate;
    to.normal_stress = normal_stress;
    set_end(to, from, drive, drive_end, forces);
    result.converged = true;
    return result;
  }



  template <int dim, int n_components>
  void
  ExplicitStep<dim, n_components>::set_end(SystemState<dim>       &to,
                                           const SystemState<dim> &from,
                                           const Drive            &drive,
                                           const Drive            &drive_end,
                                           const Forces           &end) const
  {
    const double tau = to.last_step;
    to.slip          = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau * to.mean_slip_rate[k];

    to.fault_force = bodies.forces_on_faults(end);
    if (following.is_needed())
      to.contact_pressure = end.pressure;
    to.balancing_traction =
      balancing_tractions(faults, laws, to, to.fault_force);

    // Driven sides and faults move, and the rest waits.
    NodalVector change = drive.velocity, nodal = problem.make_nodal_vector();
    if (&drive != &drive_end)
      change.sadd(0.5, 0.5, drive_end.velocity);
    bodies.set_free_slip(change, to.mean_slip_rate);
    problem.to_nodal(nodal, change);
    to.displacement = from.displacement;
    to.displacement.add(tau, nodal);
    to.velocity    = from.velocity;
    to.is_complete = false;
  }



  template class ExplicitStep<2>;
  template class ExplicitStep<3>;
  template class ExplicitStep<2, 1>;
} // namespace StickSlip
