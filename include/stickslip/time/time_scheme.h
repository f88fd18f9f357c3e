// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_time_scheme_h
#define stickslip_time_time_scheme_h

#include <stickslip/problem/spatial_problem.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/problem/unilateral_contact.h>

#include <memory>
#include <utility>

namespace StickSlip
{
  /**
   * Formulas for a step of size tau of the displacement u and velocity v of
   *
   *   M v' + C v + K u + friction(v) = f
   *
   * with the velocity at its end as the unknown. Displacement and acceleration
   * there are taken as
   *
   *   u1 = u* + c_K v1,   v1' = c_M v1 - a*,
   *
   * with u* and a* from the state at the start, so that the equation at the end
   * of the step is the rate problem
   *
   *   (c_M M + C + c_K K) v1 + friction(v1) = f1 + M a* - K u*.
   */
  template <int dim, int n_components = dim>
  class TimeScheme
  {
  public:
    virtual ~TimeScheme() = default;

    /** The factors c_M, 1 and c_K of mass, damping and stiffness, for a step of
     * size @p tau after one of size @p last, s; zero if there was none. */
    std::vector<double>
    operator_coefficients(const double tau, const double last = 0.) const;

    /** The right hand side f1 + M a* - K u*, a dual vector of the jump basis.
     * Collective. */
    virtual NodalVector
    right_hand_side(SpatialProblem<dim, n_components> &problem,
                    const SystemState<dim>            &from,
                    const double                       tau) const;

    /** The gap at the end of a step, for faults that may open; @p last as
     * above. */
    virtual GapPath
    gap_path(const double tau, const double last) const = 0;

    /** The pressure at the end of a step, Pa, from that of the rate problem
     * and the one of the step before, where both sides touch after either;
     * unless a scheme says something else the first of them. */
    virtual double
    end_pressure(const double pressure,
                 const double,
                 const double,
                 const double) const
    {
      return pressure;
    }

    /** Displacement, slip, and acceleration or mean rates of @p to, from its
     * velocity and slip rate. */
    virtual void
    complete(SystemState<dim>       &to,
             const SystemState<dim> &from,
             const double            tau) const = 0;

    /** Set the force that @p to carries to the next step, if the scheme has
     * one:
     * @p w, @p w_stopped: velocities of the rate problem and after impacts, @p
     * reaction: of the contact over the whole step, all in the jump basis.
     * Collective. */
    virtual void
    set_end_force(SystemState<dim> &,
                  const SystemState<dim> &,
                  const double,
                  SpatialProblem<dim, n_components> &,
                  const NodalVector &,
                  const NodalVector &,
                  const NodalVector &) const
    {}

    /** The local error of the displacement over its third derivative, s^3, in a
     * step of size @p tau after one of size @p last. */
    virtual double
    error_constant(const double tau, const double last) const = 0;

  protected:
    /** c_M and c_K. */
    virtual std::pair<double, double>
    end_weights(const double tau, const double last) const = 0;

    /** u*, m. */
    virtual NodalVector
    known_displacement(const SystemState<dim> &from,
                       const double            tau) const = 0;

    /** a*, m/s^2; zero unless a scheme says something else. */
    virtual NodalVector
    known_acceleration(const SystemState<dim> &from, const double tau) const;
  };
} // namespace StickSlip

#endif
