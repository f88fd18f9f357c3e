// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/function_lib.h>

#include <stickslip/base/input_error.h>
#include <stickslip/base/make_set.h>
#include <stickslip/parameters/grid_table.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/text_file.h>
#include <stickslip/parameters/units.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    const std::string axis_names = "xyz";



    struct Row
    {
      /** The coordinates in the order of the file; zero beyond them. */
      std::array<double, 3> position = {};
      double                value    = 0;
      unsigned int          line     = 0;
    };



    /** Contents of a file, line by line. */
    struct TableText
    {
      std::string               file_name;
      std::vector<unsigned int> axes;
      std::vector<Row>          rows;

      /** Units of the columns, empty for those of SI. */
      std::vector<std::string> units;

      explicit TableText(const std::string &name)
        : file_name(name)
      {
        if (!std::filesystem::is_regular_file(file_name))
          throw InputError("the table '" + file_name +
                           "' does not exist or is not a file.");
        std::ifstream file(file_name);
        if (!file)
          throw InputError("the table '" + file_name + "' cannot be read.");

        unsigned int number = 0;
        for (std::string line; std::getline(file, line);)
          {
            ++number;
            remove_byte_order_mark(line, number);
            const std::string content   = line.substr(0, line.find('#'));
            const int         character = control_character(content);
            if (character >= 0 && character != '\r')
              fail(number,
                   "there is the control character " +
                     std::to_string(character) + "; a table is plain text");
            std::istringstream       text(content);
            std::vector<std::string> words;
            for (std::string word; text >> word;)
              words.push_back(word);
            if (words.empty())
              continue;
            if (axes.empty())
              read_header(content, number);
            else
              read_row(words, number);
          }
        if (rows.empty())
          fail(
            "there are no values; a line that names the coordinates, such as "
            "'x y', must be followed by lines with these and a value");
      }

      [[noreturn]] void
      fail(const unsigned int line, const std::string &mistake) const
      {
        throw InputError(file_name + ", line " + std::to_string(line) + ": " +
                         mistake + ".");
      }

      [[noreturn]] void
      fail(const std::string &mistake) const
      {
        throw InputError(file_name + ": " + mistake + ".");
      }

      void
      read_header(const std::string &text, const unsigned int line)
      {
        // A name, and perhaps a unit in parentheses behind it.
        static const std::regex column(
          "\\s*([^\\s()]+)\\s*(?:\\(\\s*([^()]*[^()\\s])\\s*\\)\\s*)?");
        bool has_value = false;
        auto rest      = text.begin();
        while (rest != text.end())
          {
            std::smatch match;
            if (!std::regex_search(rest,
                                   text.end(),
                                   match,
                                   column,
                                   std::regex_constants::match_continuous))
              fail(line,
                   "'" + std::string(rest, text.end()) +
                     "' cannot be read; a name may be followed by a unit in "
                     "parentheses, as in 'x (km)'");
            rest                   = match[0].second;
            const std::string name = match[1], unit = match[2];
            const std::size_t axis = axis_names.find(name);
            if (has_value)
              fail(line, "'" + name + "' stands behind 'value', which is last");
            has_value = name == "value" && !axes.empty();
            if (!has_value)
              {
                if (name.size() != 1 || axis == std::string::npos)
                  fail(line,
                       "'" + name +
                         "' is no coordinate; the first line that is no "
                         "comment must name those of the table, one to three "
                         "of x, y and z");
                if (std::find(axes.begin(), axes.end(), axis) != axes.end())
                  fail(line, "the coordinate " + name + " is named twice");
                axes.push_back(axis);
              }
            check_unit(unit, has_value ? "" : "m", line);
            units.push_back(unit);
          }
        units.resize(axes.size() + 1);
      }

      /** Fail if a text is not empty and no unit, or none of the dimensions of
       * @p fitting, if that is not empty. */
      void
      check_unit(const std::string &unit,
                 const std::string &fitting,
                 const unsigned int line) const
      {
        if (unit.empty())
          return;
        if (!read_unit(unit))
          fail(line, "'" + unit + "' is no unit");
        const std::string mistake =
          fitting.empty() ?
            "" :
            NumberRange().in(fitting).mistaken_unit("1 " + unit);
        if (!mistake.empty())
          fail(line, mistake);
      }

      void
      read_row(const std::vector<std::string> &words, const unsigned int line)
      {
        if (words.size() != axes.size() + 1)
          {
            std::string columns;
            for (const unsigned int axis : axes)
              columns += axis_names.substr(axis, 1) + " ";
            fail(line,
                 "there are " + std::to_string(words.size()) +
                   " columns, but must be " + std::to_string(axes.size() + 1) +
                   ": " + columns + "and the value");
          }

        Row row;
        row.line = line;
        for (unsigned int i = 0; i < words.size(); ++i)
          {
            if (!NumberRange().match(words[i]))
              fail(line, "'" + words[i] + "' is not a number");
            const double number =
              NumberRange::values(words[i] + " " + units[i]).front();
            (i < axes.size() ? row.position[i] : row.value) = number;
          }
        rows.push_back(row);
      }

      /** For example "x = 1, y = 2". */
      std::string
      description(const std::array<double, 3> &position) const
      {
        std::string text;
        for (unsigned int i = 0; i < axes.size(); ++i)
          text += (i == 0 ? "" : ", ") + axis_names.substr(axes[i], 1) + " = " +
                  shortest_form(position[i]);
        return text;
      }
    };



    /** The different values of each coordinate, ascending. */
    std::array<std::vector<double>, 3>
    coordinates_of(const TableText &table)
    {
      std::array<std::vector<double>, 3> coordinates;
      for (unsigned int i = 0; i < table.axes.size(); ++i)
        {
          std::vector<double> &values = coordinates[i];
          for (const Row &row : table.rows)
            values.push_back(row.position[i]);
          make_set(values);
          if (values.size() < 2)
            table.fail("there is only one value of " +
                       axis_names.substr(table.axes[i], 1) +
                       "; a table needs at least two of each coordinate");
        }
      return coordinates;
    }



    /** Put the rows into the order of the grid, the last coordinate fastest. */
    void
    sort_to_grid(TableText                                &table,
                 const std::array<std::vector<double>, 3> &coordinates)
    {
      const auto is_before = [](const Row &a, const Row &b) {
        return a.position < b.position;
      };
      std::stable_sort(table.rows.begin(), table.rows.end(), is_before);
      for (unsigned int r = 0; r + 1 < table.rows.size(); ++r)
        if (table.rows[r].position == table.rows[r + 1].position)
          table.fail(table.rows[r + 1].line,
                     "the value at " +
                       table.description(table.rows[r].position) +
                       " is given a second time, first in line " +
                       std::to_string(table.rows[r].line));

      // The grid may be far larger than the number of rows; the first gap ends
      // the search.
      const unsigned int n = table.axes.size();
      std::size_t        r = 0;
      for (std::array<std::size_t, 3> index = {};
           index[0] < coordinates[0].size();
           ++r)
        {
          std::array<double, 3> position = {};
          for (unsigned int i = 0; i < n; ++i)
            position[i] = coordinates[i][index[i]];
          if (r == table.rows.size() || table.rows[r].position != position)
            table.fail("there is no value at " + table.description(position) +
                       "; there must be one at every combination of the "
                       "coordinates");
          ++index[n - 1];
          for (unsigned int i = n - 1; i > 0; --i)
            if (index[i] == coordinates[i].size())
              {
                index[i] = 0;
                ++index[i - 1];
              }
        }
    }



    template <int n>
    std::function<double(const std::array<double, 3> &)>
    make_interpolation(const TableText                          &table,
                       const std::array<std::vector<double>, 3> &coordinates)
    {
      std::array<std::vector<double>, n> grid;
      TableIndices<n>                    sizes;
      for (unsigned int i = 0; i < n; ++i)
        {
          grid[i]  = coordinates[i];
          sizes[i] = coordinates[i].size();
        }
      std::vector<double> values;
      for (const Row &row : table.rows)
        values.push_back(row.value);
      Table<n, double> data;
      data.reinit(sizes);
      data.fill(values.begin());

      const auto function =
        std::make_shared<const Functions::InterpolatedTensorProductGridData<n>>(
          std::move(grid), std::move(data));
      return [function](const std::array<double, 3> &position) {
        Point<n> point;
        for (unsigned int i = 0; i < n; ++i)
          point[i] = position[i];
        return function->value(point);
      };
    }
  } // namespace



  GridTable::GridTable(const std::string &file_name)
  {
    TableText  table(file_name);
    const auto coordinates = coordinates_of(table);
    sort_to_grid(table, coordinates);
    column_axes    = table.axes;
    unit_of_values = table.units.back();
    for (unsigned int i = 0; i < column_axes.size(); ++i)
      ends.emplace_back(coordinates[i].front(), coordinates[i].back());
    interpolation =
      column_axes.size() == 1 ? make_interpolation<1>(table, coordinates) :
      column_axes.size() == 2 ? make_interpolation<2>(table, coordinates) :
                                make_interpolation<3>(table, coordinates);
  }



  template <int dim>
  double
  GridTable::value(const Point<dim> &point) const
  {
    std::array<double, 3> position = {};
    for (unsigned int i = 0; i < column_axes.size(); ++i)
      {
        AssertIndexRange(column_axes[i], dim);
        position[i] = point[column_axes[i]];
      }
    return interpolation(position);
  }



  template <int dim>
  bool
  GridTable::covers(const Point<dim> &point) const
  {
    for (unsigned int i = 0; i < column_axes.size(); ++i)
      if (point[column_axes[i]] < ends[i].first ||
          point[column_axes[i]] > ends[i].second)
        return false;
    return true;
  }



  template bool
  GridTable::covers(const Point<2> &) const;
  template bool
  GridTable::covers(const Point<3> &) const;
  template double
  GridTable::value(const Point<2> &) const;
  template double
  GridTable::value(const Point<3> &) const;
} // namespace StickSlip
