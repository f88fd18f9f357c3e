// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/units.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>

namespace StickSlip
{
  namespace
  {
    const double pi = 3.14159265358979323846;

    const Dimensions length = {{1, 0, 0, 0}}, mass = {{0, 1, 0, 0}},
                     time = {{0, 0, 1, 0}}, pressure = {{-1, 1, -2, 0}},
                     angle = {{0, 0, 0, 1}};

    constexpr double day = 86400., year = 365. * day;



    const std::map<std::string, Unit> &
    named_units()
    {
      static const std::map<std::string, Unit> units = {
        {"m", {length}},
        {"km", {length, 3}},
        {"cm", {length, -2}},
        {"mm", {length, -3}},
        {"um", {length, -6}},
        {"nm", {length, -9}},
        {"kg", {mass}},
        {"g", {mass, -3}},
        {"s", {time}},
        {"ms", {time, -3}},
        {"h", {time, 0, 3600.}},
        {"d", {time, 0, day}},
        {"day", {time, 0, day}},
        {"days", {time, 0, day}},
        {"yr", {time, 0, year}},
        {"year", {time, 0, year}},
        {"years", {time, 0, year}},
        {"kyr", {time, 3, year}},
        {"Myr", {time, 6, year}},
        {"Pa", {pressure}},
        {"kPa", {pressure, 3}},
        {"MPa", {pressure, 6}},
        {"GPa", {pressure, 9}},
        {"bar", {pressure, 5}},
        {"deg", {angle}},
        {"degree", {angle}},
        {"degrees", {angle}},
        {"rad", {angle, 0, 180., pi}}};
      return units;
    }



    // Units to name to users.
    const std::vector<std::string> &
    usual_units()
    {
      static const std::vector<std::string> units = {
        "m",    "km",     "cm",     "mm",     "um",      "s",
        "h",    "d",      "yr",     "Pa",     "kPa",     "MPa",
        "GPa",  "bar",    "m/s",    "mm/s",   "cm/yr",   "mm/yr",
        "km/s", "kg/m^3", "g/cm^3", "Pa s",   "MPa s",   "GPa s",
        "Pa/m", "MPa/km", "m/s^2",  "mm/s^2", "degrees", "rad"};
      return units;
    }



    bool
    is_letter(const char c)
    {
      return std::isalpha(static_cast<unsigned char>(c)) != 0;
    }



    bool
    is_digit(const char c)
    {
      return c >= '0' && c <= '9';
    }



    std::string
    trimmed(const std::string &text)
    {
      const char *const blanks = " \t";
      const std::size_t first  = text.find_first_not_of(blanks);
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(blanks) - first + 1);
    }



    /** A decimal number at the beginning of a text. */
    struct LeadingNumber
    {
      /** The number without its exponent, and that; no number: empty. */
      std::string mantissa;
      long        exponent   = 0;
      bool        is_decimal = false;

      /** Position after the number in the text. */
      std::size_t end = 0;

      explicit LeadingNumber(const std::string &text)
      {
        const auto skip_digits = [&text](std::size_t i) {
          while (i < text.size() && is_digit(text[i]))
            ++i;
          return i;
        };
        std::size_t       i = text.find_first_of("+-") == 0 ? 1 : 0;
        const std::size_t begin_of_digits = i;
        i                                 = skip_digits(i);
        std::size_t n_digits              = i - begin_of_digits;
        if (i < text.size() && text[i] == '.')
          {
            const std::size_t after_point = i + 1;
            i                             = skip_digits(after_point);
            n_digits += i - after_point;
            is_decimal = true;
          }
        if (n_digits == 0)
          return;
        end      = i;
        mantissa = text.substr(0, end);
        if (i < text.size() && (text[i] == 'e' || text[i] == 'E'))
          {
            const std::size_t sign =
              i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-');
            const std::size_t begin      = i + 1 + sign,
                              digits_end = skip_digits(begin);
            if (digits_end > begin)
              {
                constexpr long most = 1000000000;
                exponent =
                  std::clamp(std::strtol(text.c_str() + i + 1, nullptr, 10),
                             -most,
                             most);
                end        = digits_end;
                is_decimal = true;
              }
          }
      }

      /** The value times a power of ten, correctly rounded. */
      double
      value(const int decimals) const
      {
        return std::strtod(
          (mantissa + "e" + std::to_string(exponent + decimals)).c_str(),
          nullptr);
      }
    };
  } // namespace



  double
  Unit::factor() const
  {
    return std::strtod(("1e" + std::to_string(decimals)).c_str(), nullptr) *
           numerator / denominator;
  }



  std::optional<Unit>
  read_unit(const std::string &text)
  {
    constexpr int largest_power = 9;

    Unit        product;
    std::size_t i          = 0;
    bool        is_divided = false;
    while (true)
      {
        const std::size_t begin = i;
        while (i < text.size() && is_letter(text[i]))
          ++i;
        const auto unit = named_units().find(text.substr(begin, i - begin));
        if (unit == named_units().end())
          return {};
        int power = 1;
        if (i < text.size() && text[i] == '^')
          {
            const bool is_negative = ++i < text.size() && text[i] == '-';
            i += is_negative ? 1 : 0;
            if (i == text.size() || !is_digit(text[i]))
              return {};
            power = text[i++] - '0';
            if (i < text.size() && is_digit(text[i]))
              return {};
            if (is_negative)
              power = -power;
          }
        if (std::abs(power) > largest_power)
          return {};
        if (is_divided)
          power = -power;
        for (unsigned int d = 0; d < product.dimensions.size(); ++d)
          product.dimensions[d] += power * unit->second.dimensions[d];
        product.decimals += power * unit->second.decimals;
        for (int n = 0; n < std::abs(power); ++n)
          {
            product.numerator *=
              power > 0 ? unit->second.numerator : unit->second.denominator;
            product.denominator *=
              power > 0 ? unit->second.denominator : unit->second.numerator;
          }
        if (i == text.size())
          return product;

        // Blanks may stand around a sign, and are one for themselves.
        const std::size_t next = text.find_first_not_of(" \t", i);
        if (next == std::string::npos)
          return product;
        is_divided = text[next] == '/';
        if (is_divided || text[next] == '*')
          i = text.find_first_not_of(" \t", next + 1);
        else if (next > i)
          i = next;
        else
          return {};
        if (i == std::string::npos)
          return {};
      }
  }



  std::optional<Quantity>
  read_quantity(const std::string &text)
  {
    const std::string   whole = trimmed(text);
    const LeadingNumber number(whole);
    if (number.mantissa.empty())
      return {};
    Quantity quantity;
    quantity.is_decimal = number.is_decimal;
    quantity.unit       = trimmed(whole.substr(number.end));
    if (quantity.unit.empty())
      {
        quantity.value = std::strtod(whole.c_str(), nullptr);
        return quantity;
      }
    const std::optional<Unit> unit = read_unit(quantity.unit);
    if (!unit)
      return {};
    quantity.dimensions = unit->dimensions;
    quantity.value =
      number.value(unit->decimals) * unit->numerator / unit->denominator;
    return quantity;
  }



  std::string
  unknown_unit(const std::string &text)
  {
    const std::string   whole = trimmed(text);
    const LeadingNumber number(whole);
    if (number.mantissa.empty())
      return "";
    const std::string word = trimmed(whole.substr(number.end));
    if (word.empty() || read_unit(word) ||
        !std::all_of(word.begin(), word.end(), [](const char c) {
          // Bytes of UTF-8, as in the sign of a degree.
          return is_letter(c) || c == '%' || static_cast<signed char>(c) < 0;
        }))
      return "";
    return word;
  }



  std::string
  units_like(const std::string &unit)
  {
    const std::optional<Unit> wanted = read_unit(unit);
    std::vector<std::string>  names  = {unit};
    if (wanted)
      for (const std::string &name : usual_units())
        if (name != unit && read_unit(name)->dimensions == wanted->dimensions)
          names.push_back(name);
    std::string list;
    for (unsigned int i = 0; i < names.size(); ++i)
      list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return list;
  }



  const std::vector<std::pair<std::string, double>> &
  units_in_expressions()
  {
    static const std::vector<std::pair<std::string, double>> units = []() {
      std::vector<std::pair<std::string, double>> result;
      for (const auto &[name, unit] : named_units())
        result.emplace_back(name, unit.factor());
      for (const std::string &name : usual_units())
        if (named_units().count(name) == 0 &&
            name.find_first_of(" ^") == std::string::npos)
          result.emplace_back(name, read_unit(name)->factor());
      return result;
    }();
    return units;
  }
} // namespace StickSlip
