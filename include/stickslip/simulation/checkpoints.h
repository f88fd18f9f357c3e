// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_checkpoints_h
#define stickslip_simulation_checkpoints_h

#include <deal.II/base/timer.h>

#include <stickslip/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The checkpoints of a run: files checkpoints/<step>.state in its output
   * folder, each of them a state from which the run can go on. Decides when one
   * is due, and removes those that are not to be kept.
   */
  class Checkpoints
  {
  public:
    /** At the start of a run, or where it goes on, @p time in s. */
    Checkpoints(const OutputParameters &parameters,
                const double            time,
                const MPI_Comm          communicator);

    /** True if there are any. */
    bool
    are_written() const
    {
      return parameters.checkpoints_kept > 0;
    }

    /** True if it is time for one; the same answer on all processes.
     * Collective. */
    bool
    is_due(const double time) const;

    /** Make the folder, and return the name of the file of a checkpoint.
     * Throws InputError. Collective. */
    std::string
    file(const unsigned int step) const;

    /** Take note of a checkpoint that has been written, and remove older ones.
     * Collective. */
    void
    note_written(const double time);

  private:
    const OutputParameters &parameters;
    const MPI_Comm          communicator;
    Timer                   since_last;
    double                  last_time;
  };

  /** The files of all checkpoints in the output folder of a run, the newest
   * first. */
  std::vector<std::string>
  checkpoint_files(const std::string &output_directory);

  /**
   * The newest whole checkpoint of a scene. Newer ones that are damaged are
   * named on the terminal. Throws InputError if there is none, or if it is that
   * of a run with other parameters than those that may change: the end time and
   * output, except for what faults.h5 holds. Collective.
   */
  template <int dim>
  std::string
  find_checkpoint(const SceneParameters<dim> &scene,
                  const MPI_Comm              communicator);
} // namespace StickSlip

#endif
