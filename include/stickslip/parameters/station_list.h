// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_station_list_h
#define stickslip_parameters_station_list_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A point of a fault or body whose fields are recorded.
   */
  struct Station
  {
    std::string name;

    /** The name of the fault or body. */
    std::string place;

    /** Reference position, m. */
    std::vector<double> position;
  };

  /**
   * Pattern of a possibly empty list of stations, separated by commas: a name,
   * a colon, the fault or body, and two or three coordinates, in m or with a
   * unit of length: "dp075: main 7.5 km 0, far: plus 0 16e3".
   */
  class StationList : public Patterns::PatternBase
  {
  public:
    virtual bool
    match(const std::string &text) const override;

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override;

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<StationList>(*this);
    }

    /** The stations in a string that match() accepts. */
    static std::vector<Station>
    values(const std::string &text);

    /** A string that values() takes apart. */
    static std::string
    text(const std::vector<Station> &stations);
  };
} // namespace StickSlip

#endif
