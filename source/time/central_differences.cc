// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/problem/known_velocities.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/central_differences.h>

#include <array>
#include <cmath>

namespace StickSlip
{
  template <int dim, int n_components>
  CentralDifferences<dim, n_components>::CentralDifferences(
    SpatialProblem<dim, n_components> &problem,
    const FaultNodes<dim>             &faults,
    const NodeLaws                    &laws)
    : problem(problem)
    , faults(faults)
    , laws(laws)
    , mass(problem)
    , friction(make_fault_friction<dim, n_components>(faults,
                                                      laws,
                                                      std::vector<double>(
                                                        faults.size())))
    , known_entries(fixed_entries(problem.operators().unknowns()))
  {}



  template <int dim, int n_components>
  void
  CentralDifferences<dim, n_components>::update_known_velocity(
    const double time)
  {
    if (is_known_steady)
      return;
    known_velocity  = known_velocities(problem, time);
    is_known_steady = velocities_stay(problem, time);
  }



  template <int dim, int n_components>
  NodalVector
  CentralDifferences<dim, n_components>::forces(const double       time,
                                                const NodalVector &displacement,
                                                const NodalVector &velocity)
  {
    using Problem = SpatialProblem<dim, n_components>;
    if (load.size() == 0 || !problem.has_constant_load())
      load = problem.load(time);
    NodalVector result = problem.make_vector();
    problem.term(Problem::stiffness).residual(result, load, displacement);
    if (problem.has(Problem::damping))
      {
        const NodalVector elastic = result;
        problem.term(Problem::damping).residual(result, elastic, velocity);
      }
    return result;
  }



  template <int dim, int n_components>
  NodalVector
  CentralDifferences<dim, n_components>::accelerate_jumps(
    NodalVector       &a,
    const NodalVector &force,
    const NodalVector &velocity,
    const double       tau) const
  {
    const NodeMask    &fixed    = problem.operators().unknowns().fixed;
    NodalVector        balanced = problem.make_vector();
    const unsigned int n        = faults.owned_contact().size();
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int      node = faults.node(faults.owned_contact()[i]);
        Tensor<1, n_components> f    = mass.relative_force(i, force, a), start;
        const Tensor<1, n_components> &m      = mass.relative_mass(i);
        const Tensor<1, n_components>  acting = f;
        Tensor<2, n_components>        A;
        std::array<bool, n_components> takes_part = {};
        for (unsigned int d = 0; d < dim - 1; ++d)
          if (fixed.is_active(node, d))
            {
              takes_part[d] = true;
              start[d]      = velocity.local_element(node * n_components + d);
              A[d][d]       = 2. / tau * m[d];
              f[d] += A[d][d] * start[d];
            }
        const Tensor<1, n_components> end =
          friction->minimise(i, A, f, takes_part, start);
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const unsigned int entry = node * n_components + d;
            if (takes_part[d])
              a.local_element(entry) = 2. / tau * (end[d] - start[d]);
            balanced.local_element(entry) =
              acting[d] - m[d] * a.local_element(entry);
          }
      }
    return balanced;
  }



  template <int dim, int n_components>
  StepResult<dim>
  CentralDifferences<dim, n_components>::take(const SystemState<dim> &from,
                                              const double            tau)
  {
    StepResult<dim> result;
    result.step_size                    = tau;
    result.counts.rate_state_iterations = 1;
    SystemState<dim> &to                = result.state;

    // The middle of the step.
    NodalVector middle = from.velocity, w = problem.make_vector();
    middle.add(tau / 2., from.acceleration);
    problem.to_jumps(w, middle);
    to.mean_slip_rate = faults.tangential_jumps(w);
    to.alpha          = from.alpha;
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (laws[k].state_law)
        to.alpha[k] =
          laws[k].state_law->updated(StateUpdate::exponential,
                                     from.alpha[k],
                                     magnitude(to.mean_slip_rate[k]),
                                     laws[k].characteristic_slip,
                                     tau);
    NodalVector displacement = from.displacement;
    displacement.add(tau, middle);

    // The equation at its end, where sides go on to the velocity in the middle
    // of the next step.
    NodalVector u = problem.make_vector(), a = u;
    problem.to_jumps(u, displacement);
    const NodalVector force = forces(from.time + tau, u, w);
    update_known_velocity(from.time + 1.5 * tau);
    for (const unsigned int entry : known_entries)
      a.local_element(entry) =
        (known_velocity.local_element(entry) - w.local_element(entry)) / tau;
    friction->set_normal_stresses(faults.at_owned_contact(from.normal_stress));
    friction->set_state(faults.at_owned_contact(to.alpha));
    mass.accelerate_bodies(a, force);
    const NodalVector balanced = accelerate_jumps(a, force, w, tau);
    mass.accelerate_jumps(a);

    w.add(tau / 2., a);
    to.slip_rate             = faults.tangential_jumps(w);
    NodalVector acceleration = problem.make_nodal_vector(), velocity = middle;
    problem.to_nodal(acceleration, a);
    velocity.add(tau / 2., acceleration);
    to.time          = from.time + tau;
    to.last_step     = tau;
    to.normal_stress = from.normal_stress;
    // To assign to vectors without a partition takes messages.
    to.displacement.swap(displacement);
    to.mean_velocity.swap(middle);
    to.velocity.swap(velocity);
    to.acceleration.swap(acceleration);
    to.slip = from.slip;
    for (unsigned int k = 0; k < to.slip.size(); ++k)
      to.slip[k] += tau * to.mean_slip_rate[k];
    to.balancing_traction =
      balancing_tractions(faults, laws, to, faults.tangential_jumps(balanced));

    result.converged = std::isfinite(to.velocity.norm_sqr());
    if (!result.converged)
      result.failure = "the solution is not a number";
    return result;
  }



  template <int dim, int n_components>
  double
  CentralDifferences<dim, n_components>::stability_limit() const
  {
    using Problem                         = SpatialProblem<dim, n_components>;
    constexpr unsigned int max_iterations = 1000, min_iterations = 30;
    constexpr double       tolerance = 1e-5;

    const Unknowns &unknowns    = problem.operators().unknowns();
    const bool      has_damping = problem.has(Problem::damping);
    NodalVector     x = problem.make_vector(), stiff = x, viscous = x, p = x;
    // Numbers without a pattern that do not depend on the processes, as those
    // of degrees of freedom do not.
    const MeshLevel<dim> &level  = problem.meshes().finest();
    const auto           &serial = level.owned_serial_nodes();
    for (unsigned int i = 0; i < serial.size(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const double n = double(serial[i]) * n_components + c;
          x.local_element(i * n_components + c) = std::sin(1.3 * n * n);
        }
    unknowns.fixed.apply(x);
    double limit = 0.;
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        mass.vmult(p, x);
        problem.term(Problem::stiffness).vmult(stiff, x);
        const double m = x * p, k = x * stiff;
        double       c = 0.;
        if (has_damping)
          {
            problem.term(Problem::damping).vmult(viscous, x);
            c = x * viscous;
          }
        const double before = limit;
        limit               = (std::sqrt(c * c + 4. * k * m) - c) / k;
        if (iteration >= min_iterations &&
            std::abs(limit - before) < tolerance * limit)
          break;
        stiff *= 0.25 * limit * limit;
        if (has_damping)
          stiff.add(0.5 * limit, viscous);
        mass.solve(x, stiff);
        x /= std::sqrt(x.norm_sqr());
      }
    return limit;
  }



  template class CentralDifferences<2>;
  template class CentralDifferences<3>;
  template class CentralDifferences<2, 1>;
} // namespace StickSlip
