// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/time/explicit_control.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim, int n_components>
  ExplicitControl<dim, n_components>::ExplicitControl(
    RateStateStep<dim, n_components>  &step,
    const TimeParameters              &parameters,
    BoundaryValues<dim, n_components> &loads)
    : StepSizeController<dim, n_components>(step, parameters, loads)
    , explicit_step(step.spatial_problem(),
                    step.faults(),
                    step.laws(),
                    step.following_stress())
  {
    using Problem = SpatialProblem<dim, n_components>;
    if (step.spatial_problem().has(Problem::mass) ||
        step.spatial_problem().has(Problem::damping))
      throw InputError(
        "'Time/Step size control' = 'Runge-Kutta': is for bodies "
        "without viscosity only, whose 'Shear viscosity' and "
        "'Bulk viscosity' are 0.");
  }



  template <int dim, int n_components>
  std::vector<StepResult<dim>>
  ExplicitControl<dim, n_components>::accepted_steps(
    const SystemState<dim> &state,
    StepMemory<dim>        &memory)
  {
    const double tolerance = this->parameters.tolerance;
    while (true)
      {
        const double    tau = this->limit(memory, state.time, memory.proposed);
        double          error = 0.;
        StepResult<dim> result =
          explicit_step.take(state, tau, tolerance, error);
        ++memory.n_solved;
        memory.work += result.counts;
        double factor = 0.2;
        if (std::isfinite(error))
          {
            memory.last_error = {error, 0.};
            factor =
              std::clamp(0.9 * std::pow(tolerance /
                                          std::max(error, 1e-5 * tolerance),
                                        0.2),
                         0.2,
                         memory.just_rejected ? 1. : 5.);
          }
        if (result.converged)
          {
            memory.largest_error =
              memory.largest_error.larger(memory.last_error);
            // A step cut short by an end says nothing against the size that
            // was proposed.
            if (tau >= memory.proposed || factor < 1.)
              memory.proposed =
                std::min<double>(factor * tau, this->parameters.largest_step);
            memory.just_rejected = false;
            std::vector<StepResult<dim>> accepted;
            accepted.push_back(std::move(result));
            return accepted;
          }
        memory.proposed      = std::min(factor, 0.9) * tau;
        memory.just_rejected = true;
        this->reject(memory, state.time, memory.proposed, result.failure);
      }
  }



  template class ExplicitControl<2>;
  template class ExplicitControl<3>;
  template class ExplicitControl<2, 1>;
} // namespace StickSlip
