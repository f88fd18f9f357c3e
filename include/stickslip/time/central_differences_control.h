// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_central_differences_control_h
#define stickslip_time_central_differences_control_h

#include <stickslip/time/central_differences.h>
#include <stickslip/time/embedded_control.h>

namespace StickSlip
{
  /**
   * Central differences in steps of 0.9 of the stability limit, or of that over
   * a power of two where the embedded error estimate asks for it.
   */
  template <int dim, int n_components = dim>
  class CentralDifferencesControl : public EmbeddedControl<dim, n_components>
  {
  public:
    /** For the arguments see StepSizeController. Collective. */
    CentralDifferencesControl(RateStateStep<dim, n_components>  &step,
                              const TimeParameters              &parameters,
                              BoundaryValues<dim, n_components> &loads);

    const LumpedMass<dim, n_components> *
    lumped_mass() const override
    {
      return &explicit_step.lumped_mass();
    }

    double
    longest_step() const override
    {
      return longest;
    }

  protected:
    StepResult<dim>
    attempt(StepMemory<dim>                      &memory,
            const StepHistory<dim, n_components> &history,
            const SystemState<dim>               &state,
            const double                          tau) override;

  private:
    CentralDifferences<dim, n_components> explicit_step;
    const double                          longest;
  };
} // namespace StickSlip

#endif
