// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_number_range_h
#define stickslip_parameters_number_range_h

#include <deal.II/base/patterns.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Pattern of finite numbers between bounds that may be excluded, or of a
   * list of a given number of these, separated by commas. For example
   * NumberRange().above(-1).below(0.5). deal.II's patterns know only bounds
   * that are included.
   *
   * Numbers that have a unit are in SI units; they may be written with any
   * unit of the same dimensions (see read_quantity()), and the bounds are for
   * their value in SI units.
   */
  class NumberRange : public Patterns::PatternBase
  {
  public:
    /** Require x > bound. */
    NumberRange &
    above(const double bound)
    {
      lower          = bound;
      lower_included = false;
      return *this;
    }

    /** Require x >= bound. */
    NumberRange &
    at_least(const double bound)
    {
      lower          = bound;
      lower_included = true;
      return *this;
    }

    /** Require x < bound. */
    NumberRange &
    below(const double bound)
    {
      upper          = bound;
      upper_included = false;
      return *this;
    }

    /** Require x <= bound. */
    NumberRange &
    at_most(const double bound)
    {
      upper          = bound;
      upper_included = true;
      return *this;
    }

    /** Require whole numbers, written without point and exponent. */
    NumberRange &
    whole()
    {
      only_whole = true;
      return *this;
    }

    /** Say in which unit, of SI or degrees, the numbers are. */
    NumberRange &
    in(const std::string &new_unit)
    {
      unit = new_unit;
      return *this;
    }

    /** Leave the unit open, where only the sign of an expression counts. */
    NumberRange &
    in_any_unit()
    {
      unit_is_open = true;
      return *this;
    }

    /** Require a list of @p n numbers. */
    NumberRange &
    times(const unsigned int n)
    {
      n_numbers = n;
      return *this;
    }

    /** Allow a list of any length, and nothing. */
    NumberRange &
    any_number_of()
    {
      n_numbers = 0;
      return *this;
    }

    virtual bool
    match(const std::string &text) const override;

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override;

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<NumberRange>(*this);
    }

    /**
     * Mistakes in the units of a string of numbers: they are unknown, or
     * of other dimensions. Empty if nothing is, and for anything but numbers.
     */
    std::string
    mistaken_unit(const std::string &text) const;

    /** Mistake in the units of an expression, see mistake_in_units(); empty if
     * there is none. */
    std::string
    mistaken_unit_in_expression(const std::string &expression) const;

    /** Characters before and after the unit in description(). */
    static constexpr auto before_unit = " (in ", after_unit = ")";

    /**
     * The numbers in a string that match() accepts, in SI units.
     */
    static std::vector<double>
    values(const std::string &text);

    /**
     * True if @p x is finite and between the bounds.
     */
    bool
    contains(const double x) const;

  private:
    /** The end of a message on a wrong unit. */
    std::string
    fitting_units() const;

    double       lower          = -std::numeric_limits<double>::infinity();
    double       upper          = std::numeric_limits<double>::infinity();
    bool         lower_included = false;
    bool         upper_included = false;
    bool         only_whole     = false;
    bool         unit_is_open   = false;
    unsigned int n_numbers      = 1;
    std::string  unit;
  };

  /**
   * The shortest decimal form that reads back as exactly @p x.
   */
  std::string
  shortest_form(const double x);
} // namespace StickSlip

#endif
