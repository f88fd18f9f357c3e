// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_event_catalogue_h
#define stickslip_output_event_catalogue_h

#include <stickslip/output/event_source.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/node_positions.h>
#include <stickslip/output/table_columns.h>
#include <stickslip/output/table_file.h>

#include <limits>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * One slip event of one fault.
   */
  struct SlipEvent
  {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    std::string fault;

    /** Times, s; the end of an event that never ended is NaN. */
    double start     = nan;
    double peak_time = nan;
    double end       = nan;

    /** Largest mean slip rate, at the peak time, and largest slip rate of any
     * node during the event, m/s. */
    double peak_mean_slip_rate = 0;
    double peak_slip_rate      = 0;

    /** Growth of the mean slip during the event, m. */
    double mean_slip = 0;

    /** Reference position of the fastest node when the fastest node's slip rate
     * last rose above the threshold before the event, m, as NodePositions has
     * it. */
    std::vector<double> nucleation;

    /** From the start to the end, or to the last step. */
    EventSource source;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &fault &start &peak_time &end &peak_mean_slip_rate &peak_slip_rate
        &mean_slip &nucleation &source;
    }
  };

  /**
   * Memory of a catalogue of events from step to step.
   */
  struct EventState
  {
    /** The last step as one fault took part in it, and its event, if that is
     * open. */
    struct Fault
    {
      std::string         name;
      bool                has_past = false;
      double              time     = 0;
      FaultStatistics     statistics;
      std::vector<double> nucleation;
      FaultMotion         motion;
      bool                is_open    = false;
      double              start_slip = 0;
      FaultMotion         start_motion;
      std::vector<char>   has_ruptured;
      SlipEvent           event;

      /** Members to or from a boost archive. */
      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &name &has_past &time &statistics &nucleation &motion &is_open
          &start_slip &start_motion &has_ruptured &event;
      }
    };

    std::vector<Fault> faults;

    /** Events that have ended. */
    std::vector<SlipEvent> written;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &faults &written;
    }
  };

  /**
   * Finds the slip events in a sequence of accepted steps and writes
   * events.csv, a row for each event as soon as it has ended.
   *
   * An event begins when the mean slip rate of a fault rises above a threshold
   * and ends when it falls below a fraction of that. Both times are
   * interpolated between the steps, linearly in the logarithm of the mean slip
   * rate.
   *
   * Columns are the members of SlipEvent, with one for each number of where it
   * nucleated: nucleation_x, _y, _z and _arc_length, as far as they are there;
   * in three dimensions the magnitude comes last.
   */
  template <int dim>
  class EventCatalogue
  {
  public:
    /**
     * @p start_slip_rate is the threshold in m/s, @p end_fraction the fraction
     * of it at which an event ends. @p shapes: one entry a fault, with a
     * rigidity where moments are wanted. Throws InputError if the file cannot
     * be written.
     */
    EventCatalogue(const std::string                   &file_name,
                   const std::vector<std::string>      &fault_names,
                   const std::vector<FaultLayout<dim>> &shapes,
                   const double                         start_slip_rate,
                   const double                         end_fraction);

    /** The columns of the file. */
    TableColumns
    columns() const;

    /**
     * Take in an accepted step; @p faults in the order of the names given
     * first.
     */
    void
    add(const double time, const std::vector<FaultSnapshot<dim>> &faults);

    /**
     * Write the events that have not ended, with an end of NaN and the slip so
     * far. To be called once after the last step.
     */
    void
    finish();

    /**
     * The events that have been written.
     */
    const std::vector<SlipEvent> &
    events() const
    {
      return memory.written;
    }

    /**
     * Memory of all that has been taken in.
     */
    const EventState &
    state() const
    {
      return memory;
    }

    /**
     * Go on from the state of another catalogue, before anything is taken in;
     * its events are written.
     */
    void
    resume(const EventState &state);

  private:
    void
    add(const unsigned int        fault,
        const double              time,
        const FaultSnapshot<dim> &snapshot);

    void
    write(const SlipEvent &event);

    const NodePositions<dim>               positions;
    const std::vector<std::vector<double>> rigidities;

    TableFile  file;
    double     start_slip_rate;
    double     end_slip_rate;
    EventState memory;
  };
} // namespace StickSlip

#endif
