// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/function_parser.h>

#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/input_error.h>
#include <stickslip/parameters/number_range.h>

#include <cmath>
#include <iostream>
#include <map>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    // FunctionParser prints to the error stream before it throws; what it
    // prints there is the only readable account of the mistake.
    class CaughtErrorStream
    {
    public:
      CaughtErrorStream()
        : previous(std::cerr.rdbuf(text.rdbuf()))
      {}

      ~CaughtErrorStream()
      {
        std::cerr.rdbuf(previous);
      }

      std::string
      message() const
      {
        const std::string all   = text.str();
        const std::size_t begin = all.find('<');
        const std::size_t end   = all.find(">\n");
        if (begin == std::string::npos || end == std::string::npos)
          return "it is not a valid expression";
        std::string message = all.substr(begin + 1, end - begin - 1);
        while (!message.empty() && message.back() == '.')
          message.pop_back();
        return message;
      }

    private:
      std::ostringstream text;
      std::streambuf    *previous;
    };



    // muParser takes "0,5" for two values and returns the last one.
    bool
    has_several_values(const std::string &expression)
    {
      int depth = 0;
      for (const char c : expression)
        {
          depth += (c == '(') - (c == ')');
          if ((c == ',' && depth == 0) || c == ';')
            return true;
        }
      return false;
    }
  } // namespace



  template <int dim>
  std::string
  expression_variables(const bool depends_on_time)
  {
    return std::string(dim == 2 ? "x,y" : "x,y,z") +
           (depends_on_time ? ",t" : "");
  }



  std::map<std::string, double>
  expression_constants()
  {
    return {{"pi", numbers::PI}};
  }



  template <int dim>
  double
  evaluate_expression(const std::string &expression,
                      const Point<dim>  &point,
                      const bool         depends_on_time,
                      const double       time)
  {
    const std::string variables = expression_variables<dim>(depends_on_time);
    const std::string rule =
      " (it must be one expression in " + variables + ")";
    if (has_several_values(expression))
      throw InputError("more than one value" + rule);
    if (expression.empty())
      throw InputError("it is empty" + rule);

    double value = 0;
    {
      CaughtErrorStream error_stream;
      try
        {
          FunctionParser<dim> parser(1);
          parser.initialize(variables,
                            expression,
                            expression_constants(),
                            depends_on_time);
          parser.set_time(time);
          value = parser.value(point);
        }
      catch (const std::exception &)
        {
          throw InputError(error_stream.message() + rule);
        }
    }

    if (!std::isfinite(value))
      {
        std::string where;
        for (unsigned int d = 0; d < dim; ++d)
          where += (d == 0 ? "" : ", ") + shortest_form(point[d]);
        throw InputError(
          "its value at (" + where + ")" +
          (depends_on_time ? ", t = " + shortest_form(time) : "") +
          " is not a finite number");
      }
    return value;
  }



  template std::string
  expression_variables<2>(const bool);
  template std::string
  expression_variables<3>(const bool);
  template double
  evaluate_expression<2>(const std::string &,
                         const Point<2> &,
                         const bool,
                         const double);
  template double
  evaluate_expression<3>(const std::string &,
                         const Point<3> &,
                         const bool,
                         const double);
} // namespace StickSlip
