// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/faults/contact_pressure.h>
#include <stickslip/problem/known_velocities.h>
#include <stickslip/time/quasistatic_bodies.h>


namespace StickSlip
{
  namespace
  {
    /** The sum over all processes of what each has. */
    void
    sum_up(std::vector<double> &values, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        Utilities::MPI::sum(values, communicator, values);
    }
  } // namespace



  template <int dim, int n_components>
  QuasistaticBodies<dim, n_components>::QuasistaticBodies(
    SpatialProblem<dim, n_components> &problem,
    const FaultNodes<dim>             &faults,
    const NodeLaws                    &laws,
    const bool                         with_pressures)
    : problem(problem)
    , faults(faults)
    , laws(laws)
    , with_pressures(with_pressures)
    , entries(problem.operators().unknowns())
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
            {
              prescribed_entries.push_back(known_entries.size());
              prescribed_places.emplace_back(nodes[i], d);
              known_entries.push_back(faults.node(nodes[i]) * n_components + d);
            }
        if (with_pressures && n_components == dim)
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
  QuasistaticBodies<dim, n_components>::prepare()
  {
    if (condensed)
      return;
    const NodePartition &nodes = problem.hierarchy().finest().nodes;
    condensed = std::make_unique<SchurComplement<n_components>>(
      problem.term(SpatialProblem<dim, n_components>::stiffness).block_matrix(),
      nodes,
      problem.operators().unknowns().fixed,
      entries.positions,
      known_entries);
    if (!with_pressures)
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
  QuasistaticBodies<dim, n_components>::slips_freely(const unsigned int k) const
  {
    return faults.in_contact(k) && !laws[k].is_prescribed;
  }



  template <int dim, int n_components>
  double
  QuasistaticBodies<dim, n_components>::steady_from(const double time) const
  {
    return velocities_stay(problem, time) ? problem.constant_rate_until(time) :
                                            time;
  }



  template <int dim, int n_components>
  NodalVector
  QuasistaticBodies<dim, n_components>::velocities_of_faults(
    const SystemState<dim> &state) const
  {
    NodalVector w = state.time <= steady_until ?
                      last_drives.second->velocity :
                      known_velocities(problem, state.time);
    set_free_slip(w, state.slip_rate);
    return w;
  }



  template <int dim, int n_components>
  void
  QuasistaticBodies<dim, n_components>::restrict_to_eliminated(
    NodalVector &w) const
  {
    problem.operators().unknowns().fixed.apply(w);
    for (const unsigned int position : entries.positions)
      w.local_element(position) = 0.;
  }



  template <int dim, int n_components>
  void
  QuasistaticBodies<dim, n_components>::balance(NodalVector       &w,
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
  typename QuasistaticBodies<dim, n_components>::Forces
  QuasistaticBodies<dim, n_components>::forces_of(const NodalVector &w,
                                                  const NodalVector &load) const
  {
    NodalVector forces = problem.make_vector();
    problem.term(SpatialProblem<dim, n_components>::stiffness)
      .residual(forces, load, w);
    Forces result;
    for (const unsigned int position : entries.positions)
      result.free.push_back(forces.local_element(position));
    for (const unsigned int k : prescribed_entries)
      result.prescribed.push_back(forces.local_element(known_entries[k]));
    if (with_pressures)
      {
        forces *= -1.;
        result.pressure = contact_pressures(problem.jump_basis(),
                                            problem.hierarchy().finest().nodes,
                                            forces);
      }
    return result;
  }



  template <int dim, int n_components>
  typename QuasistaticBodies<dim, n_components>::Forces
  QuasistaticBodies<dim, n_components>::forces_in(const SystemState<dim> &state)
  {
    prepare();
    if (state.fault_force.empty())
      {
        NodalVector u = problem.make_vector();
        problem.to_jumps(u, state.displacement);
        const NodalVector load = problem.load(state.time);
        balance(u, load);
        return forces_of(u, load);
      }
    Forces result;
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const auto [k, d] = places[first_place + i];
        result.free.push_back(state.fault_force[k][d]);
      }
    for (const auto &[k, d] : prescribed_places)
      result.prescribed.push_back(state.fault_force[k][d]);
    if (with_pressures)
      result.pressure = state.contact_pressure;
    return result;
  }



  template <int dim, int n_components>
  std::shared_ptr<const typename QuasistaticBodies<dim, n_components>::Drive>
  QuasistaticBodies<dim, n_components>::make_drive(const double       time,
                                                   const NodalVector &load_rate)
  {
    prepare();
    if (problem.has_constant_load())
      for (const auto &drive : {last_drives.first, last_drives.second})
        if (drive && drive->time == time)
          return drive;
    auto result        = std::make_shared<Drive>();
    result->time       = time;
    result->velocity   = known_velocities(problem, time);
    result->slip_rate  = faults.tangential_jumps(result->velocity);
    NodalVector motion = result->velocity;
    balance(motion, load_rate);
    result->force_rate = forces_of(motion, load_rate);
    return result;
  }



  template <int dim, int n_components>
  std::pair<
    std::shared_ptr<const typename QuasistaticBodies<dim, n_components>::Drive>,
    std::shared_ptr<const typename QuasistaticBodies<dim, n_components>::Drive>>
  QuasistaticBodies<dim, n_components>::drive(const double from,
                                              const double tau)
  {
    if (from + tau <= steady_until)
      return last_drives;
    const NodalVector rate  = load_rate(from + tau, tau);
    const auto        start = make_drive(from, rate);
    if (const double until = steady_from(from); tau > 0. && from + tau <= until)
      {
        last_drives  = {start, start};
        steady_until = until;
      }
    else
      {
        last_drives  = {start, make_drive(from + tau, rate)};
        steady_until = std::numeric_limits<double>::lowest();
      }
    return last_drives;
  }



  template <int dim, int n_components>
  NodalVector
  QuasistaticBodies<dim, n_components>::load_rate(const double time,
                                                  const double tau) const
  {
    if (time <= problem.constant_rate_until(time - tau))
      return problem.load_rate(time - tau);
    NodalVector result = problem.load(time);
    result -= problem.load(time - tau);
    if (tau > 0.)
      result /= tau;
    return result;
  }



  template <int dim, int n_components>
  std::vector<double>
  QuasistaticBodies<dim, n_components>::on_all(
    const std::vector<double> &values)
  {
    prepare();
    return condensed->on_all(values);
  }



  template <int dim, int n_components>
  typename QuasistaticBodies<dim, n_components>::Forces
  QuasistaticBodies<dim, n_components>::forces_of_slip(
    const std::vector<double> &rates)
  {
    prepare();
    Forces result;
    condensed->multiply(result.free, rates);
    for (double &force : result.free)
      force *= -1.;
    if (!with_pressures)
      return result;
    result.pressure.resize(faults.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      add_multiple(result.pressure.data(),
                   rates[first_place + i],
                   pressures_of_slip.data() + std::size_t(i) * faults.size(),
                   faults.size());
    sum_up(result.pressure, problem.hierarchy().finest().nodes.communicator());
    return result;
  }



  template <int dim, int n_components>
  std::vector<double>
  QuasistaticBodies<dim, n_components>::prescribed_forces_of_slip(
    const std::vector<double> &rates)
  {
    prepare();
    std::vector<double> result, force;
    for (const unsigned int k : prescribed_entries)
      {
        multiply_rows(
          force, 1, condensed->row_of_known(k), rates.size(), rates);
        result.push_back(-force[0]);
      }
    return result;
  }



  template <int dim, int n_components>
  typename QuasistaticBodies<dim, n_components>::Slip
  QuasistaticBodies<dim, n_components>::forces_on_faults(
    const Forces &forces) const
  {
    std::vector<double> all(faults.size() * (dim - 1));
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const auto [k, d]      = places[first_place + i];
        all[k * (dim - 1) + d] = forces.free[i];
      }
    for (unsigned int i = 0; i < prescribed_places.size(); ++i)
      {
        const auto [k, d]      = prescribed_places[i];
        all[k * (dim - 1) + d] = forces.prescribed[i];
      }
    sum_up(all, problem.hierarchy().finest().nodes.communicator());
    Slip result(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[k][d] = all[k * (dim - 1) + d];
    return result;
  }



  template <int dim, int n_components>
  void
  QuasistaticBodies<dim, n_components>::set_free_slip(NodalVector &w,
                                                      const Slip  &rates) const
  {
    for (const unsigned int k : faults.owned_contact())
      if (slips_freely(k))
        for (unsigned int d = 0; d < dim - 1; ++d)
          w.local_element(faults.node(k) * n_components + d) = rates[k][d];
  }



  template <int dim, int n_components>
  void
  QuasistaticBodies<dim, n_components>::complete(SystemState<dim> &state)
  {
    if (state.is_complete)
      return;
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
  typename QuasistaticBodies<dim, n_components>::Influence
  QuasistaticBodies<dim, n_components>::influence(
    const NodalFunctional &functional)
  {
    NodalVector nodal = problem.make_nodal_vector();
    for (const auto &[entry, weight] : functional)
      nodal.local_element(entry) += weight;
    const NodalVector e = problem.to_dual(nodal);
    Influence         result;
    result.of_loads = problem.make_vector();
    balance(result.of_loads, e);
    if (problem.has_constant_load())
      result.of_constant_load = result.of_loads * problem.load(0.);
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
  QuasistaticBodies<dim, n_components>::body_values(
    const SystemState<dim>             &state,
    const std::vector<NodalFunctional> &functionals)
  {
    if (functionals.empty())
      return {};
    prepare();
    while (influences.size() < functionals.size())
      influences.push_back(influence(functionals[influences.size()]));

    const auto values_of = [&](const NodalVector &w) {
      std::vector<double> result;
      for (const Influence &influence : influences)
        result.push_back(part_of_value(influence.of_known, w));
      sum_up(result, problem.hierarchy().finest().nodes.communicator());
      return result;
    };
    NodalVector w = problem.make_vector();
    problem.to_jumps(w, state.displacement);
    FunctionalValues result{values_of(w),
                            values_of(velocities_of_faults(state))};
    if (problem.has_constant_load())
      for (unsigned int i = 0; i < influences.size(); ++i)
        result.of_displacement[i] += influences[i].of_constant_load;
    else
      {
        const NodalVector load = problem.load(state.time),
                          rate = load_rate(state.time, state.last_step);
        for (unsigned int i = 0; i < influences.size(); ++i)
          {
            result.of_displacement[i] += influences[i].of_loads * load;
            result.of_velocity[i] += influences[i].of_loads * rate;
          }
      }
    return result;
  }



  template class QuasistaticBodies<2>;
  template class QuasistaticBodies<3>;
  template class QuasistaticBodies<2, 1>;
} // namespace StickSlip
