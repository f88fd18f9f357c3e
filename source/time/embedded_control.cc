// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/magnitude.h>
#include <stickslip/time/embedded_control.h>
#include <stickslip/time/shear_traction.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  typename EmbeddedControl<dim>::Past
  EmbeddedControl<dim>::remember(const SystemState<dim> &state) const
  {
    const FaultNodes<dim> &faults = this->faults;
    Past                   past;
    past.time      = state.time;
    past.velocity  = state.velocity;
    past.slip_rate = state.slip_rate;
    past.state_rate.resize(faults.size());
    past.friction.resize(faults.size());
    past.in_contact.resize(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        past.in_contact[k]  = faults.in_contact(k);
        const FaultLaw &law = faults.law(k);
        const double    V   = magnitude(state.slip_rate[k]);
        past.state_rate[k] =
          state_rate(law.state_law, state.alpha[k], V, law.characteristic_slip);
        past.friction[k] = directed_friction(faults, state, k);
      }
    return past;
  }



  template <int dim>
  std::vector<double>
  EmbeddedControl<dim>::predict_alpha(const SystemState<dim> &state,
                                      const double            tau) const
  {
    std::vector<double>        alpha  = state.alpha;
    const std::vector<double> &newest = history.front().state_rate;
    if (history.size() < 2)
      {
        for (unsigned int k = 0; k < alpha.size(); ++k)
          alpha[k] += tau * newest[k];
        return alpha;
      }
    const std::vector<double> &older = history[1].state_rate;
    const double ratio = tau / (history[0].time - history[1].time);
    for (unsigned int k = 0; k < alpha.size(); ++k)
      alpha[k] += tau * (newest[k] + ratio / 2. * (newest[k] - older[k]));
    return alpha;
  }



  template <int dim>
  typename EmbeddedControl<dim>::Estimate
  EmbeddedControl<dim>::estimate_error(
    const SystemState<dim>    &to,
    const Past                &now,
    const std::vector<double> &predicted_alpha) const
  {
    const FaultNodes<dim> &faults = this->faults;
    const unsigned int     n      = faults.size();
    const double           h      = to.time - history[0].time;

    // Without a past there is only the forward Euler prediction: its error is
    // -alpha''/2 h^2, that of the step of higher order.
    double alpha_factor = 0.5;
    if (history.size() >= 2)
      {
        const double h1 = history[0].time - history[1].time;
        alpha_factor    = 1. / (3. * (1. + h1 / h));
      }
    std::vector<double> alpha_error(n);
    for (unsigned int k = 0; k < n; ++k)
      alpha_error[k] = alpha_factor * (to.alpha[k] - predicted_alpha[k]);
    const double state_error = faults.l2_norm(alpha_error);
    if (history.size() < 3)
      return {state_error, state_error};

    const double h1 = history[0].time - history[1].time;
    const double h2 = history[1].time - history[2].time;
    const double c0 = h * h * h / 12.;
    const double cc = h * (h + h1) * (h + h1 + h2) / 6.;
    // Lagrange weights of the quadratic through the last three values.
    const double w0        = (h + h1) * (h + h1 + h2) / (h1 * (h1 + h2));
    const double w1        = -h * (h + h1 + h2) / (h1 * h2);
    const double w2        = h * (h + h1) / ((h1 + h2) * h2);
    const auto   deviation = [&](const auto &values, const unsigned k) {
      return magnitude((now.*values)[k] - w0 * (history[0].*values)[k] -
                       w1 * (history[1].*values)[k] -
                       w2 * (history[2].*values)[k]);
    };
    double fastest = 0.;
    for (unsigned int k = 0; k < n; ++k)
      fastest = std::max({fastest,
                          magnitude(now.slip_rate[k]),
                          magnitude(history[0].slip_rate[k])});
    std::vector<double> friction_error(n), slip_error(n);
    for (unsigned int k = 0; k < n; ++k)
      // Friction that a node meets on coming into contact has no past.
      if (history[0].in_contact[k] && history[1].in_contact[k] &&
          history[2].in_contact[k])
        {
          friction_error[k] =
            deviation(&Past::friction, k) * faults.relative_normal_stress()[k] /
            std::max(faults.law(k).a, faults.law(k).b) * c0 / (cc + c0);
          slip_error[k] =
            deviation(&Past::slip_rate, k) /
            std::max(fastest, faults.law(k).characteristic_slip / h) * c0 /
            (cc + c0);
        }
    return {std::hypot(state_error, faults.l2_norm(friction_error)),
            std::hypot(state_error, faults.l2_norm(slip_error))};
  }



  template <int dim>
  std::vector<StepResult<dim>>
  EmbeddedControl<dim>::advance(const SystemState<dim> &state)
  {
    const double tolerance = this->parameters.tolerance;
    if (history.empty())
      history.push_back(remember(state));

    while (true)
      {
        const double    tau = this->limit(state.time, this->proposed);
        Prediction<dim> prediction;
        prediction.alpha    = predict_alpha(state, tau);
        prediction.velocity = state.velocity;
        if (history.size() >= 2)
          {
            const double ratio = tau / (history[0].time - history[1].time);
            prediction.velocity.add(ratio,
                                    history[0].velocity,
                                    -ratio,
                                    history[1].velocity);
          }
        const std::vector<double> predicted_alpha = prediction.alpha;
        StepResult<dim> result = this->step.take(state, tau, &prediction);
        if (!result.converged)
          {
            this->proposed = this->on_grid(tau / 2.);
            just_rejected  = true;
            this->reject(state.time, this->proposed, result.failure);
            continue;
          }

        Past           now = remember(result.state);
        const Estimate estimate =
          estimate_error(result.state, now, predicted_alpha);
        const double error = estimate.error;
        last_error         = error;
        double factor =
          0.8 * std::cbrt(tolerance / std::max(error, 1e-3 * tolerance));
        factor = std::clamp(factor, 0.2, just_rejected ? 1. : 2.);
        if (!(error <= tolerance))
          {
            // Not std::min(factor, 0.5): the factor may be no number.
            this->proposed = this->on_grid((factor < 0.5 ? factor : 0.5) * tau);
            just_rejected  = true;
            std::string reason =
              "the estimated error stays above Time/Tolerance";
            if (estimate.without_traction <= tolerance)
              reason +=
                ", since the traction on a fault jumps: some node comes "
                "to rest, or reverses its slip, at once";
            this->reject(state.time, this->proposed, reason);
            continue;
          }
        // A step cut short by the end of the ramp or of the run says nothing
        // against the size that was proposed.
        if (tau >= this->proposed || factor < 1.)
          this->proposed = this->on_grid(factor * tau);
        just_rejected = false;
        history.insert(history.begin(), std::move(now));
        history.resize(std::min<std::size_t>(history.size(), 3));

        std::vector<StepResult<dim>> accepted;
        accepted.push_back(std::move(result));
        return accepted;
      }
  }



  template <int dim>
  double
  EmbeddedControl<dim>::estimated_error() const
  {
    return last_error;
  }



  template class EmbeddedControl<2>;
  template class EmbeddedControl<3>;
} // namespace StickSlip
