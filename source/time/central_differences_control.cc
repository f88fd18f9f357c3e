// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/central_differences_control.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    /** The part of the stability limit that steps take. */
    constexpr double stable_part = 0.9;



    /** A number in three digits, not larger, so that it does not depend on the
     * order of sums. */
    double
    in_three_digits(const double number)
    {
      const double unit = std::pow(10., std::floor(std::log10(number)) - 2.);
      return std::floor(number / unit) * unit;
    }
  } // namespace



  template <int dim, int n_components>
  CentralDifferencesControl<dim, n_components>::CentralDifferencesControl(
    RateStateStep<dim, n_components>  &step,
    const TimeParameters              &parameters,
    BoundaryValues<dim, n_components> &loads)
    : EmbeddedControl<dim, n_components>(step, parameters, loads)
    , explicit_step(step.spatial_problem(), step.faults(), step.laws())
    , longest(std::min<double>(
        parameters.largest_step,
        in_three_digits(stable_part * explicit_step.stability_limit())))
  {}



  template <int dim, int n_components>
  StepResult<dim>
  CentralDifferencesControl<dim, n_components>::attempt(
    StepMemory<dim> &memory,
    const StepHistory<dim, n_components> &,
    const SystemState<dim> &state,
    const double            tau)
  {
    StepResult<dim> result = explicit_step.take(state, tau);
    ++memory.n_solved;
    memory.work += result.counts;
    return result;
  }



  template class CentralDifferencesControl<2>;
  template class CentralDifferencesControl<3>;
  template class CentralDifferencesControl<2, 1>;
} // namespace StickSlip
