// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_run_state_h
#define stickslip_simulation_run_state_h

#include <stickslip/multigrid/kept_linearisation.h>
#include <stickslip/output/event_catalogue.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/file_state.h>
#include <stickslip/output/opening_catalogue.h>
#include <stickslip/output/output_cadence.h>
#include <stickslip/output/pvd_record.h>
#include <stickslip/problem/partner_force.h>
#include <stickslip/problem/system_state.h>
#include <stickslip/simulation/contact_change.h>
#include <stickslip/time/energy_balance.h>
#include <stickslip/time/step_memory.h>

#include <algorithm>

namespace StickSlip
{
  /**
   * Counts of a run for its summary.
   */
  struct RunCounts
  {
    /** Accepted steps, the work that they took, and the range of their sizes,
     * s. */
    unsigned int accepted = 0;
    StepCounts   work;
    double       smallest_step = 0, largest_step = 0;

    unsigned int equilibrium_iterations = 0;
    unsigned int contact_mappings       = 0;

    /** Nodes in contact that are under tension: at the start, and the most at
     * a time. */
    unsigned int initially_in_tension = 0, most_in_tension = 0;

    /** Take in an accepted step. */
    void
    add(const double step_size, const StepCounts &of_step)
    {
      smallest_step =
        accepted == 0 ? step_size : std::min(smallest_step, step_size);
      largest_step = std::max(largest_step, step_size);
      work += of_step;
      ++accepted;
    }

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &accepted &work &smallest_step &largest_step
        &equilibrium_iterations &contact_mappings &initially_in_tension
          &most_in_tension;
    }
  };

  /**
   * Memory of the record of a run of all that it has written. Events, openings
   * and files are known to the process only that writes.
   */
  struct RecordState
  {
    CatalogueState<EventMemory>   events;
    CatalogueState<OpeningMemory> openings;
    CadenceState  fault_cadence, station_cadence, volume_cadence;
    VolumeEntries volumes, surfaces;
    FileState     time_series, energies, history;
    /** One for each station. */
    std::vector<FileState> stations;

    /** The last step, and what it is written in already. */
    StepRecord last_step;
    double     last_slip_rate = 0;
    bool in_time_series = true, in_fault_history = true, in_stations = true,
         in_fields = true;

    /** Times whose VTU files could not be written. */
    unsigned int n_missed = 0;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &events &openings &fault_cadence &station_cadence &volume_cadence
        &volumes &surfaces &time_series &energies &history &stations &last_step
          &last_slip_rate &in_time_series &in_fault_history &in_stations
            &in_fields &n_missed;
    }
  };

  /**
   * Everything that an interrupted run needs to go on. Arrays over the slave
   * nodes are ordered by fault and node of its surface.
   */
  template <int dim, int n_components = dim>
  struct RunState
  {
    /** The state reached. */
    SystemState<dim> system;

    /** Displacement with which the faults were coupled last, m, and the place
     * of that contact mapping. */
    NodalVector       coupled_displacement;
    MappingPlace<dim> coupling;

    /** Largest gap of each fault at any coupling, m; NaN where it is plane. */
    std::vector<double> largest_gaps;

    /** Normal stress less contact pressure at the start, at each slave node,
     * Pa, see FollowingStress; empty where there is no pressure. */
    std::vector<double> stress_offset;

    /** Shear stress at each slave node that the bodies do not carry, Pa, see
     * SpatialProblem::set_prestress(); empty where there is none. */
    std::vector<Tensor<1, dim - 1>> prestress;

    /** The force since the last contact mapping; empty before the second. */
    PartnerForce partner_force;

    StepMemory<dim> steps;
    EnergyAccount   energy;
    RunCounts       counts;
    RecordState     record;

    /** RunRecord::faults(), without names and points; empty at the start. */
    std::vector<FaultSnapshot<dim>> recorded_faults;

    /** Times at which the run went on from a checkpoint, s. */
    std::vector<double> restarts;

    /** Linearisations that the solver of the rate problem keeps from step to
     * step on this process. Of use on the same number of processes only, and
     * empty after reading on another: results are the same within the
     * tolerances then, and not bit by bit. */
    std::vector<KeptLinearisation<n_components>> linearisations;

    /** Call @p action with each nodal vector of a state, in a fixed order. */
    template <typename State, typename Action>
    static void
    for_each_vector(State &state, const Action &action)
    {
      SystemState<dim>::for_each_vector(state.system, action);
      action(state.coupled_displacement);
      PartnerForce::for_each_vector(state.partner_force, action);
      StepMemory<dim>::for_each_vector(state.steps, action);
    }

    /** Everything but nodal vectors and what belongs to one process, to or from
     * a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &system &coupling &largest_gaps &stress_offset &prestress &
        partner_force &steps &energy &counts &record &recorded_faults &restarts;
    }
  };
} // namespace StickSlip

#endif
