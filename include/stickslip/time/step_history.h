// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_history_h
#define stickslip_time_step_history_h

#include <stickslip/time/rate_state_step.h>
#include <stickslip/time/step_memory.h>

#include <algorithm>

namespace StickSlip
{
  /**
   * The last accepted states: what they predict, and how wrong a step is
   * compared with them, at no solve.
   *
   * Three quantities of each contact node are compared with their
   * extrapolations over steps h (the current one), h1 and h2:
   *
   * - state: e = (alpha - AB2) / (3 (1 + h1/h)), where AB2 is the
   *   Adams-Bashforth prediction from the last two state rates;
   * - traction: e = |m - extrapolated| / FrictionLaw::rate_scale() * c0 / (cc +
   *   c0), where m is the friction coefficient times the direction of the slip
   *   rate and times the normal stress over its mean on the fault; rate_scale()
   *   is max(a, b) of rate and state, and where it is zero the traction does
   * not count; c0 is TimeScheme::error_constant(), and cc = h (h + h1) (h + h1
   * + h2) / 6;
   * - slip rate: e = |V - extrapolated| / max(the largest V of the fault, L/h)
   *   * c0 / (cc + c0).
   *
   * and so is the velocity of the bodies, see body_error(). All are Milne's
   * device: the known ratio of the error constants of the step and of its
   * prediction. Of traction and slip rate the smaller error counts:
   *
   * - where a node comes to rest or reverses its slip, friction jumps, however
   *   short the step, and with it the traction next to it; the slip rate does
   *   not;
   * - where a node slips steadily, an error of the slip rate is soon taken away
   *   by friction.
   *
   * Waves that run through bodies whose faults are stuck are in neither: a node
   * that does not slip has a slip rate without error, and only tractions near
   * the strength make it slip. They are the error of the bodies.
   */
  template <int dim, int n_components = dim>
  class StepHistory
  {
  public:
    /** @p nodal_masses: of EquationOfMotion, null for bodies without mass; @p
     * records: the newest first, three at most. All must live longer. */
    StepHistory(const FaultNodes<dim>               &faults,
                const NodeLaws                      &laws,
                const TimeScheme<dim, n_components> &scheme,
                const std::vector<double>           *nodal_masses,
                std::vector<PastState<dim>>         &records)
      : faults(faults)
      , laws(laws)
      , scheme(scheme)
      , nodal_masses(nodal_masses)
      , records(records)
    {}

    /** The shortest time that shear waves take through half a cell at a fault,
     * s, in which velocities change at nodes that have been stopped. With mass
     * only. Collective. */
    double
    wave_time() const;

    /** False if the error of the bodies in the next step will not be told,
     * since faults may open and have done so, or met, or nothing is known of
     * before.
     */
    bool
    sees_bodies() const
    {
      return !may_open() ||
             (records.size() >= 3 && touches_as_before(records[0]));
    }

    /** True if faults of bodies with mass may open. */
    bool
    may_open() const
    {
      return nodal_masses != nullptr && !records[0].is_open.empty();
    }

    /** The memory of a state after a step of that size. */
    PastState<dim>
    record(const SystemState<dim> &state, const double step_size) const;

    /** Take in an accepted state. */
    void
    add(PastState<dim> &&newest)
    {
      records.insert(records.begin(), std::move(newest));
      records.resize(std::min<std::size_t>(records.size(), 3));
    }

    /** Forget all accepted states but @p newest. */
    void
    restart(PastState<dim> &&newest)
    {
      records.clear();
      add(std::move(newest));
    }

    /** Velocity and state a step @p tau after @p state, that of the newest
     * record, whose velocity may follow another contact mapping by now. */
    Prediction<dim>
    predict(const SystemState<dim> &state, const double tau) const;

    /** Error of a step from the newest record to @p now. On the faults: the
     * fault_norm() of the error of the state and, node by node, of the smaller
     * one of the errors of traction and slip rate. Of the state alone before
     * three steps have been taken. The same on all processes. Collective. */
    StepError
    estimate_error(const PastState<dim> &now) const;

  private:
    /** A quadratic through the last three values, and the part of the deviation
     * from it that is the error of the step. */
    struct Extrapolation
    {
      double newest, older, oldest, part;
    };

    /** The one of a step of that size after three others. */
    Extrapolation
    extrapolation(const double step_size) const;

    /** The largest slip rate of that fault at the ends of the step to @p now,
     * m/s. */
    double
    largest_slip_rate(const PastState<dim> &now,
                      const unsigned int    fault) const;

    /** Traction and slip rate at each node: the smaller one of their errors. */
    std::vector<double>
    motion_errors(const PastState<dim> &now, const Extrapolation &past) const;

    /** The velocity at which shear waves carry max(a, b) times the normal
     * stress, or the largest slip rate of the fault if that is more; the least
     * of all faults, m/s; the largest number if no fault has a law of that
     * kind. Where sides may open, and none or none of that kind touch, there is
     * no strength: mean_speed(). Collective. */
    double
    velocity_scale(const PastState<dim> &now) const;

    /** The mean speed of the bodies, weighted with their mass, m/s.
     * Collective. */
    double
    mean_speed(const PastState<dim> &now) const;

    /** True if no sides have met or parted since the oldest record: velocities
     * jump where they do. */
    bool
    touches_as_before(const PastState<dim> &now) const;

    /** The error of the velocity of the bodies, over velocity_scale(): sum m
     * e^2 / sum m |e| over the nodes, m being their mass. Bodies at rest do not
     * dilute that mean, as they do the mean square, and single nodes hardly
     * change it, as they do the largest error. Collective. */
    double
    body_error(const PastState<dim> &now, const Extrapolation &past) const;

    /** The Adams-Bashforth prediction of alpha a step @p tau after the newest
     * record. */
    std::vector<double>
    predict_alpha(const double tau) const;

    /** The error of the state alone at each node, from the newest record to
     * @p now. */
    std::vector<double>
    state_errors(const PastState<dim> &now) const;

    const FaultNodes<dim>               &faults;
    const NodeLaws                      &laws;
    const TimeScheme<dim, n_components> &scheme;
    const std::vector<double>           *nodal_masses;
    std::vector<PastState<dim>>         &records;
  };
} // namespace StickSlip

#endif
