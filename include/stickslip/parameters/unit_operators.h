// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_unit_operators_h
#define stickslip_parameters_unit_operators_h

#include <deal.II/base/exceptions.h>

#include <muParser.h>
#include <stickslip/parameters/units.h>

#include <cstddef>
#include <utility>

namespace StickSlip
{
  /** Define units_in_expressions() as operators that follow a number: unit
   * number n is the function Operator<n>::apply, double of double, since
   * muParser wants functions without data. */
  template <template <std::size_t> class Operator, std::size_t... unit>
  void
  define_units(mu::Parser &parser, std::index_sequence<unit...>)
  {
    AssertIndexRange(units_in_expressions().size(), sizeof...(unit) + 1);
    const auto define = [&parser](const std::size_t i,
                                  double (*function)(double)) {
      if (i < units_in_expressions().size())
        parser.DefinePostfixOprt(units_in_expressions()[i].first, function);
    };
    (define(unit, &Operator<unit>::apply), ...);
  }



  template <template <std::size_t> class Operator>
  void
  define_units(mu::Parser &parser)
  {
    constexpr std::size_t most_units = 64;
    define_units<Operator>(parser, std::make_index_sequence<most_units>());
  }
} // namespace StickSlip

#endif
