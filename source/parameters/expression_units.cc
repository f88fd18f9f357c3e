// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <muParser.h>
#include <stickslip/parameters/expression_text.h>
#include <stickslip/parameters/expression_units.h>
#include <stickslip/parameters/unit_operators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <utility>

namespace StickSlip
{
  namespace
  {
    // muParser computes with dimensions in place of values: a number stands for
    // one of these kinds, or, from first_code on, for exponents.
    constexpr double plain = 0., coordinate = 1., time = 2., first_code = 3.;

    // Exponents beyond the largest one are as good as unknown.
    constexpr int largest_exponent = 30, n_exponents = 2 * largest_exponent + 1;



    // Operators and functions of muParser have no data of their own.
    struct Evaluation
    {
      std::string mistake;

      /** False to follow 'else' in 'condition ? then : else'. */
      bool conditions_hold = true;
    };

    thread_local Evaluation evaluation;



    bool
    has_unit(const double code)
    {
      return code >= first_code;
    }



    double
    encode(const Dimensions &dimensions)
    {
      double code = 0.;
      for (const int exponent : dimensions)
        {
          if (std::abs(exponent) > largest_exponent)
            return plain;
          code = n_exponents * code + exponent + largest_exponent;
        }
      return first_code + code;
    }



    /** Dimensions of a quantity, coordinate or time. */
    Dimensions
    decode(const double code)
    {
      if (!has_unit(code))
        return code == time ? Dimensions{{0, 0, 1, 0}} :
                              Dimensions{{1, 0, 0, 0}};
      Dimensions dimensions;
      auto       rest = static_cast<long>(code - first_code);
      for (unsigned int d = dimensions.size(); d-- > 0;)
        {
          dimensions[d] =
            static_cast<int>(rest % n_exponents) - largest_exponent;
          rest /= n_exponents;
        }
      return dimensions;
    }



    /** Unit of SI for messages. */
    std::string
    unit_of(const Dimensions &dimensions)
    {
      if (dimensions == Dimensions())
        return "no unit";
      for (const char *const name : {"m",
                                     "s",
                                     "kg",
                                     "Pa",
                                     "m/s",
                                     "m/s^2",
                                     "kg/m^3",
                                     "Pa s",
                                     "Pa/m",
                                     "degrees"})
        if (read_unit(name)->dimensions == dimensions)
          return name;
      const std::array<const char *, 4> names = {{"m", "kg", "s", "degrees"}};
      std::string                       product;
      for (unsigned int d = 0; d < dimensions.size(); ++d)
        if (dimensions[d] != 0)
          product +=
            (product.empty() ? "" : " ") + std::string(names[d]) +
            (dimensions[d] == 1 ? "" : "^" + std::to_string(dimensions[d]));
      return product;
    }



    double
    note(const std::string &mistake)
    {
      if (evaluation.mistake.empty())
        evaluation.mistake = mistake;
      return plain;
    }



    /** The kind of numbers that are added or compared. */
    double
    common(const double a, const double b)
    {
      if (a == b)
        return a;
      if (!has_unit(a) && !has_unit(b))
        return plain;
      if (a == plain || b == plain)
        return std::max(a, b);
      if (decode(a) != decode(b))
        return note("numbers in " + unit_of(decode(a)) + " and in " +
                    unit_of(decode(b)) + " cannot be added or compared");
      return std::max(a, b);
    }



    double
    common_of_all(const double *const codes, const int n)
    {
      double code = codes[0];
      for (int i = 1; i < n; ++i)
        code = common(code, codes[i]);
      return code;
    }



    /** Product with a power of the second factor, 1 or -1. */
    template <int power>
    double
    product(const double a, const double b)
    {
      const double one = encode({});
      if (b == one || (a == one && power == 1))
        return b == one ? a : b;
      if (!has_unit(a) || !has_unit(b))
        return plain;
      Dimensions       dimensions = decode(a);
      const Dimensions factor     = decode(b);
      for (unsigned int d = 0; d < dimensions.size(); ++d)
        dimensions[d] += power * factor[d];
      return encode(dimensions);
    }



    /** A number that must have no unit, for a function or an exponent. */
    double
    without_unit(const double code)
    {
      if (has_unit(code) && code != encode({}))
        return note("a function or exponent that takes a number without a unit "
                    "has one in " +
                    unit_of(decode(code)));
      return plain;
    }



    double
    power(const double base, const double exponent)
    {
      without_unit(exponent);
      return base == encode({}) ? base : plain;
    }



    double
    square_root(const double code)
    {
      if (!has_unit(code))
        return plain;
      Dimensions dimensions = decode(code);
      for (int &exponent : dimensions)
        {
          if (exponent % 2 != 0)
            return plain;
          exponent /= 2;
        }
      return encode(dimensions);
    }



    double
    truth()
    {
      return evaluation.conditions_hold ? encode({}) : plain;
    }



    double
    comparison(const double a, const double b)
    {
      common(a, b);
      return truth();
    }



    double
    unchanged(const double code)
    {
      return code;
    }



    /** Numbers with a unit: its dimensions. */
    struct InUnit
    {
      template <std::size_t unit>
      static double
      apply(double code)
      {
        const double of_unit =
          encode(read_unit(units_in_expressions()[unit].first)->dimensions);
        return has_unit(code) ? product<1>(code, of_unit) : of_unit;
      }
    };



    /** A literal number at the beginning of a text. */
    int
    skip_number(const char *text, int *position, double *code)
    {
      std::istringstream stream(text);
      double             number;
      if (!(stream >> number))
        return 0;
      const auto end = stream.tellg();
      *position += end < 0 ? static_cast<int>(std::string(text).size()) :
                             static_cast<int>(end);
      *code = plain;
      return 1;
    }



    void
    define_operators(mu::Parser &parser)
    {
      parser.EnableBuiltInOprt(false);
      parser.ClearInfixOprt();
      for (const char *const sign : {"+", "-"})
        {
          parser.DefineInfixOprt(sign, unchanged);
          parser.DefineOprt(sign, common, mu::prADD_SUB);
        }
      parser.DefineOprt("*", product<1>, mu::prMUL_DIV);
      parser.DefineOprt("/", product<-1>, mu::prMUL_DIV);
      parser.DefineOprt("^", power, mu::prPOW, mu::oaRIGHT);
      for (const char *const sign : {"<", ">", "<=", ">=", "==", "!="})
        parser.DefineOprt(sign, comparison, mu::prCMP);
      const auto joint = [](double, double) { return truth(); };
      parser.DefineOprt("&&", joint, mu::prLAND);
      parser.DefineOprt("||", joint, mu::prLOR);
    }



    void
    define_functions(mu::Parser &parser)
    {
      parser.ClearFun();
      parser.DefineFun("if", [](double, double one, double other) {
        return common(one, other);
      });
      for (const char *const name : {"abs", "int", "ceil", "floor", "rint"})
        parser.DefineFun(name, unchanged);
      for (const char *const name : {"min", "max", "sum", "avg"})
        parser.DefineFun(name, common_of_all);
      parser.DefineFun("sign", [](double) { return plain; });
      parser.DefineFun("sqrt", square_root);
      parser.DefineFun("pow", power);
      parser.DefineFun("atan2", [](double y, double x) {
        common(y, x);
        return plain;
      });
      for (const char *const name :
           {"sin",  "cos",   "tan",   "asin",  "acos", "atan",  "sinh", "cosh",
            "tanh", "asinh", "acosh", "atanh", "log2", "log10", "log",  "ln",
            "exp",  "sec",   "csc",   "cot",   "erf",  "erfc"})
        parser.DefineFun(name, without_unit);
    }



    /** The kind of the result; plain where muParser cannot read the text in
     * this way, whose mistakes are those of its values. */
    double
    kind_of(const std::string &expression, const bool conditions_hold)
    {
      evaluation.conditions_hold = conditions_hold;
      double x = coordinate, y = coordinate, z = coordinate, t = time;
      try
        {
          mu::Parser parser;
          define_operators(parser);
          define_functions(parser);
          define_units<InUnit>(parser);
          parser.ClearConst();
          for (const char *const name : {"pi", "_pi", "_e"})
            parser.DefineConst(name, plain);
          parser.AddValIdent(skip_number);
          parser.DefineVar("x", &x);
          parser.DefineVar("y", &y);
          parser.DefineVar("z", &z);
          parser.DefineVar("t", &t);
          parser.SetExpr(without_space_after_names(expression));
          return parser.Eval();
        }
      catch (const mu::ParserError &)
        {
          return plain;
        }
    }



    /** The name of a unit, if there is one, that stands before '^': what
     * muParser would raise to a power is the number before it. */
    std::string
    raised_unit(const std::string &expression)
    {
      static const std::regex name_and_power("([A-Za-z][A-Za-z/]*)[ \t]*\\^");
      const std::sregex_iterator end;
      for (std::sregex_iterator match(expression.begin(),
                                      expression.end(),
                                      name_and_power);
           match != end;
           ++match)
        if (read_unit((*match)[1]))
          return (*match)[1];
      return "";
    }
  } // namespace



  std::string
  mistake_in_units(const std::string               &expression,
                   const std::optional<Dimensions> &wanted,
                   const std::string               &fitting)
  {
    const std::string unit = raised_unit(expression);
    if (!unit.empty())
      return "a power of the unit '" + unit +
             "' is not known in expressions; a quantity is raised to a power in "
             "parentheses";
    evaluation.mistake.clear();
    for (const bool conditions_hold : {true, false})
      {
        const double kind = kind_of(expression, conditions_hold);
        if (!evaluation.mistake.empty())
          return evaluation.mistake;
        if (wanted && has_unit(kind) && decode(kind) != *wanted)
          return "its values are in " + unit_of(decode(kind)) + fitting;
      }
    return "";
  }
} // namespace StickSlip
