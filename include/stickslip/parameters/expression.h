// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_expression_h
#define stickslip_parameters_expression_h

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A function of the position and, where wanted, of the time, given by a
   * muParser expression in x, y (z), in m, and t, in s. It is read once, when
   * the object is made; copies share it.
   *
   * Besides what muParser has, there are the constant pi and the functions
   * if(condition, then, else), int, ceil, floor, pow, sec, csc, cot, erf and
   * erfc. A unit of units_in_expressions() after a number or a parenthesis
   * multiplies it by its value in SI units, whatever the expression is for:
   * "if(x < 5 km, 30 GPa, 40 GPa)". Spaces may stand between the name of a
   * function and its parenthesis.
   */
  template <int dim>
  class Expression
  {
  public:
    /** Throws InputError saying what is wrong and at which character of the
     * @p text, unless that is one expression in x, y (z), and in t where it may
     * depend on time. */
    Expression(const std::string &text, const bool may_depend_on_time);

    /** The value at a point and time, which may be infinite or no number. */
    double
    value(const Point<dim> &point, const double time = 0.) const;

    /** Value for checks. Throws InputError if it is not finite. */
    double
    finite_value(const Point<dim> &point, const double time = 0.) const;

  private:
    class Parser;

    std::shared_ptr<Parser> parser;
    bool                    may_depend_on_time;
  };
} // namespace StickSlip

#endif
