// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_point_list_h
#define stickslip_parameters_point_list_h

#include <deal.II/base/patterns.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Pattern of a possibly empty list of points of a plane, separated by
   * commas, each of which is two finite numbers, in m or with a unit of length:
   * "0 0, 1 0, 1 2.5", "0 0, 40 km -2 km".
   */
  class PointList : public Patterns::PatternBase
  {
  public:
    /** A list of any number of points; if @p n_points is greater than zero of
     * that many, or of none. */
    explicit PointList(const unsigned int n_points = 0)
      : n_points(n_points)
    {}

    virtual bool
    match(const std::string &text) const override;

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override;

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<PointList>(*this);
    }

    /** The points in a string that match() accepts, in m. */
    static std::vector<Point<2>>
    values(const std::string &text);

  private:
    unsigned int n_points;
  };

  /**
   * The numbers in a text without commas, each with the unit that follows it:
   * "0 40 km" has "0" and "40 km".
   */
  std::vector<std::string>
  split_quantities(const std::string &text);
} // namespace StickSlip

#endif
