// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_memory_h
#define stickslip_time_step_memory_h

#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/problem/system_state.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace StickSlip
{
  /**
   * The error of a step as StepHistory estimates it, without unit: on the
   * faults, and of the velocity of the bodies.
   */
  struct StepError
  {
    double faults = 0, bodies = 0;

    /** The larger part that is used of what is allowed; no number if an error
     * is none. */
    double
    part_of(const double tolerance, const double body_tolerance) const
    {
      const double on_faults = faults / tolerance,
                   in_bodies = bodies / body_tolerance;
      return on_faults < in_bodies || std::isnan(in_bodies) ? in_bodies :
                                                              on_faults;
    }

    /** The larger errors of two steps. */
    StepError
    larger(const StepError &other) const
    {
      return {std::max(faults, other.faults), std::max(bodies, other.bodies)};
    }

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &faults &bodies;
    }
  };

  /**
   * Memory of an accepted state for predictions and estimates of the error;
   * arrays over the slave nodes.
   */
  template <int dim>
  struct PastState
  {
    /** Size of the step to this state, s; zero at the start. Differences of
     * times would not do: of two times after centuries they have an error of
     * microseconds, a thousandth of the steps of an event. */
    double              step_size = 0;
    NodalVector         velocity;
    std::vector<double> alpha;
    std::vector<double> state_rate;
    /** Pa; the second one empty where no normal stress follows it. */
    std::vector<double> normal_stress, contact_pressure;
    /** Slave relative to master, m/s. */
    std::vector<Tensor<1, dim - 1>> slip_rate;
    /** Friction coefficient times the direction of the slip rate. */
    std::vector<Tensor<1, dim - 1>> friction;
    /** Contact at each slave node. */
    std::vector<bool> in_contact;
    /** True where the sides are apart; empty where no fault may open. */
    std::vector<bool> is_open;

    /** Everything but the velocity, to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &step_size &alpha &state_rate &normal_stress &contact_pressure
        &slip_rate &friction &in_contact &is_open;
    }
  };

  /**
   * Memory of the control of the step size from step to step.
   */
  template <int dim>
  struct StepMemory
  {
    /** Past states, the newest first, three at most; empty under step
     * doubling. */
    std::vector<PastState<dim>> past;

    /** Step doubling: where the last accepted pair of steps began. */
    std::optional<SystemState<dim>> before;

    /** Step doubling: size of that pair, s. */
    double since_before = 0;

    /** Size of the next step as far as the error goes, s; zero before the
     * first. */
    double proposed = 0;

    bool just_rejected = false;

    /** Errors of the last step that could be solved, and the largest of an
     * accepted one; zero under step doubling, which compares something else. */
    StepError last_error, largest_error;

    /** Largest loads met so far. */
    LargestLoads<dim> largest_loads;

    /** Number of attempts that were rejected, and of steps solved, those that
     * failed or were rejected included, with the work of all of them. */
    unsigned int  n_rejected = 0;
    unsigned long n_solved   = 0;
    StepCounts    work;

    /** Call @p action with each nodal vector of a memory, in a fixed order. */
    template <typename Memory, typename Action>
    static void
    for_each_vector(Memory &memory, const Action &action)
    {
      for (auto &state : memory.past)
        action(state.velocity);
      if (memory.before)
        SystemState<dim>::for_each_vector(*memory.before, action);
    }

    /** Everything but nodal vectors, to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      bool has_before = before.has_value();
      archive &past &has_before &since_before &proposed &just_rejected
        &last_error &largest_error &largest_loads &n_rejected &n_solved &work;
      if (has_before)
        {
          if (!before)
            before.emplace();
          archive &*before;
        }
    }
  };
} // namespace StickSlip

#endif
