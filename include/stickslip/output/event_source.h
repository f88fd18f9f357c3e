// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_event_source_h
#define stickslip_output_event_source_h

#include <stickslip/output/fault_snapshot.h>

#include <limits>
#include <vector>

namespace StickSlip
{
  /**
   * Slip, m, and shear traction, Pa, of all nodes of a fault at one time, the
   * components of a node one after the other.
   */
  struct FaultMotion
  {
    std::vector<double> slip, shear_traction;

    FaultMotion() = default;

    template <int dim>
    explicit FaultMotion(const FaultSnapshot<dim> &fault);

    /** Linear interpolation: @p part 0 is @p before, 1 @p after. */
    FaultMotion(const FaultMotion &before,
                const FaultMotion &after,
                const double       part);

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &slip &shear_traction;
    }
  };

  /**
   * The integral over the area of contact of the rigidity times the slip rate,
   * in magnitude, N m/s, in two dimensions N/s for 1 m of the third one; NaN
   * where no rigidity is known. @p rigidity: of the nodes, Pa, or empty.
   */
  template <int dim>
  double
  moment_rate(const FaultSnapshot<dim>  &fault,
              const std::vector<double> &rigidity);

  /**
   * Size of the source of an event, all of it integrals over the area of
   * contact. With the slip D during the event, the fall T of the shear traction
   * from its start to its end (both tangential vectors), and the rigidity G:
   *
   *   moment      = int G |D| dA,
   *   stress drop = int T.D dA / int |D| dA,
   *
   * the latter being the mean that gives the work done by the fall (Noda,
   * Lapusta and Kanamori 2013).
   */
  struct EventSource
  {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    /** N m, in two dimensions N for 1 m of the third one; NaN where no rigidity
     * is known. */
    double moment = nan;

    /** Pa; NaN if nothing slips. */
    double stress_drop = nan;

    /** Area of the nodes that were faster than the threshold of events after
     * any step of the event, m^(dim-1). */
    double ruptured_area = 0;

    EventSource() = default;

    /**
     * @p weights: areas of the nodes, m^(dim-1); @p rigidity: of the nodes, Pa,
     * or empty; @p has_ruptured: one at nodes of the ruptured area.
     */
    EventSource(const FaultMotion         &start,
                const FaultMotion         &end,
                const std::vector<double> &weights,
                const std::vector<double> &rigidity,
                const std::vector<char>   &has_ruptured);

    /** (log10(moment in N m) - 9.1) / 1.5, the moment magnitude (Hanks and
     * Kanamori 1979). */
    double
    magnitude() const;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &moment &stress_drop &ruptured_area;
    }
  };
} // namespace StickSlip

#endif
