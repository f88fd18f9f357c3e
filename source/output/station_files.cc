// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/station_files.h>
#include <stickslip/parameters/number_range.h>

#include <cstdio>
#include <filesystem>

namespace StickSlip
{
  namespace
  {
    std::string
    file_name(const OutputDirectory &directory, const StationTable &table)
    {
      return directory.file("stations/" + table.station.name + ".dat");
    }



    std::string
    with_digits(const double value, const int digits)
    {
      char text[40];
      std::snprintf(text, sizeof(text), "%.*E", digits - 1, value);
      return text;
    }



    /** A length without what rounding leaves of it. */
    std::string
    with_six_digits(const double value)
    {
      char text[40];
      std::snprintf(text, sizeof(text), "%.6g", value);
      return text;
    }



    void
    write_header(TableFile          &file,
                 const StationTable &table,
                 const std::string  &problem)
    {
      file << "# problem=" << problem << "\n# code=stickslip\n"
           << "# element_size=" << with_six_digits(table.element_size) << " m\n"
           << "# location= " << (table.is_on_fault ? "on fault " : "in body ")
           << table.station.place << ",";
      for (const double x : table.station.position)
        file << ' ' << shortest_form(x);
      file << " m\n# Column #1 = Time (s)\n";
      for (unsigned int i = 0; i < table.columns.size(); ++i)
        file << "# Column #" << i + 2 << " = " << table.columns[i].meaning
             << " (" << table.columns[i].unit << ")\n";
      file << "t";
      for (const TableColumn &column : table.columns)
        file << ' ' << column.title;
      file.end_row();
    }
  } // namespace



  StationFiles::StationFiles(const OutputDirectory           &directory,
                             const std::vector<StationTable> &tables,
                             const std::string               &problem)
  {
    if (tables.empty())
      return;
    const std::string folder = directory.file("stations");
    std::error_code   error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
      throw InputError("The folder '" + folder + "' cannot be created.");
    for (const StationTable &table : tables)
      {
        files.push_back(
          std::make_unique<TableFile>(file_name(directory, table)));
        write_header(*files.back(), table, problem);
      }
  }



  StationFiles::StationFiles(const OutputDirectory           &directory,
                             const std::vector<StationTable> &tables,
                             const std::vector<FileState>    &earlier)
  {
    AssertDimension(earlier.size(), tables.size());
    for (unsigned int i = 0; i < tables.size(); ++i)
      files.push_back(
        std::make_unique<TableFile>(file_name(directory, tables[i]),
                                    earlier[i]));
  }



  void
  StationFiles::add(const double                            time,
                    const std::vector<std::vector<double>> &values)
  {
    AssertDimension(values.size(), files.size());
    for (unsigned int i = 0; i < files.size(); ++i)
      {
        *files[i] << with_digits(time, 14);
        for (const double value : values[i])
          *files[i] << ' ' << with_digits(value, 7);
        files[i]->end_row();
      }
  }



  std::vector<FileState>
  StationFiles::state() const
  {
    std::vector<FileState> result;
    for (const auto &file : files)
      result.push_back(file->state());
    return result;
  }
} // namespace StickSlip
