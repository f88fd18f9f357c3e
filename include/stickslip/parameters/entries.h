// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_entries_h
#define stickslip_parameters_entries_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <stickslip/base/automatic_number.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/spatial_field.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /*
   * Declaration of entries that are tied to a variable: the variable's value
   * is the default, and setting the entry changes the variable. So the variable
   * must stay where it is for as long as the handler is used. Other than
   * ParameterHandler::add_parameter(), numbers keep all their digits and
   * bounds may be excluded.
   */

  /** Declare a number. */
  void
  add_number(ParameterHandler  &prm,
             const std::string &entry,
             double            &value,
             const NumberRange &range,
             const std::string &documentation);

  /** Declare a number that follows from others where the entry is `auto`. */
  void
  add_number(ParameterHandler  &prm,
             const std::string &entry,
             AutomaticNumber   &value,
             const NumberRange &range,
             const std::string &documentation);

  /** Declare a parameter that may vary in space, with values in @p range
   * everywhere. */
  void
  add_field(ParameterHandler  &prm,
            const std::string &entry,
            SpatialField      &field,
            const NumberRange &range,
            const std::string &documentation);

  /** Declare a whole number between @p smallest and @p largest. */
  void
  add_count(ParameterHandler  &prm,
            const std::string &entry,
            unsigned int      &value,
            const unsigned int smallest,
            const unsigned int largest,
            const std::string &documentation);

  /** Declare a switch, true or false. */
  void
  add_switch(ParameterHandler  &prm,
             const std::string &entry,
             bool              &value,
             const std::string &documentation);

  /** Declare a text that may be anything. */
  void
  add_text(ParameterHandler  &prm,
           const std::string &entry,
           std::string       &value,
           const std::string &documentation);



  /** Declare a list of as many numbers as the array has. */
  template <typename Number, std::size_t n>
  void
  add_numbers(ParameterHandler      &prm,
              const std::string     &entry,
              std::array<Number, n> &values,
              NumberRange            range,
              const std::string     &documentation)
  {
    std::string list;
    for (const Number x : values)
      list +=
        (list.empty() ? "" : ", ") + shortest_form(static_cast<double>(x));
    prm.declare_entry(entry, list, range.times(n), documentation);
    prm.add_action(entry, [&values](const std::string &text) {
      const std::vector<double> numbers = NumberRange::values(text);
      for (std::size_t i = 0; i < n; ++i)
        values[i] = static_cast<Number>(numbers[i]);
    });
  }



  /** Declare a list of any number of numbers. */
  void
  add_numbers(ParameterHandler    &prm,
              const std::string   &entry,
              std::vector<double> &values,
              const NumberRange   &range,
              const std::string   &documentation);



  /** Declare a choice among the words that stand for an enumeration. */
  template <typename Enumeration>
  void
  add_choice(ParameterHandler                                       &prm,
             const std::string                                      &entry,
             Enumeration                                            &value,
             const std::vector<std::pair<Enumeration, std::string>> &words,
             const std::string &documentation)
  {
    std::string sequence, current;
    for (const auto &word : words)
      {
        sequence += (sequence.empty() ? "" : "|") + word.second;
        if (word.first == value)
          current = word.second;
      }
    prm.declare_entry(entry,
                      current,
                      Patterns::Selection(sequence),
                      documentation);
    prm.add_action(entry, [&value, words](const std::string &text) {
      for (const auto &word : words)
        if (word.second == text)
          value = word.first;
    });
  }



  /** Declare a list of any of the words that stand for an enumeration,
   * separated by commas; it may be empty. */
  template <typename Enumeration>
  void
  add_selection(ParameterHandler                                       &prm,
                const std::string                                      &entry,
                std::vector<Enumeration>                               &values,
                const std::vector<std::pair<Enumeration, std::string>> &words,
                const std::string &documentation)
  {
    std::string sequence, current;
    for (const auto &word : words)
      {
        sequence += (sequence.empty() ? "" : "|") + word.second;
        if (std::find(values.begin(), values.end(), word.first) != values.end())
          current += (current.empty() ? "" : ", ") + word.second;
      }
    prm.declare_entry(entry,
                      current,
                      Patterns::MultipleSelection(sequence),
                      documentation);
    prm.add_action(entry, [&values, words](const std::string &text) {
      const std::vector<std::string> chosen =
        Utilities::split_string_list(text);
      values.clear();
      for (const auto &word : words)
        if (std::find(chosen.begin(), chosen.end(), word.second) !=
            chosen.end())
          values.push_back(word.first);
    });
  }
} // namespace StickSlip

#endif
