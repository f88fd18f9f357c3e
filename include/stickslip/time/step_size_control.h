// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_step_size_control_h
#define stickslip_time_step_size_control_h

#include <stickslip/base/agreed_failure.h>
#include <stickslip/problem/lumped_mass.h>
#include <stickslip/problem/nodal_functional.h>
#include <stickslip/time/rate_state_step.h>
#include <stickslip/time/step_history.h>

#include <functional>
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
   * Thrown when a run is to stop before a step has been accepted.
   */
  struct StepInterrupted
  {};

  /**
   * Chooses step sizes, and accepts or rejects steps. A rejected step leaves
   * no trace in the state: it is forgotten and tried anew with a smaller size.
   * Everything that is remembered from step to step is in a StepMemory.
   *
   * The sizes used are longest_step() 2^-k, but for the last steps to the end
   * time and to breaks of the loads, so that few different operators occur.
   */
  template <int dim, int n_components = dim>
  class StepSizeController
  {
  public:
    /** All must live longer. */
    StepSizeController(RateStateStep<dim, n_components>  &step,
                       const TimeParameters              &parameters,
                       BoundaryValues<dim, n_components> &loads)
      : step(step)
      , parameters(parameters)
      , loads(loads)
    {}

    virtual ~StepSizeController() = default;

    /**
     * Advance from @p state by one or more accepted steps, in the order of
     * time. @p memory: of the steps that have led to it. Throws
     * StepSizeTooSmall and StepInterrupted.
     */
    std::vector<StepResult<dim>>
    advance(const SystemState<dim> &state, StepMemory<dim> &memory);

    /** Let the bodies of a state follow its faults, where steps leave that to
     * those who look at them. Collective. */
    virtual void
    complete(SystemState<dim> &)
    {}

    /** The values of functionals that bodies have, or would have if they
     * followed the faults: the same functionals at each call. Collective. */
    virtual FunctionalValues
    body_values(const SystemState<dim>             &state,
                const std::vector<NodalFunctional> &functionals);

    /** The longest step that may be taken, s. */
    virtual double
    longest_step() const
    {
      return parameters.largest_step;
    }

    /** The mass that steps take in the place of that of the problem; null for
     * none. */
    virtual const LumpedMass<dim, n_components> *
    lumped_mass() const
    {
      return nullptr;
    }

    /** Look at @p condition between two attempts, if it is not empty; the same
     * answer on all processes. */
    void
    stop_if(std::function<bool()> condition)
    {
      must_stop = std::move(condition);
    }

    /** True if the end time is reached. */
    bool
    is_finished(const double time) const
    {
      return parameters.end_time - time <= 1e-12 * parameters.end_time;
    }

  protected:
    /** The accepted steps of advance(), with a size proposed. */
    virtual std::vector<StepResult<dim>>
    accepted_steps(const SystemState<dim> &state, StepMemory<dim> &memory) = 0;

    /** A step from @p from, begun at @p prediction, if any, and counted; it is
     * two of them, before and after the moment of contact, where sides that
     * come together take energy and less of it so. */
    StepResult<dim>
    take(StepMemory<dim>        &memory,
         const SystemState<dim> &from,
         const double            tau,
         const Prediction<dim>  *prediction = nullptr) const;

    /** The time from the start of a step until the first gap that it closes is
     * closed at the rate of the start, s, if that is inside of it. */
    std::optional<double>
    time_of_contact(const SystemState<dim> &from,
                    const StepResult<dim>  &step_taken) const;

    /** Count a rejection; throws if the next size is too small, or if the run
     * is to stop. */
    void
    reject(StepMemory<dim>   &memory,
           const double       time,
           const double       next_step_size,
           const std::string &reason) const;

    /** The history in @p memory, which begins with @p state if there is none.
     */
    StepHistory<dim, n_components>
    history(StepMemory<dim> &memory, const SystemState<dim> &state) const;

    /** The largest size of the form longest_step() 2^-k up to @p tau. */
    double
    on_grid(const double tau) const;

    /** The largest step allowed at this time, by the ramp, by loads and by
     * the next time at which a step must end. */
    double
    limit(StepMemory<dim> &memory, const double time, const double tau) const;

    RateStateStep<dim, n_components> &step;
    const TimeParameters             &parameters;

  private:
    /** The next time at which a step must end. */
    double
    next_end(const double time) const;

    BoundaryValues<dim, n_components> &loads;
    std::function<bool()>              must_stop;
  };

  /**
   * The controller that the parameters ask for.
   */
  template <int dim, int n_components = dim>
  std::unique_ptr<StepSizeController<dim, n_components>>
  make_step_size_controller(RateStateStep<dim, n_components>  &step,
                            const TimeParameters              &parameters,
                            BoundaryValues<dim, n_components> &loads);
} // namespace StickSlip

#endif
