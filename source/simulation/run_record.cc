// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/magnitude.h>
#include <stickslip/output/volume_writer.h>
#include <stickslip/simulation/agreement.h>
#include <stickslip/simulation/loading_rate.h>
#include <stickslip/simulation/run_record.h>
#include <stickslip/simulation/scene_writer.h>

#include <algorithm>
#include <iostream>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::vector<std::string>
    names_of(const SceneParameters<dim> &scene)
    {
      std::vector<std::string> names;
      for (const FaultParameters &fault : scene.faults)
        names.push_back(fault.name);
      return names;
    }



    OutputDirectory
    prepared_directory(const std::string &path)
    {
      OutputDirectory directory(path);
      directory.remove_earlier_results();
      return directory;
    }
  } // namespace



  template <int dim>
  RunRecord<dim>::Files::Files(const SceneParameters<dim>            &scene,
                               const std::vector<FaultSnapshot<dim>> &faults)
    : directory(prepared_directory(scene.output.directory))
    , time_series(directory.file("time_series.csv"), names_of(scene))
    , catalogue(directory.file("events.csv"),
                names_of(scene),
                event_start_slip_rate(scene),
                scene.output.event_end_fraction)
    , history(directory.file("faults.h5"), faults)
    , pvd(directory.file("solution.pvd"))
    , progress(std::cout,
               Progress::standard_output_is_terminal(),
               scene.time.end_time)
  {
    write_parameters(scene, directory.file("parameters.prm"));
  }



  template <int dim>
  RunRecord<dim>::RunRecord(const SceneParameters<dim>            &scene,
                            const MeshLevel<dim>                  &level,
                            const std::vector<FaultSnapshot<dim>> &faults)
    : scene(scene)
    , level(level)
    , communicator(level.nodes.communicator())
    , fault_cadence(scene.output.fault_slip_rate_factor,
                    scene.output.fault_slip_interval,
                    scene.output.fault_shortest_interval,
                    scene.output.fault_longest_interval)
    , volume_cadence(scene.output.volume_slip_rate_factor,
                     scene.output.volume_slip_interval,
                     scene.output.volume_shortest_interval,
                     scene.output.volume_longest_interval)
  {
    carry_out_agreed(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        files = std::make_unique<Files>(scene, faults);
    });
  }



  template <int dim>
  void
  RunRecord<dim>::add(const StepRecord                      &step,
                      const SystemState<dim>                &state,
                      const std::vector<FaultSnapshot<dim>> &faults)
  {
    last_step        = step;
    last_state       = &state;
    last_faults      = faults;
    in_fault_history = in_volume_output = false;

    last_slip_rate = 0;
    for (const auto &fault : faults)
      for (unsigned int k = 0; k < fault.slip_rate.size(); ++k)
        if (fault.weights[k] > 0.)
          last_slip_rate =
            std::max(last_slip_rate, magnitude(fault.slip_rate[k]));

    write(true,
          fault_cadence.is_due(step.time, last_slip_rate),
          scene.output.write_volume &&
            volume_cadence.is_due(step.time, last_slip_rate));
  }



  template <int dim>
  void
  RunRecord<dim>::write(const bool series,
                        const bool fault_history,
                        const bool volume)
  {
    std::vector<double> displacement, velocity;
    if (volume)
      {
        displacement = gather_on_first(last_state->displacement);
        velocity     = gather_on_first(last_state->velocity);
      }
    carry_out_agreed(communicator, [&]() {
      if (!files)
        return;
      if (series)
        {
          if (last_step.step > 0)
            {
              files->time_series.add(last_step, last_faults);
              files->progress.update(last_step.time,
                                     last_step.step_size,
                                     last_slip_rate);
            }
          files->catalogue.add(last_step.time, last_faults);
        }
      if (fault_history)
        {
          files->history.add(last_step.time, last_faults);
          in_fault_history = true;
        }
      if (volume)
        write_volume_now(displacement, velocity);
    });
    if (fault_history)
      fault_cadence.note_written(last_step.time, last_slip_rate);
    if (volume)
      {
        volume_cadence.note_written(last_step.time, last_slip_rate);
        in_volume_output = true;
      }
  }



  template <int dim>
  void
  RunRecord<dim>::write_volume_now(const std::vector<double> &displacement,
                                   const std::vector<double> &velocity)
  {
    std::vector<std::pair<double, double>> lame_parameters;
    for (const BodyParameters<dim> &body : scene.bodies)
      lame_parameters.emplace_back(body.material.lame_lambda(),
                                   body.material.shear_modulus());
    files->pvd.add(last_step.time,
                   write_volume(scene.output.directory,
                                n_volumes++,
                                last_step.time,
                                level,
                                displacement,
                                velocity,
                                lame_parameters));
  }



  template <int dim>
  void
  RunRecord<dim>::finish(const RunSummary &summary)
  {
    if (files)
      files->progress.finish();
    write(false,
          !in_fault_history,
          scene.output.write_volume && !in_volume_output);
    carry_out_agreed(communicator, [&]() {
      if (!files)
        return;
      files->catalogue.finish();
      RunSummary                    whole  = summary;
      const std::vector<SlipEvent> &events = files->catalogue.events();
      for (const FaultParameters &fault : scene.faults)
        whole.add_count("Events",
                        fault.name,
                        std::count_if(events.begin(),
                                      events.end(),
                                      [&](const SlipEvent &event) {
                                        return event.fault == fault.name;
                                      }));
      whole.write(files->directory.file("summary.txt"));
    });
  }



  template class RunRecord<2>;
  template class RunRecord<3>;
} // namespace StickSlip
