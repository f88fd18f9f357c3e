// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreement.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/output/contact_states.h>
#include <stickslip/output/fault_surface_writer.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/simulation/fault_layouts.h>
#include <stickslip/simulation/fault_rigidity.h>
#include <stickslip/simulation/run_record.h>
#include <stickslip/simulation/volume_materials.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** Collective. */
    template <int dim, int n_components>
    EnergyRecord
    energy_record(const EnergyBalance<dim, n_components> &energy,
                  const SystemState<dim>                 &state)
    {
      const EnergyTerms &work = energy.work();
      EnergyRecord       record;
      record.time         = state.time;
      record.kinetic      = energy.kinetic_energy(state);
      record.elastic      = energy.elastic_energy(state);
      record.driven_sides = work.driven_sides;
      record.loads        = work.loads;
      record.friction     = work.friction;
      record.viscosity    = work.viscosity;
      record.radiation    = work.radiation;
      record.contact      = work.contact;
      record.mappings     = work.mappings;
      record.missing      = energy.missing(record.kinetic + record.elastic);
      return record;
    }
  } // namespace



  template <int dim, int n_components>
  RunRecord<dim, n_components>::RunRecord(
    const SceneParameters<dim>            &scene,
    const ContactSpace<dim, n_components> &space,
    const std::vector<FaultSnapshot<dim>> &faults,
    const std::function<void()>           &complete_state,
    const BodyValues                      &body_values,
    const RecordState                     *earlier)
    : scene(scene)
    , space(space)
    , communicator(space.meshes().finest().nodes.communicator())
    , stations(scene, space.meshes().finest(), space.jump_basis())
    , complete_state(complete_state)
    , body_values(body_values)
    , sliding_rate(event_start_slip_rate(scene))
    , fault_cadence(scene.output.fault_cadence)
    , station_cadence(scene.output.station_cadence)
    , volume_cadence(scene.output.volume_cadence)
  {
    carry_out_agreed(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::vector<FaultLayout<dim>> shapes =
        make_fault_layouts(space.jump_basis());
      for (unsigned int f = 0; f < shapes.size(); ++f)
        shapes[f].rigidity = fault_rigidity(scene, f, shapes[f].surface.points);
      files = std::make_unique<RunFiles<dim>>(
        scene, faults, shapes, stations.tables(), earlier);
    });
    if (earlier == nullptr)
      return;
    fault_cadence.resume(earlier->fault_cadence);
    station_cadence.resume(earlier->station_cadence);
    volume_cadence.resume(earlier->volume_cadence);
    last_faults      = faults;
    last_step        = earlier->last_step;
    last_slip_rate   = earlier->last_slip_rate;
    in_time_series   = earlier->in_time_series;
    in_fault_history = earlier->in_fault_history;
    in_stations      = earlier->in_stations;
    in_fields        = earlier->in_fields;
    n_missed         = earlier->n_missed;
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::add(
    const StepRecord                       &step,
    const SystemState<dim>                 &state,
    std::vector<FaultSnapshot<dim>>         faults,
    const EnergyBalance<dim, n_components> *energy)
  {
    last_step   = step;
    last_faults = std::move(faults);
    is_new      = true;
    // The state at the start is no step.
    in_time_series   = (step.step == 0);
    in_fault_history = in_stations = in_fields = false;

    last_slip_rate = 0;
    for (const auto &fault : last_faults)
      for (unsigned int k = 0; k < fault.slip_rate.size(); ++k)
        if (fault.weights[k] > 0.)
          {
            double rate = magnitude(fault.slip_rate[k]);
            // Records follow sides that part as those that slip.
            if (fault.may_open())
              rate = std::max(rate, std::abs(fault.opening_rate[k]));
            last_slip_rate = std::max(last_slip_rate, rate);
          }

    const unsigned int every = scene.output.time_series_steps;
    write(state,
          energy,
          every > 0 && step.step > 0 && step.step % every == 0,
          (scene.output.write_faults || energy != nullptr) &&
            fault_cadence.is_due(step.time, last_slip_rate),
          !stations.tables().empty() &&
            station_cadence.is_due(step.time, last_slip_rate),
          has_fields() && volume_cadence.is_due(step.time, last_slip_rate));
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::write(
    const SystemState<dim>                 &state,
    const EnergyBalance<dim, n_components> *energy,
    const bool                              series,
    const bool                              faults,
    const bool                              at_stations,
    const bool                              fields)
  {
    if (shows_bodies(faults, fields))
      complete_state();
    std::optional<EnergyRecord> energies;
    if (faults && energy != nullptr)
      energies = energy_record(*energy, state);
    const bool fault_history = faults && scene.output.write_faults;
    const bool volume        = fields && scene.output.write_volume,
               surfaces      = fields && scene.output.write_fault_surfaces;
    VolumeContent content;
    if (volume)
      {
        const MeshLevel<dim> &finest = space.meshes().finest();
        content =
          own_volume(finest,
                     {state.displacement, state.velocity, state.acceleration},
                     volume_materials(scene, finest),
                     scene.output.volume_fields);
        if (!scene.output.volume_pieces)
          content = gather_volume(finest, content);
      }
    std::vector<std::vector<double>> station_values;
    if (at_stations)
      station_values =
        stations.values(last_faults,
                        body_values(state, stations.functionals()));
    complete_faults(state, surfaces, fault_history);
    carry_out_agreed(communicator, [&]() {
      if (!files)
        return;
      if (is_new)
        {
          is_new = false;
          files->catalogue.add(last_step.time, last_faults);
          if (files->openings)
            files->openings->add(last_step.time, last_faults);
          if (last_step.step > 0)
            files->progress.update(last_step.step,
                                   last_step.time,
                                   last_step.step_size,
                                   last_slip_rate,
                                   files->catalogue.entries().size());
        }
      if (series)
        {
          files->time_series->add(last_step, last_faults);
          in_time_series = true;
        }
      if (energies && files->energies)
        files->energies->add(*energies);
      if (fault_history)
        files->history->add(last_step.time, last_faults);
      in_fault_history = in_fault_history || faults;
      if (at_stations)
        files->stations->add(last_step.time, station_values);
    });
    if (fields)
      {
        unsigned int number = 0;
        if (files)
          number =
            n_missed + std::max(files->volumes.entries().size(),
                                files->surfaces.entries().size() /
                                  std::max<std::size_t>(last_faults.size(), 1));
        // A file that cannot be written leaves a gap, and the next one is
        // tried.
        ++n_missed;
        if (volume)
          write_volume_now(Utilities::MPI::broadcast(communicator, number, 0),
                           content);
        if (surfaces)
          carry_out_agreed(communicator, [&]() {
            if (files)
              write_surfaces_now(number);
          });
        --n_missed;
      }
    if (faults)
      fault_cadence.note_written(last_step.time, last_slip_rate);
    if (at_stations)
      {
        station_cadence.note_written(last_step.time, last_slip_rate);
        in_stations = true;
      }
    if (fields)
      {
        volume_cadence.note_written(last_step.time, last_slip_rate);
        in_fields = true;
      }
  }



  template <int dim, int n_components>
  bool
  RunRecord<dim, n_components>::shows_bodies(const bool fault_history,
                                             const bool fields) const
  {
    return fields || (fault_history && has_field(scene.output.fault_fields,
                                                 FaultField::position));
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::complete_faults(const SystemState<dim> &state,
                                                const bool surfaces,
                                                const bool fault_history)
  {
    const auto is_wanted = [&](const FaultField field) {
      return (surfaces || fault_history) &&
             has_field(scene.output.fault_fields, field);
    };
    // The VTU files have positions in any case.
    if (surfaces || is_wanted(FaultField::position))
      {
        const auto positions = fault_positions(space.jump_basis(),
                                               space.meshes().finest().nodes,
                                               state.displacement);
        for (unsigned int f = 0; f < last_faults.size(); ++f)
          last_faults[f].positions = positions[f];
      }
    if (is_wanted(FaultField::contact_state))
      for (FaultSnapshot<dim> &fault : last_faults)
        fault.contact_state = contact_states(fault, sliding_rate);
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::write_volume_now(const unsigned int   number,
                                                 const VolumeContent &content)
  {
    const VolumeFiles volume_files(scene.output.directory,
                                   number,
                                   last_step.time,
                                   names_of(scene.bodies));
    if (scene.output.volume_pieces)
      {
        carry_out_agreed(communicator, [&]() {
          if (files)
            volume_files.make_folder();
        });
        carry_out_agreed(communicator, [&]() {
          volume_files.write_piece(
            Utilities::MPI::this_mpi_process(communicator), content);
        });
      }
    carry_out_agreed(communicator, [&]() {
      if (files)
        files->volumes.add(last_step.time,
                           {scene.output.volume_pieces ?
                              volume_files.join_pieces(
                                Utilities::MPI::n_mpi_processes(communicator),
                                content) :
                              volume_files.write(content)});
    });
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::write_surfaces_now(const unsigned int number)
  {
    const std::vector<FaultLayout<dim>> shapes =
      make_fault_layouts(space.jump_basis());
    std::vector<std::string> names;
    for (unsigned int f = 0; f < shapes.size(); ++f)
      names.push_back(write_fault_surface(scene.output.directory,
                                          number,
                                          last_step.time,
                                          shapes[f],
                                          last_faults[f],
                                          scene.output.fault_fields));
    files->surfaces.add(last_step.time, names);
  }



  template <int dim, int n_components>
  RecordState
  RunRecord<dim, n_components>::state() const
  {
    RecordState state;
    state.fault_cadence    = fault_cadence.state();
    state.station_cadence  = station_cadence.state();
    state.volume_cadence   = volume_cadence.state();
    state.last_step        = last_step;
    state.last_slip_rate   = last_slip_rate;
    state.in_time_series   = in_time_series;
    state.in_fault_history = in_fault_history;
    state.in_stations      = in_stations;
    state.in_fields        = in_fields;
    state.n_missed         = n_missed;
    carry_out_agreed(communicator, [&]() {
      if (!files)
        return;
      state.events = files->catalogue.state();
      if (files->openings)
        state.openings = files->openings->state();
      state.volumes  = files->volumes.entries();
      state.surfaces = files->surfaces.entries();
      if (files->time_series)
        state.time_series = files->time_series->state();
      if (files->energies)
        state.energies = files->energies->state();
      if (files->history)
        state.history = files->history->state();
      if (files->stations)
        state.stations = files->stations->state();
    });
    return state;
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::finish(
    const SystemState<dim>                 &state,
    const RunSummary                       &summary,
    const EnergyBalance<dim, n_components> *energy)
  {
    if (files)
      files->progress.finish();
    // Only the process that writes knows what is in its files.
    const auto written = Utilities::MPI::broadcast(
      communicator, std::make_pair(in_time_series, in_fault_history));
    write(state,
          energy,
          scene.output.time_series_steps > 0 && !written.first,
          (scene.output.write_faults || energy != nullptr) && !written.second,
          !stations.tables().empty() && !in_stations,
          has_fields() && !in_fields);
    carry_out_agreed(communicator, [&]() {
      if (!files)
        return;
      if (files->time_series)
        files->time_series->finish();
      files->catalogue.finish();
      RunSummary                    whole   = summary;
      RunSummary::Section          &section = whole.add_section("Events");
      const std::vector<SlipEvent> &events  = files->catalogue.entries();
      for (const FaultParameters &fault : scene.faults)
        section.add_count(fault.name,
                          std::count_if(events.begin(),
                                        events.end(),
                                        [&](const SlipEvent &event) {
                                          return event.fault == fault.name;
                                        }));
      if (files->openings)
        {
          files->openings->finish();
          add_openings(whole);
        }
      whole.write(files->directory.file("summary.txt"));
    });
  }



  template <int dim, int n_components>
  void
  RunRecord<dim, n_components>::add_openings(RunSummary &summary) const
  {
    RunSummary::Section        &section  = summary.add_section("Openings");
    const std::vector<Opening> &openings = files->openings->entries();
    for (const FaultSnapshot<dim> &fault : last_faults)
      if (fault.may_open())
        section.add_count(fault.name,
                          std::count_if(openings.begin(),
                                        openings.end(),
                                        [&](const Opening &opening) {
                                          return opening.fault == fault.name;
                                        }));
  }



  template class RunRecord<2>;
  template class RunRecord<3>;
  template class RunRecord<2, 1>;
} // namespace StickSlip
