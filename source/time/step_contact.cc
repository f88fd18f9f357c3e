// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/contact_pressure.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/impact.h>
#include <stickslip/time/step_contact.h>

#include <cmath>
#include <limits>

namespace StickSlip
{
  template <int dim, int n_components>
  StepContact<dim, n_components>::StepContact(
    SpatialProblem<dim, n_components>   &problem,
    const FaultNodes<dim>               &faults,
    const NodeLaws                      &laws,
    const UnilateralContact<dim>        &unilateral,
    const TimeScheme<dim, n_components> &scheme,
    const Inertia                        inertia,
    const SystemState<dim>              &from,
    const double                         tau)
    : problem(problem)
    , fault_nodes(faults)
    , node_laws(laws)
    , unilateral(unilateral)
    , time_scheme(scheme)
    , is_dynamic(inertia == Inertia::dynamic)
    , from(from)
    , tau(tau)
  {
    if (!unilateral.is_needed())
      return;
    path   = scheme.gap_path(tau, from.last_step);
    bounds = unilateral.bounds(from, path);
    for (const double gap : from.gap)
      touching.push_back(gap == 0.);
  }



  template <int dim, int n_components>
  void
  StepContact<dim, n_components>::start(
    NodalVector                 &rhs,
    FaultFriction<n_components> &friction) const
  {
    if (!unilateral.is_needed())
      return;
    unilateral.add_prestress(rhs, from, path);
    friction.set_opening_bounds(fault_nodes.at_owned_contact(bounds));
    friction.set_cohesion(
      fault_nodes.at_owned_contact(unilateral.cohesion(from)));
  }



  template <int dim, int n_components>
  void
  StepContact<dim, n_components>::find_touching(const NodalVector &w)
  {
    if (unilateral.is_needed())
      touching = unilateral.touching(fault_nodes.opening_jumps(w), bounds);
  }



  template <int dim, int n_components>
  std::vector<bool>
  StepContact<dim, n_components>::stop_rubbing(
    std::vector<Tensor<1, dim - 1>> &slip_rate_before,
    std::vector<Tensor<1, dim - 1>> &slip_rate) const
  {
    std::vector<bool> is_frozen;
    if (!unilateral.is_needed())
      return is_frozen;
    is_frozen.assign(slip_rate.size(), false);
    for (unsigned int k = 0; k < slip_rate.size(); ++k)
      if (unilateral.may_open(k))
        {
          if (!touching[k])
            {
              slip_rate[k] = Tensor<1, dim - 1>();
              is_frozen[k] = node_laws[k].is_frozen_open;
            }
          if (from.gap[k] > 0.)
            slip_rate_before[k] = Tensor<1, dim - 1>();
        }
    return is_frozen;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepContact<dim, n_components>::pressure(const NodalVector &rhs,
                                           const NodalVector &w) const
  {
    NodalVector reaction = problem.make_vector();
    problem.operators().matrix().residual(reaction, rhs, w);
    reaction *= -1.;
    const std::vector<double> pressures =
      contact_pressures(problem.jump_basis(),
                        problem.hierarchy().finest().nodes,
                        reaction);
    return unilateral.is_needed() ?
             unilateral.contact_pressure(from, pressures, touching, path) :
             pressures;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepContact<dim, n_components>::end_pressure(
    std::vector<double> pressure) const
  {
    if (!unilateral.is_needed())
      return pressure;
    for (unsigned int k = 0; k < pressure.size(); ++k)
      // The impulse that a node lands with is no pressure that rubs.
      if (is_dynamic && touching[k] && from.gap[k] > 0.)
        pressure[k] = from.contact_pressure[k];
      else if (!unilateral.may_open(k) || (touching[k] && from.gap[k] == 0. &&
                                           !unilateral.has_landed(from, k)))
        pressure[k] = time_scheme.end_pressure(pressure[k],
                                               from.contact_pressure[k],
                                               tau,
                                               from.last_step);
    return pressure;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepContact<dim, n_components>::pressure_rounding(const NodalVector &w) const
  {
    constexpr double units = 8. * std::numeric_limits<double>::epsilon();

    const BlockMatrix<n_components> &A     = problem.operators().matrix();
    NodalVector                      terms = problem.make_vector();
    update_ghosts(w);
    for (const unsigned int k : fault_nodes.owned_contact())
      {
        constexpr unsigned int n   = n_components - 1;
        const unsigned int     row = fault_nodes.node(k);
        double                 sum = 0.;
        for (unsigned int position = A.sparsity().row_start[row];
             position < A.sparsity().row_start[row + 1];
             ++position)
          for (unsigned int d = 0; d < n_components; ++d)
            sum += std::abs(
              A.block(position)[n * n_components + d] *
              w.begin()[A.sparsity().column[position] * n_components + d]);
        terms.local_element(row * n_components + n) = sum;
      }
    std::vector<double> result =
      contact_pressures(problem.jump_basis(),
                        problem.hierarchy().finest().nodes,
                        terms);
    for (double &pressure : result)
      pressure = units / path.n_times * std::abs(pressure);
    return result;
  }



  template <int dim, int n_components>
  void
  StepContact<dim, n_components>::complete(StepResult<dim>   &result,
                                           const NodalVector &rhs,
                                           NodalVector       &w) const
  {
    if (!unilateral.is_needed())
      return;
    SystemState<dim> &to = result.state;
    if (is_dynamic)
      {
        to.mean_traction.resize(fault_nodes.size());
        for (unsigned int k = 0; k < fault_nodes.size(); ++k)
          if (!unilateral.may_open(k) || touching[k])
            to.mean_traction[k] =
              0.5 * (shear_traction(fault_nodes, node_laws, from, k) +
                     shear_traction(fault_nodes, node_laws, to, k));
      }
    const std::vector<double> opening_rates   = fault_nodes.opening_jumps(w);
    std::vector<bool>         touching_at_end = touching;
    unilateral.add_landed(touching_at_end, from, to.time, opening_rates, path);
    unilateral.complete(to, from, tau, opening_rates, touching_at_end, path);
    result.contact_energy = unilateral.energy(to, from, path);
    if (is_dynamic)
      complete_impacts(result, rhs, touching_at_end, w);
  }



  template <int dim, int n_components>
  void
  StepContact<dim, n_components>::complete_impacts(
    StepResult<dim>         &result,
    const NodalVector       &rhs,
    const std::vector<bool> &touching_at_end,
    NodalVector             &w) const
  {
    // Forces of the contact are the reaction less what was put into the right
    // hand side for it.
    NodalVector all_forces = w, prestress = problem.make_vector();
    problem.operators().matrix().residual(all_forces, rhs, w);
    unilateral.add_prestress(prestress, from, path);
    NodalVector reaction = problem.make_vector();
    for (const unsigned int k : fault_nodes.owned_contact())
      {
        const unsigned int position =
          fault_nodes.node(k) * n_components + dim - 1;
        reaction.local_element(position) = prestress.local_element(position) -
                                           all_forces.local_element(position);
      }

    SystemState<dim> &to             = result.state;
    ContactEnergy    &energy         = result.contact_energy;
    const NodalVector before_impacts = w;
    const double lost = stop_impacts(problem, fault_nodes, touching_at_end, w);
    energy.lost += lost;
    if (lost > 0.)
      {
        result.velocity_before_impacts  = to.velocity;
        result.slip_rate_before_impacts = to.slip_rate;
      }
    time_scheme.set_end_force(
      to, from, tau, problem, before_impacts, w, reaction);
    if (energy.lost > 0.)
      {
        NodalVector v = problem.make_vector(), product = v;
        problem.to_jumps(v, from.velocity);
        problem.term(SpatialProblem<dim, n_components>::mass).vmult(product, v);
        energy.kinetic = 0.5 * (v * product);
      }
    problem.to_nodal(to.velocity, w);
    to.slip_rate    = fault_nodes.tangential_jumps(w);
    to.opening_rate = fault_nodes.opening_jumps(w);
  }



  template class StepContact<2>;
  template class StepContact<3>;
  template class StepContact<2, 1>;
} // namespace StickSlip
