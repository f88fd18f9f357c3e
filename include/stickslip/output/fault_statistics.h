// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_statistics_h
#define stickslip_output_fault_statistics_h

#include <stickslip/output/fault_snapshot.h>

#include <limits>

namespace StickSlip
{
  /**
   * Values of one fault at one time in the tables. Only nodes opposite the
   * other side count, open or not; means are weighted by the nodes' weights, so
   * that they are means over the area. All values are NaN where there is no
   * such node.
   */
  struct FaultStatistics
  {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    /** Magnitude of the slip rate, m/s; open nodes have none. */
    double max_slip_rate  = nan;
    double mean_slip_rate = nan;
    double min_slip_rate  = nan;

    /** First tangential component of the slip, m. */
    double mean_slip = nan;

    /** State theta, s. */
    double mean_state = nan;

    /** First tangential component of the shear traction, Pa. */
    double mean_shear_traction = nan;

    /** The (first) node of largest slip rate. */
    unsigned int fastest_node = numbers::invalid_unsigned_int;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &max_slip_rate &mean_slip_rate &min_slip_rate &mean_slip
        &mean_state &mean_shear_traction &fastest_node;
    }
  };

  /**
   * Opening of one fault at one time. Only nodes opposite the other side
   * count, those of weight zero do not.
   */
  struct OpeningStatistics
  {
    /** Largest gap of a node, m. */
    double largest_gap = 0;

    /** Sum of the weights of open nodes, m^(dim-1). */
    double open_area = 0;

    /** The (first) node of the largest gap. */
    unsigned int widest_node = numbers::invalid_unsigned_int;
  };

  /**
   * The statistics of a fault.
   */
  template <int dim>
  FaultStatistics
  fault_statistics(const FaultSnapshot<dim> &fault);

  /**
   * The opening of a fault that may open.
   */
  template <int dim>
  OpeningStatistics
  opening_statistics(const FaultSnapshot<dim> &fault);
} // namespace StickSlip

#endif
