// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_event_catalogue_h
#define stickslip_output_event_catalogue_h

#include <stickslip/output/catalogue.h>
#include <stickslip/output/event_source.h>
#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/node_positions.h>

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

    /** Largest moment_rate() after a step of the event. */
    double peak_moment_rate = nan;

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
        &peak_moment_rate &mean_slip &nucleation &source;
    }
  };

  /**
   * The last step as one fault took part in it, and its event, if that is open.
   */
  struct EventMemory
  {
    using Entry = SlipEvent;

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
    SlipEvent           entry;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &name &has_past &time &statistics &nucleation &motion &is_open
        &start_slip &start_motion &has_ruptured &entry;
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
   * in three dimensions the magnitude comes last. An event that never ended has
   * the end NaN, and the slip so far.
   */
  template <int dim>
  class EventCatalogue : public Catalogue<dim, EventMemory>
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

    TableColumns
    columns() const override;

  private:
    void
    take_in(const unsigned int        fault,
            const double              time,
            const FaultSnapshot<dim> &snapshot) override;

    void
    fill_row(TableFile &row, const SlipEvent &event) const override;

    const NodePositions<dim>               positions;
    const std::vector<std::vector<double>> rigidities;

    double start_slip_rate;
    double end_slip_rate;
  };
} // namespace StickSlip

#endif
