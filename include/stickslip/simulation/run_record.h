// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_run_record_h
#define stickslip_simulation_run_record_h

#include <stickslip/output/output_cadence.h>
#include <stickslip/output/run_summary.h>
#include <stickslip/output/volume_files.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/scene/scene_parameters.h>
#include <stickslip/simulation/run_files.h>
#include <stickslip/simulation/run_state.h>
#include <stickslip/simulation/stations.h>
#include <stickslip/time/energy_balance.h>

#include <functional>

namespace StickSlip
{
  /**
   * All files of one run: decides what of a step is written where, and keeps
   * what is there complete at any moment.
   *
   * The first process writes for all, which have objects of this class and take
   * the same decisions. All member functions but those that tell something are
   * collective; if a file cannot be written, all processes throw.
   */
  template <int dim, int n_components = dim>
  class RunRecord
  {
  public:
    using BodyValues =
      std::function<FunctionalValues(const SystemState<dim> &,
                                     const std::vector<NodalFunctional> &)>;

    /**
     * Creates the output folder and the files. @p space, whose contact mapping
     * may change later, and @p faults as at the start; @p complete_state lets
     * the bodies of the state follow, and is called before they are written,
     * @p body_values tells values that they have or would have; or goes on with
     * the files of an @p earlier record, which are as they were then again,
     * with the faults of that moment.
     */
    RunRecord(const SceneParameters<dim>            &scene,
              const ContactSpace<dim, n_components> &space,
              const std::vector<FaultSnapshot<dim>> &faults,
              const std::function<void()>           &complete_state,
              const BodyValues                      &body_values,
              const RecordState                     *earlier = nullptr);

    /** Take in an accepted step; the state at the start has number 0. @p
     * energy: account up to this state, null if there is none. */
    void
    add(const StepRecord                       &step,
        const SystemState<dim>                 &state,
        std::vector<FaultSnapshot<dim>>         faults,
        const EnergyBalance<dim, n_components> *energy);

    /** The faults as they were taken in last: with the contact mapping of that
     * step, which another one may have followed. */
    const std::vector<FaultSnapshot<dim>> &
    faults() const
    {
      return last_faults;
    }

    /** Memory of all that has been written so far. */
    RecordState
    state() const;

    /** Write the last state, the one added last, and whatever waits, and the
     * summary. To be called however the run ends. */
    void
    finish(const SystemState<dim>                 &state,
           const RunSummary                       &summary,
           const EnergyBalance<dim, n_components> *energy);

  private:
    /** Add the last step to the files asked for; nodal values are gathered
     * first. @p fields: all VTU files. */
    void
    write(const SystemState<dim>                 &state,
          const EnergyBalance<dim, n_components> *energy,
          const bool                              series,
          const bool                              fault_history,
          const bool                              at_stations,
          const bool                              fields);

    /** Fill in the fields of the last faults that only files have.
     * Collective. */
    void
    complete_faults(const SystemState<dim> &state,
                    const bool              surfaces,
                    const bool              fault_history);

    /** Openings of each fault that may open, for the summary. */
    void
    add_openings(RunSummary &summary) const;

    /** Write the files of the bodies with a number that all processes know,
     * from the @p content of all on the first of them, or of each. Collective.
     */
    void
    write_volume_now(const unsigned int number, const VolumeContent &content);

    void
    write_surfaces_now(const unsigned int number);

    /** True if files that are written show where bodies or their nodes are. */
    bool
    shows_bodies(const bool fault_history, const bool fields) const;

    /** True if there are VTU files. */
    bool
    has_fields() const
    {
      return scene.output.write_volume || scene.output.write_fault_surfaces;
    }

    const SceneParameters<dim>            &scene;
    const ContactSpace<dim, n_components> &space;
    const MPI_Comm                         communicator;
    const Stations<dim>                    stations;
    const std::function<void()>            complete_state;
    const BodyValues                       body_values;
    /** Slip rate from which on a node slides, m/s. */
    const double sliding_rate;
    /** On the process that writes. */
    std::unique_ptr<RunFiles<dim>> files;
    OutputCadence                  fault_cadence;
    OutputCadence                  station_cadence;
    OutputCadence                  volume_cadence;

    /** The last step taken in, and whether it is in the files; of the time
     * series only the process knows that writes. */
    StepRecord                      last_step;
    std::vector<FaultSnapshot<dim>> last_faults;
    double                          last_slip_rate   = 0;
    bool                            is_new           = false;
    bool                            in_time_series   = true;
    bool                            in_fault_history = true;
    bool                            in_stations      = true;
    bool                            in_fields        = true;

    /** Times whose VTU files could not be written. */
    unsigned int n_missed = 0;
  };
} // namespace StickSlip

#endif
