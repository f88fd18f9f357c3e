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
   * number n is the function Operators::apply<n>, double of double, since
   * muParser wants functions without data. (GCC takes templates that are
   * arguments for the same if they have the same name in the unnamed
   * namespaces of two files; classes it does not.) */
  template <typename Operators, std::size_t... unit>
  void
  define_units(mu::Parser &parser, std::index_sequence<unit...>)
  {
    AssertIndexRange(units_in_expressions().size(), sizeof...(unit) + 1);
    const auto define = [&parser](const std::size_t i,
                                  double (*function)(double)) {
      if (i < units_in_expressions().size())
        parser.DefinePostfixOprt(units_in_expressions()[i].first, function);
    };
    (define(unit, &Operators::template apply<unit>), ...);
  }



  template <typename Operators>
  void
  define_units(mu::Parser &parser)
  {
    constexpr std::size_t most_units = 64;
    define_units<Operators>(parser, std::make_index_sequence<most_units>());
  }
} // namespace StickSlip

#endif
