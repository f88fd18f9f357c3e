// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/local_products.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/faults/fault_norm.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/time/step_history.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace StickSlip
{
  template <int dim, int n_components>
  double
  StepHistory<dim, n_components>::wave_time() const
  {
    double least = std::numeric_limits<double>::max();
    for (const unsigned int k : faults.owned_contact())
      if (laws[k].shear_impedance > 0.)
        least = std::min(least,
                         (*nodal_masses)[faults.node(k)] /
                           (faults.weights()[k] * laws[k].shear_impedance));
    return Utilities::MPI::min(least,
                               records[0].velocity.get_mpi_communicator());
  }



  template <int dim, int n_components>
  PastState<dim>
  StepHistory<dim, n_components>::record(const SystemState<dim> &state,
                                         const double step_size) const
  {
    PastState<dim> result;
    result.step_size = step_size;
    // To assign to a vector without a partition takes a message.
    NodalVector(state.velocity).swap(result.velocity);
    result.alpha            = state.alpha;
    result.slip_rate        = state.slip_rate;
    result.normal_stress    = state.normal_stress;
    result.contact_pressure = state.contact_pressure;
    result.state_rate.resize(faults.size());
    result.friction.resize(faults.size());
    result.in_contact.resize(faults.size());
    for (const double gap : state.gap)
      result.is_open.push_back(gap > 0.);
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        const FaultLaw &law     = laws[k];
        const bool      is_open = !state.gap.empty() && result.is_open[k];
        // Sides that are apart feel nothing of each other.
        result.in_contact[k] = faults.in_contact(k) && !is_open;
        const double V       = is_open ? 0. : magnitude(state.slip_rate[k]);
        if (law.state_law && !(is_open && law.is_frozen_open))
          result.state_rate[k] =
            law.state_law->rate(state.alpha[k], V, law.characteristic_slip);
        result.friction[k] = directed_friction(faults, laws, state, k);
      }
    return result;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepHistory<dim, n_components>::predict_alpha(const double tau) const
  {
    std::vector<double>        alpha  = records[0].alpha;
    const std::vector<double> &newest = records[0].state_rate;
    if (records.size() < 2)
      {
        for (unsigned int k = 0; k < alpha.size(); ++k)
          alpha[k] += tau * newest[k];
        return alpha;
      }
    const std::vector<double> &older = records[1].state_rate;
    const double               ratio = tau / records[0].step_size;
    for (unsigned int k = 0; k < alpha.size(); ++k)
      alpha[k] += tau * (newest[k] + ratio / 2. * (newest[k] - older[k]));
    return alpha;
  }



  template <int dim, int n_components>
  Prediction<dim>
  StepHistory<dim, n_components>::predict(const SystemState<dim> &state,
                                          const double            tau) const
  {
    Prediction<dim> prediction{state.velocity,
                               predict_alpha(tau),
                               state.contact_pressure};
    if (records.size() >= 2)
      {
        const double ratio = tau / records[0].step_size;
        prediction.velocity.add(ratio,
                                records[0].velocity,
                                -ratio,
                                records[1].velocity);
        for (unsigned int k = 0; k < prediction.contact_pressure.size(); ++k)
          prediction.contact_pressure[k] +=
            ratio *
            (records[0].contact_pressure[k] - records[1].contact_pressure[k]);
      }
    return prediction;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepHistory<dim, n_components>::state_errors(const PastState<dim> &now) const
  {
    // Without a past there is only the forward Euler prediction: its error is
    // -alpha''/2 h^2, that of the step of higher order.
    double factor = 0.5;
    if (records.size() >= 2)
      factor = 1. / (3. * (1. + records[0].step_size / now.step_size));
    std::vector<double> errors = predict_alpha(now.step_size);
    for (unsigned int k = 0; k < errors.size(); ++k)
      errors[k] = factor * (now.alpha[k] - errors[k]);
    // The rate of the state jumps where sides part or meet, which tells nothing
    // of the error.
    for (unsigned int k = 0; k < now.is_open.size(); ++k)
      for (unsigned int i = 0; i < std::min<unsigned int>(2, records.size());
           ++i)
        if (records[i].is_open[k] != now.is_open[k])
          errors[k] = 0.;
    return errors;
  }



  template <int dim, int n_components>
  typename StepHistory<dim, n_components>::Extrapolation
  StepHistory<dim, n_components>::extrapolation(const double step_size) const
  {
    const double h  = step_size;
    const double h1 = records[0].step_size;
    const double h2 = records[1].step_size;
    const double c0 = scheme.error_constant(h, h1);
    const double cc = h * (h + h1) * (h + h1 + h2) / 6.;
    return {(h + h1) * (h + h1 + h2) / (h1 * (h1 + h2)),
            -h * (h + h1 + h2) / (h1 * h2),
            h * (h + h1) / ((h1 + h2) * h2),
            c0 / (cc + c0)};
  }



  template <int dim, int n_components>
  double
  StepHistory<dim, n_components>::largest_slip_rate(
    const PastState<dim> &now,
    const unsigned int    fault) const
  {
    double                           largest = 0.;
    const std::vector<unsigned int> &first   = faults.first_of_fault();
    for (unsigned int k = first[fault]; k < first[fault + 1]; ++k)
      if (now.in_contact[k])
        largest = std::max({largest,
                            magnitude(now.slip_rate[k]),
                            magnitude(records[0].slip_rate[k])});
    return largest;
  }



  template <int dim, int n_components>
  std::vector<double>
  StepHistory<dim, n_components>::motion_errors(const PastState<dim> &now,
                                                const Extrapolation &past) const
  {
    const auto deviation = [&](const auto &values, const unsigned k) {
      return magnitude((now.*values)[k] -
                       past.newest * (records[0].*values)[k] -
                       past.older * (records[1].*values)[k] -
                       past.oldest * (records[2].*values)[k]);
    };

    const std::vector<double> stress = faults.over_mean(now.normal_stress);
    std::vector<double>       errors(faults.size());
    const std::vector<unsigned int> &first = faults.first_of_fault();
    for (unsigned int f = 0; f + 1 < first.size(); ++f)
      {
        const double fastest = largest_slip_rate(now, f);
        for (unsigned int k = first[f]; k < first[f + 1]; ++k)
          // Friction that a node meets on coming into contact has no past.
          if (records[0].in_contact[k] && records[1].in_contact[k] &&
              records[2].in_contact[k])
            {
              const FaultLaw &law = laws[k];
              if (law.is_prescribed)
                continue;
              double error =
                deviation(&PastState<dim>::slip_rate, k) /
                std::max(fastest, law.characteristic_slip / now.step_size);
              if (const double scale = law.friction->rate_scale(); scale > 0.)
                error = std::min(error,
                                 deviation(&PastState<dim>::friction, k) *
                                   stress[k] / scale);
              errors[k] = error * past.part;
            }
      }
    return errors;
  }



  template <int dim, int n_components>
  double
  StepHistory<dim, n_components>::mean_speed(const PastState<dim> &now) const
  {
    const double         *v = now.velocity.begin();
    std::array<double, 2> parts{};
    for (unsigned int node = 0; node < nodal_masses->size(); ++node)
      {
        double square = 0.;
        for (unsigned int i = node * n_components;
             i < (node + 1) * n_components;
             ++i)
          square += v[i] * v[i];
        parts[0] += (*nodal_masses)[node] * std::sqrt(square);
        parts[1] += (*nodal_masses)[node];
      }
    const auto [momentum, mass] =
      sums<2>(parts, now.velocity.get_mpi_communicator());
    return momentum / mass;
  }



  template <int dim, int n_components>
  double
  StepHistory<dim, n_components>::velocity_scale(
    const PastState<dim> &now) const
  {
    double                           least = std::numeric_limits<double>::max();
    const std::vector<unsigned int> &first = faults.first_of_fault();
    bool                             touches = false, has_rate_laws = false;
    for (unsigned int f = 0; f + 1 < first.size(); ++f)
      {
        double sum = 0., area = 0.;
        for (unsigned int k = first[f]; k < first[f + 1]; ++k)
          {
            const FaultLaw &law    = laws[k];
            const double    weight = faults.weights()[k];
            touches                = touches || now.in_contact[k];
            if (!faults.in_contact(k) || law.is_prescribed ||
                !(law.shear_impedance > 0.))
              continue;
            has_rate_laws = has_rate_laws || law.friction->rate_scale() > 0.;
            sum += weight * law.friction->rate_scale() * now.normal_stress[k] /
                   law.shear_impedance;
            area += weight;
          }
        if (sum > 0.)
          least =
            std::min(least, std::max(sum / area, largest_slip_rate(now, f)));
      }
    if (least == std::numeric_limits<double>::max() && may_open() &&
        (has_rate_laws || !touches))
      return mean_speed(now);
    return least;
  }



  template <int dim, int n_components>
  bool
  StepHistory<dim, n_components>::touches_as_before(
    const PastState<dim> &now) const
  {
    return std::all_of(records.begin(), records.end(), [&](const auto &record) {
      return record.is_open == now.is_open;
    });
  }



  template <int dim, int n_components>
  double
  StepHistory<dim, n_components>::body_error(const PastState<dim> &now,
                                             const Extrapolation  &past) const
  {
    const double scale = velocity_scale(now);
    if (scale == std::numeric_limits<double>::max())
      return 0.;
    // Sums of m e^2 and m |e|.
    std::array<double, 2> parts{};
    const double *v = now.velocity.begin(), *v0 = records[0].velocity.begin(),
                 *v1 = records[1].velocity.begin(),
                 *v2 = records[2].velocity.begin();
    for (unsigned int node = 0; node < nodal_masses->size(); ++node)
      {
        double square = 0.;
        for (unsigned int i = node * n_components;
             i < (node + 1) * n_components;
             ++i)
          {
            const double e = v[i] - past.newest * v0[i] - past.older * v1[i] -
                             past.oldest * v2[i];
            square += e * e;
          }
        parts[0] += (*nodal_masses)[node] * square;
        parts[1] += (*nodal_masses)[node] * std::sqrt(square);
      }
    const auto [squares, sizes] =
      sums<2>(parts, now.velocity.get_mpi_communicator());
    return sizes > 0. ? past.part * squares / sizes / scale : 0.;
  }



  template <int dim, int n_components>
  StepError
  StepHistory<dim, n_components>::estimate_error(
    const PastState<dim> &now) const
  {
    StepError error;
    error.faults = fault_norm(faults, laws, state_errors(now));
    if (records.size() >= 3)
      {
        const Extrapolation past = extrapolation(now.step_size);
        error.faults =
          std::hypot(error.faults,
                     fault_norm(faults, laws, motion_errors(now, past)));
        if (nodal_masses != nullptr && touches_as_before(now))
          error.bodies = body_error(now, past);
      }
    // Sums may differ in their last digits from process to process, and steps
    // must not.
    const MPI_Comm communicator = now.velocity.get_mpi_communicator();
    return Utilities::MPI::n_mpi_processes(communicator) == 1 ?
             error :
             Utilities::MPI::broadcast(communicator, error);
  }



  template class StepHistory<2>;
  template class StepHistory<3>;
  template class StepHistory<2, 1>;
} // namespace StickSlip
