// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <muParser.h>
#include <stickslip/base/input_error.h>
#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/expression_text.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/unit_operators.h>
#include <stickslip/parameters/units.h>

#include <array>
#include <cmath>
#include <regex>

namespace StickSlip
{
  namespace
  {
    /** True for numbers that round to another whole number than 0. */
    bool
    is_true(const double x)
    {
      return std::abs(x) >= 0.5;
    }



    /** Define the functions that muParser does not have. */
    void
    define_functions(mu::Parser &parser)
    {
      parser.DefineFun("if", [](double condition, double one, double other) {
        return is_true(condition) ? one : other;
      });
      parser.DefineFun("int", [](double x) -> double {
        return static_cast<int>(x + (x >= 0. ? 0.5 : -0.5));
      });
      parser.DefineFun("ceil", [](double x) { return std::ceil(x); });
      parser.DefineFun("floor", [](double x) { return std::floor(x); });
      parser.DefineFun("pow",
                       [](double x, double n) { return std::pow(x, n); });
      parser.DefineFun("sec", [](double x) { return 1. / std::cos(x); });
      parser.DefineFun("csc", [](double x) { return 1. / std::sin(x); });
      parser.DefineFun("cot", [](double x) { return 1. / std::tan(x); });
      parser.DefineFun("erf", [](double x) { return std::erf(x); });
      parser.DefineFun("erfc", [](double x) { return std::erfc(x); });
    }



    /** Numbers with a unit in SI units. */
    struct InUnit
    {
      template <std::size_t unit>
      static double
      apply(double x)
      {
        return x * units_in_expressions()[unit].second;
      }
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



    // muParser takes "x = 5" for a new value of x.
    bool
    has_assignment(const std::string &expression)
    {
      static const std::regex one_sign("(^|[^<>=!])=([^=]|$)");
      return std::regex_search(expression, one_sign);
    }



    /** Description of a mistake from muParser, with its place. */
    std::string
    mistake(const mu::ParserError &error, const std::string &expression)
    {
      static const std::regex place("( found)? at (expression )?position "
                                    "[0-9]+");
      std::string text = std::regex_replace(error.GetMsg(), place, "");
      while (!text.empty() && text.back() == '.')
        text.pop_back();
      const std::size_t position = error.GetPos();
      if (position < expression.size())
        text += " at character " + std::to_string(position + 1);
      else
        text += " at the end";
      return text;
    }
  } // namespace



  /**
   * muParser with the values of its variables.
   */
  template <int dim>
  class Expression<dim>::Parser
  {
  public:
    Parser(const std::string &expression, const bool may_depend_on_time)
    {
      variables.fill(0.);
      const auto error = [&](const std::string &mistake) {
        return InputError(mistake + " (it must be one expression in " +
                          (dim == 2 ? "x,y" : "x,y,z") +
                          (may_depend_on_time ? ",t" : "") + ")");
      };
      if (has_several_values(expression))
        throw error("more than one value");
      if (expression.empty())
        throw error("it is empty");
      if (has_assignment(expression))
        throw error("'=' assigns a value; '==' compares two");
      try
        {
          parser.DefineConst("pi", numbers::PI);
          for (unsigned int d = 0; d < dim; ++d)
            parser.DefineVar(std::string(1, "xyz"[d]), &variables[d]);
          if (may_depend_on_time)
            parser.DefineVar("t", &variables[dim]);
          define_functions(parser);
          define_units<InUnit>(parser);
          parser.SetExpr(without_space_after_names(expression));
          // Most mistakes are found at the first evaluation only.
          parser.Eval();
        }
      catch (const mu::ParserError &e)
        {
          throw error(mistake(e, expression));
        }
    }

    double
    value(const Point<dim> &point, const double time)
    {
      for (unsigned int d = 0; d < dim; ++d)
        variables[d] = point[d];
      variables[dim] = time;
      return parser.Eval();
    }

  private:
    std::array<double, dim + 1> variables;
    mu::Parser                  parser;
  };



  template <int dim>
  Expression<dim>::Expression(const std::string &text,
                              const bool         may_depend_on_time)
    : parser(std::make_shared<Parser>(text, may_depend_on_time))
    , may_depend_on_time(may_depend_on_time)
  {}



  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &point, const double time) const
  {
    return parser->value(point, time);
  }



  template <int dim>
  double
  Expression<dim>::finite_value(const Point<dim> &point,
                                const double      time) const
  {
    const double result = value(point, time);
    if (!std::isfinite(result))
      {
        std::string where;
        for (unsigned int d = 0; d < dim; ++d)
          where += (d == 0 ? "" : ", ") + shortest_form(point[d]);
        throw InputError(
          "its value at (" + where + ")" +
          (may_depend_on_time ? ", t = " + shortest_form(time) : "") +
          " is not a finite number");
      }
    return result;
  }



  template class Expression<2>;
  template class Expression<3>;
} // namespace StickSlip
