// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// Central differences with a lumped mass, for scenes of two dimensions whose
// faults are level and have nodes that face each other: events and time against
// the length of the steps, in parts of the stability limit.
//
//   central_differences SCENE.prm [--parts 0.9,0.45] [--set ENTRY=VALUE]...

#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <stickslip/faults/fault_functional.h>
#include <stickslip/scene/command_line.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>
#include <iomanip>
#include <iostream>

#include "measurement.h"

namespace
{
  using namespace Measure;
  using namespace StickSlip;

  constexpr int dim = 2;
  using Problem     = SpatialProblem<dim>;

  /** A slave node, the master node that faces it, and their masses, kg/m: of
   * the slave, of both, and that of their relative motion. */
  struct Pair
  {
    unsigned int fault_node, slip_entry, master_entry;
    double       slave_mass, mass, relative_mass;
  };

  /**
   * The bodies with a lumped mass, in the basis in which slave nodes have
   * jumps: there the mass of a pair couples its two entries along the fault.
   */
  class LumpedBodies
  {
  public:
    explicit LumpedBodies(Simulation<dim> &simulation)
      : problem(simulation.spatial_problem())
      , faults(simulation.fault_nodes())
      , inverse_mass(problem.make_vector())
    {
      const NodePartition &nodes = problem.hierarchy().finest().nodes;
      const NodeMask      &fixed = problem.operators().unknowns().fixed;
      // Forces that accelerate all nodes alike, no slave node relative to its
      // master.
      NodalVector lumped = problem.make_vector(), ones = lumped,
                  forces = lumped;
      for (unsigned int d = 0; d < dim; ++d)
        {
          ones = 0.;
          for (unsigned int i = 0; i < nodes.n_owned(); ++i)
            ones.local_element(i * dim + d) = 1.;
          for (const unsigned int k : faults.owned_contact())
            ones.local_element(faults.node(k) * dim + d) = 0.;
          problem.term(Problem::mass).vmult(forces, ones);
          for (unsigned int i = 0; i < nodes.n_owned(); ++i)
            lumped.local_element(i * dim + d) =
              forces.local_element(i * dim + d);
        }
      for (unsigned int i = 0; i < nodes.n_owned(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          if (fixed.is_active(i, d))
            inverse_mass.local_element(i * dim + d) =
              1. / lumped.local_element(i * dim + d);

      unsigned int k = 0;
      for (const FaultContact<dim> &contact : problem.jump_basis().faults())
        {
          AssertThrow(contact.axes.are_those_of_space(),
                      ExcMessage("A fault is not level."));
          for (const auto slave : contact.slave_nodes)
            {
              if (faults.in_contact(k))
                add_pair(k, slave, lumped);
              ++k;
            }
        }
    }

    const std::vector<Pair> &
    all_pairs() const
    {
      return pairs;
    }

    /** change = M^-1 force, where nothing is fixed. */
    void
    accelerate(NodalVector &change, const NodalVector &force) const
    {
      change = force;
      change.scale(inverse_mass);
      for (const Pair &pair : pairs)
        {
          const double slip = relative_force(pair, force) / pair.relative_mass;
          change.local_element(pair.slip_entry) = slip;
          change.local_element(pair.master_entry) =
            master_acceleration(pair, force, slip);
        }
    }

    static double
    relative_force(const Pair &pair, const NodalVector &force)
    {
      return force.local_element(pair.slip_entry) -
             pair.slave_mass / pair.mass *
               force.local_element(pair.master_entry);
    }

    static double
    master_acceleration(const Pair        &pair,
                        const NodalVector &force,
                        const double       slip)
    {
      return (force.local_element(pair.master_entry) - pair.slave_mass * slip) /
             pair.mass;
    }

    /** The longest stable step, s: 2 / omega (sqrt(1 + xi^2) - xi) with the
     * largest frequency omega and its damping ratio xi (Belytschko, Liu and
     * Moran 2000), by power iterations. */
    double
    stability_limit() const
    {
      NodalVector x = problem.make_vector(), force = x;
      for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
        x.local_element(i) = std::sin(1.3 * i * i);
      double squared = 0.;
      for (unsigned int iteration = 0; iteration < 500; ++iteration)
        {
          x /= x.l2_norm();
          problem.term(Problem::stiffness).vmult(force, x);
          NodalVector next = x;
          accelerate(next, force);
          squared = next.l2_norm();
          x       = next;
        }
      x /= x.l2_norm();
      double damping = 0.;
      if (problem.has(Problem::damping))
        {
          problem.term(Problem::damping).vmult(force, x);
          NodalVector next = x;
          accelerate(next, force);
          damping = next * x;
        }
      const double omega = std::sqrt(squared), xi = damping / (2. * omega);
      return 2. / omega * (std::sqrt(1. + xi * xi) - xi);
    }

  private:
    void
    add_pair(const unsigned int            k,
             const types::global_dof_index slave,
             const NodalVector            &lumped)
    {
      const NodePartition    &nodes  = problem.hierarchy().finest().nodes;
      const GlobalRow         row    = problem.jump_basis().to_jumps(slave);
      unsigned int            n      = 0;
      types::global_dof_index master = slave;
      for (const auto &[node, weight] : row)
        if (node != slave && std::abs(weight) > 1e-10)
          {
            ++n;
            master = node;
          }
      AssertThrow(n == 1, ExcMessage("A node of a fault faces no node."));
      Pair pair;
      pair.fault_node    = k;
      pair.slip_entry    = nodes.local_index(slave) * dim;
      pair.master_entry  = nodes.local_index(master) * dim;
      pair.slave_mass    = lumped.local_element(pair.slip_entry);
      pair.mass          = lumped.local_element(pair.master_entry);
      pair.relative_mass = pair.slave_mass * (1. - pair.slave_mass / pair.mass);
      pairs.push_back(pair);
    }

    const Problem         &problem;
    const FaultNodes<dim> &faults;
    NodalVector            inverse_mass;
    std::vector<Pair>      pairs;
  };



  /** Starts of events by the mean slip rate, as in events.csv. */
  class Events
  {
  public:
    Events(const double threshold, const double end_fraction)
      : threshold(threshold)
      , end_fraction(end_fraction)
    {}

    void
    add(const double time, const double tau, const double rate)
    {
      if (!is_on && rate > threshold)
        {
          is_on = true;
          starts.push_back(time - tau +
                           tau * std::log(threshold / last) /
                             std::log(rate / last));
        }
      else if (is_on && rate < end_fraction * threshold)
        is_on = false;
      last = rate;
    }

    std::vector<double> starts;

  private:
    const double threshold, end_fraction;
    double       last  = 0.;
    bool         is_on = false;
  };



  /** Velocities half a step after the displacements; friction by the mean of
   * the slip rates before and after, so that both are of second order. */
  void
  run(const SceneParameters<dim> &scene, const double part)
  {
    Simulation<dim> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    Problem               &problem = simulation.spatial_problem();
    const FaultNodes<dim> &faults  = simulation.fault_nodes();
    const NodeLaws        &laws    = simulation.node_laws();
    const LumpedBodies     bodies(simulation);
    const double           limit = bodies.stability_limit();
    const unsigned int     n_steps =
      std::ceil(scene.time.end_time / (part * limit));
    const double tau = scene.time.end_time / n_steps;

    const auto friction =
      make_fault_friction<dim>(faults, laws, simulation.state().normal_stress);
    const NodeMask &fixed = problem.operators().unknowns().fixed;
    NodalVector     u = problem.make_vector(), v = u, force = u, change = u,
                viscous = u, known = u, nodal = problem.make_nodal_vector();
    problem.to_jumps(u, simulation.state().displacement);
    const NodalVector        load  = problem.load(0.);
    std::vector<double>      alpha = simulation.state().alpha;
    const std::vector<Pair> &pairs = bodies.all_pairs();
    std::vector<double>      slip_rates(pairs.size());
    double                   area = 0.;
    for (const Pair &pair : pairs)
      area += faults.weights()[pair.fault_node];

    Events events(event_start_slip_rate(scene),
                  scene.output.event_end_fraction);
    Timer  timer;
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        problem.term(Problem::stiffness).residual(force, load, u);
        if (problem.has(Problem::damping))
          {
            problem.term(Problem::damping).vmult(viscous, v);
            force -= viscous;
          }
        bodies.accelerate(change, force);
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const FaultLaw &law = laws[pairs[i].fault_node];
            double         &a   = alpha[pairs[i].fault_node];
            a = law.state_law->updated(StateUpdate::exponential,
                                       a,
                                       std::abs(slip_rates[i]),
                                       law.characteristic_slip,
                                       tau);
          }
        friction->set_state(faults.at_owned_contact(alpha));
        double mean = 0.;
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const Pair    &pair = pairs[i];
            Tensor<2, dim> A;
            Tensor<1, dim> r, start;
            A[0][0] = 2. * pair.relative_mass / tau;
            r[0]    = LumpedBodies::relative_force(pair, force) +
                   A[0][0] * slip_rates[i];
            start[0] = slip_rates[i];
            const double slip_rate =
              2. * friction->minimise(i, A, r, {{true, false}}, start)[0] -
              slip_rates[i];
            const double slip = (slip_rate - slip_rates[i]) / tau;
            change.local_element(pair.slip_entry) = slip;
            change.local_element(pair.master_entry) =
              LumpedBodies::master_acceleration(pair, force, slip);
            slip_rates[i] = slip_rate;
            mean += faults.weights()[pair.fault_node] * std::abs(slip_rate);
          }
        const double time = (n + 0.5) * tau;
        problem.boundary_values().set_velocities(time, nodal);
        problem.to_jumps(known, nodal);
        problem.set_known_jumps(time, known);
        v.add(tau, change);
        for (unsigned int i = 0; i < v.locally_owned_size(); ++i)
          if (!fixed.is_active(i / dim, i % dim))
            v.local_element(i) = known.local_element(i);
        u.add(tau, v);
        AssertThrow(std::isfinite(mean), ExcMessage("The steps are too long."));
        events.add(time, tau, mean / area);
      }
    timer.stop();
    std::cout << std::setprecision(4) << part << " of " << limit
              << " s: " << n_steps << " steps, " << timer.cpu_time() << " s, "
              << 1e6 * timer.cpu_time() / n_steps << " us a step; events at"
              << std::fixed << std::setprecision(5);
    for (const double start : events.starts)
      std::cout << ' ' << start;
    std::cout << " s" << std::defaultfloat << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  carry_out("central_differences", argc, argv, [](Options &options) {
    const std::vector<double> parts =
      Utilities::string_to_double(Utilities::split_string_list(
        options.take_value("--parts", "0.9, 0.45, 0.225")));
    const CommandLine arguments = parse_command_line(options.rest());
    const SceneReader reader(arguments.parameter_file, arguments.overrides);
    for (const double part : parts)
      run(reader.read<dim>(), part);
  });
}
