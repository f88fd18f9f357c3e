// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_embedded_control_h
#define stickslip_time_embedded_control_h

#include <stickslip/time/step_size_control.h>

namespace StickSlip
{
  /**
   * Step size control by an error estimate from the history, at one solve a
   * step. Two quantities of each contact node are compared with their
   * extrapolations over steps h (the current one), h1 and h2:
   *
   * - state: e = (alpha - AB2) / (3 (1 + h1/h)), where AB2 is the
   *   Adams-Bashforth prediction from the last two state rates;
   * - traction: e = |m - extrapolated| / max(a, b) * c0 / (cc + c0), where m is
   *   the friction coefficient times the direction of the slip rate and times
   *   the normal stress over its mean on the fault, c0 = h^3/12 and cc =
   *   h (h + h1) (h + h1 + h2) / 6.
   *
   * Both are Milne's device: the known ratio of the error constants of the
   * step and of its prediction. The error is the L2(fault) norm of both; the
   * next size is 0.8 (tolerance / error)^(1/3) times the last, between a
   * fifth and twice, and does not grow right after a rejection.
   *
   * Friction jumps where a node comes to rest or its slip reverses, and with it
   * the traction next to it, however short the step. To tell this cause in the
   * message, the error is estimated without the traction, too: with |V -
   * extrapolated| / max(the largest slip rate, L/h) * c0 / (cc + c0) instead.
   */
  template <int dim>
  class EmbeddedControl : public StepSizeController<dim>
  {
  public:
    using StepSizeController<dim>::StepSizeController;

    std::vector<StepResult<dim>>
    advance(const SystemState<dim> &state) override;

    /** The estimated error of the last step that could be solved. */
    double
    estimated_error() const;

  private:
    /** What is remembered of an accepted state. */
    struct Past
    {
      double              time = 0;
      NodalVector         velocity;
      std::vector<double> state_rate;
      /** Friction coefficient times the direction of the slip rate. */
      std::vector<Tensor<1, dim - 1>> friction;
      /** Whether there was any. */
      std::vector<bool> in_contact;
      /** Slave relative to master, m/s. */
      std::vector<Tensor<1, dim - 1>> slip_rate;
    };

    Past
    remember(const SystemState<dim> &state) const;

    /** The Adams-Bashforth prediction over a step tau from the last state. */
    std::vector<double>
    predict_alpha(const SystemState<dim> &state, const double tau) const;

    struct Estimate
    {
      /** Of state and traction; of state and slip rate. */
      double error, without_traction;
    };

    Estimate
    estimate_error(const SystemState<dim>    &to,
                   const Past                &now,
                   const std::vector<double> &predicted_alpha) const;

    /** The newest first; three at most. */
    std::vector<Past> history;
    bool              just_rejected = false;
    double            last_error    = 0;
  };
} // namespace StickSlip

#endif
