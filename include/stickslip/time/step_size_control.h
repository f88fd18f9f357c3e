// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_size_control_h
#define stickslip_time_step_size_control_h

#include <stickslip/base/agreed_failure.h>
#include <stickslip/time/rate_state_step.h>

#include <exception>
#include <memory>
#include <optional>

namespace StickSlip
{
  /**
   * Thrown when no step down to the smallest one can be taken.
   */
  class StepSizeTooSmall : public AgreedFailure
  {
  public:
    using AgreedFailure::AgreedFailure;
  };

  /**
   * Chooses step sizes, and accepts or rejects steps. A rejected step leaves
   * no trace in the state: it is forgotten and tried anew with a smaller size.
   *
   * The sizes used are largest_step 2^-k, but for the last step to the end
   * time, so that few different operators occur.
   */
  template <int dim>
  class StepSizeController
  {
  public:
    StepSizeController(RateStateStep<dim>    &step,
                       const FaultNodes<dim> &faults,
                       const TimeParameters  &parameters,
                       BoundaryValues<dim>   &loads);

    virtual ~StepSizeController() = default;

    /**
     * Advance from @p state by one or more accepted steps, in the order of
     * time. Throws StepSizeTooSmall.
     */
    virtual std::vector<StepResult<dim>>
    advance(const SystemState<dim> &state) = 0;

    /** Whether the end time is reached. */
    bool
    is_finished(const double time) const;

    /** Number of attempts that were rejected. */
    unsigned int
    n_rejected() const;

    /** The largest error of an accepted step as StepHistory estimates it, in
     * m^((d-1)/2); zero under step doubling, which compares something else. */
    double
    largest_estimated_error() const;

  protected:
    /** The largest size of the form largest_step 2^-k up to @p tau. */
    double
    on_grid(const double tau) const;

    /** The largest step allowed at this time, by the ramp and the end. */
    double
    limit(const double time, const double tau) const;

    /** Count a rejection; throws if the next size is too small. */
    void
    reject(const double       time,
           const double       next_step_size,
           const std::string &reason);

    RateStateStep<dim>    &step;
    const FaultNodes<dim> &faults;
    const TimeParameters  &parameters;
    double                 proposed;
    double                 largest_error = 0;

  private:
    BoundaryValues<dim> &loads;
    const double         longest_ramp;
    unsigned int         rejections = 0;
  };

  /**
   * The controller that the parameters ask for.
   */
  template <int dim>
  std::unique_ptr<StepSizeController<dim>>
  make_step_size_controller(RateStateStep<dim>    &step,
                            const FaultNodes<dim> &faults,
                            const TimeParameters  &parameters,
                            BoundaryValues<dim>   &loads);
} // namespace StickSlip

#endif
