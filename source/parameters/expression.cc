// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/function_parser.h>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/number_range.h>

#include <cmath>
#include <iostream>
#include <map>
#include <memory>
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



    template <int dim>
    InputError
    error(const std::string &mistake, const bool depends_on_time)
    {
      return InputError(mistake + " (it must be one expression in " +
                        expression_variables<dim>(depends_on_time) + ")");
    }



    template <int dim>
    std::shared_ptr<FunctionParser<dim>>
    make_parser(const std::string &expression, const bool depends_on_time)
    {
      if (has_several_values(expression))
        throw error<dim>("more than one value", depends_on_time);
      if (expression.empty())
        throw error<dim>("it is empty", depends_on_time);
      const CaughtErrorStream error_stream;
      try
        {
          auto parser = std::make_shared<FunctionParser<dim>>(1);
          parser->initialize(expression_variables<dim>(depends_on_time),
                             expression,
                             expression_constants(),
                             depends_on_time);
          return parser;
        }
      catch (const std::exception &)
        {
          throw error<dim>(error_stream.message(), depends_on_time);
        }
    }



    // The first value of a parser: most mistakes are found only now.
    template <int dim>
    double
    first_value(const FunctionParser<dim> &parser,
                const Point<dim>          &point,
                const bool                 depends_on_time)
    {
      const CaughtErrorStream error_stream;
      try
        {
          return parser.value(point);
        }
      catch (const std::exception &)
        {
          throw error<dim>(error_stream.message(), depends_on_time);
        }
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
  std::function<double(const Point<dim> &)>
  read_expression(const std::string &expression)
  {
    const auto parser = make_parser<dim>(expression, false);
    return [parser, is_read = false](const Point<dim> &point) mutable {
      if (is_read)
        return parser->value(point);
      is_read = true;
      return first_value(*parser, point, false);
    };
  }



  template <int dim>
  double
  evaluate_expression(const std::string &expression,
                      const Point<dim>  &point,
                      const bool         depends_on_time,
                      const double       time)
  {
    const auto parser = make_parser<dim>(expression, depends_on_time);
    parser->set_time(time);
    const double value = first_value(*parser, point, depends_on_time);
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
  template std::function<double(const Point<2> &)>
  read_expression<2>(const std::string &);
  template std::function<double(const Point<3> &)>
  read_expression<3>(const std::string &);
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
