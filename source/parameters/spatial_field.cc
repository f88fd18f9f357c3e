// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/spatial_field.h>
#include <stickslip/parameters/units.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>

namespace StickSlip
{
  namespace
  {
    const std::string keyword = "table";



    /** The file that follows the keyword, if that is the first word. */
    std::optional<std::string>
    file_of_table(const std::string &text)
    {
      if (text.substr(0, text.find_first_of(" \t")) != keyword)
        return {};
      return Utilities::trim(text.substr(keyword.size()));
    }



    /** The result of an action, whose errors know nothing of the entry. */
    template <typename Action>
    auto
    with_name(const std::string &name, const Action &action)
    {
      try
        {
          return action();
        }
      catch (const InputError &error)
        {
          throw InputError(name + "cannot be used: " + error.what() + ".");
        }
    }



    template <int dim>
    std::string
    position(const Point<dim> &point)
    {
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += (d == 0 ? "(" : ", ") + shortest_form(point[d]);
      return text + ") m";
    }
  } // namespace



  SpatialField &
  SpatialField::operator=(const double value)
  {
    number = value;
    given  = true;
    expression.clear();
    table_file.clear();
    table.reset();
    return *this;
  }



  void
  SpatialField::make_optional(const double value_if_empty)
  {
    optional             = true;
    this->value_if_empty = value_if_empty;
    given                = true;
    set("");
  }



  void
  SpatialField::set(const std::string &text)
  {
    const std::string trimmed = Utilities::trim(text);
    // A table is not read twice.
    if (trimmed == this->text())
      return;
    const std::string mistake = range.mistaken_unit(trimmed);
    if (!mistake.empty())
      throw InputError(mistake + ".");
    if (trimmed.empty() && optional)
      {
        *this = value_if_empty;
        given = false;
      }
    else if (const std::optional<Quantity> quantity = read_quantity(trimmed))
      *this = quantity->value;
    else if (const std::optional<std::string> file = file_of_table(trimmed))
      {
        if (file->empty())
          throw InputError("'table' must be followed by the name of a file.");
        const auto        new_table = std::make_shared<const GridTable>(*file);
        const std::string mistake_in_table =
          range.mistaken_unit("1 " + new_table->unit());
        if (!mistake_in_table.empty())
          throw InputError(*file + ": " + mistake_in_table + ".");
        *this      = 0.;
        table      = new_table;
        table_file = *file;
      }
    else
      {
        *this      = 0.;
        expression = trimmed;
      }
  }



  std::string
  SpatialField::text() const
  {
    return !given              ? "" :
           table               ? keyword + " " + table_file :
           !expression.empty() ? expression :
                                 shortest_form(number);
  }



  bool
  SpatialField::depends_on(const unsigned int axis) const
  {
    if (table)
      {
        const auto axes = table->axes();
        return std::find(axes.begin(), axes.end(), axis) != axes.end();
      }
    return std::regex_search(expression,
                             std::regex(std::string("\\b") + "xyz"[axis] +
                                        "\\b"));
  }



  double
  SpatialField::constant() const
  {
    AssertThrow(is_constant(), ExcMessage("The field varies: " + text()));
    return number;
  }



  template <int dim>
  std::function<double(const Point<dim> &)>
  SpatialField::function(const std::string &section) const
  {
    const std::string name =
      "'" + section + "/" + entry + "' = '" + text() + "': ";
    std::function<double(const Point<dim> &)> unchecked;
    if (table)
      {
        for (const unsigned int axis : table->axes())
          if (axis >= dim)
            throw InputError(name + "the table depends on z, but in two "
                                    "dimensions there are only x and y.");
        unchecked = [table = table](const Point<dim> &point) {
          return table->value(point);
        };
      }
    else if (!expression.empty())
      unchecked = with_name(name, [&]() {
        const Expression<dim> parsed(expression, false);
        const std::string     mistake =
          range.mistaken_unit_in_expression(expression);
        if (!mistake.empty())
          throw InputError(mistake);
        return
          [parsed](const Point<dim> &point) { return parsed.value(point); };
      });
    else
      unchecked = [number = number](const Point<dim> &) { return number; };

    return [unchecked, name, range = range](const Point<dim> &point) {
      const double value = unchecked(point);
      if (!range.contains(value))
        throw InputError(name + "is " + shortest_form(value) + " at " +
                         position(point) + ", but must be " +
                         range.description() + " everywhere.");
      return value;
    };
  }



  template <int dim>
  std::vector<double>
  SpatialField::values(const std::vector<Point<dim>> &points,
                       const std::string             &section) const
  {
    const auto          value_at = function<dim>(section);
    std::vector<double> values;
    values.reserve(points.size());
    for (const Point<dim> &point : points)
      values.push_back(value_at(point));
    return values;
  }



  template <int dim>
  bool
  SpatialField::is_table_elsewhere(const std::vector<Point<dim>> &points) const
  {
    return table && std::none_of(points.begin(),
                                 points.end(),
                                 [this](const Point<dim> &point) {
                                   return table->covers(point);
                                 });
  }



  std::string
  SpatialField::with_absolute_path(const std::string &text,
                                   const std::string &folder)
  {
    const std::optional<std::string> file = file_of_table(text);
    if (!file || file->empty())
      return text;
    const std::filesystem::path path = std::filesystem::path(folder) / *file;
    return keyword + " " +
           std::filesystem::absolute(path).lexically_normal().string();
  }



#define STICKSLIP_INSTANTIATE(dim)                               \
  template std::function<double(const Point<dim> &)>             \
  SpatialField::function<dim>(const std::string &) const;        \
  template std::vector<double> SpatialField::values<dim>(        \
    const std::vector<Point<dim>> &, const std::string &) const; \
  template bool SpatialField::is_table_elsewhere<dim>(           \
    const std::vector<Point<dim>> &) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
