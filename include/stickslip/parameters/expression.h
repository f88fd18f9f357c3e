// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_expression_h
#define stickslip_parameters_expression_h

#include <deal.II/base/point.h>

#include <functional>
#include <map>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /** The variables of an expression: x, y (z), and t where it depends on
   * time, in the form that FunctionParser takes. */
  template <int dim>
  std::string
  expression_variables(const bool depends_on_time);

  /** The constants that an expression may use: pi. */
  std::map<std::string, double>
  expression_constants();

  /**
   * The function of position that a muParser expression in x, y (z) stands for.
   * The expression is read once; values may be infinite or no numbers.
   *
   * Throws InputError saying why where the expression cannot be read, here or
   * at the first evaluation.
   */
  template <int dim>
  std::function<double(const Point<dim> &)>
  read_expression(const std::string &expression);

  /**
   * The value of a muParser expression in x, y (z) at one point, and in t where
   * @p depends_on_time, as FunctionParser gives it.
   *
   * Throws InputError saying why where the expression cannot be read or its
   * value is not finite. Meant for checks: each call reads the expression.
   */
  template <int dim>
  double
  evaluate_expression(const std::string &expression,
                      const Point<dim>  &point,
                      const bool         depends_on_time,
                      const double       time = 0.);
} // namespace StickSlip

#endif
