// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/atomic_file.h>
#include <stickslip/output/volume_files.h>
#include <stickslip/output/vtu_file.h>

#include <algorithm>
#include <filesystem>

namespace StickSlip
{
  namespace
  {
    VtuGrid
    grid_of(const VolumeContent &content)
    {
      VtuGrid grid;
      for (auto x = content.positions.begin(); x != content.positions.end();
           x += 3)
        grid.add_point(Point<3>(x[0], x[1], x[2]));
      for (auto first = content.corners.begin(); first != content.corners.end();
           first += content.n_corners)
        grid.add_cell(content.dimension,
                      {first, std::find(first, first + content.n_corners, -1)});
      return grid;
    }



    VtuFile
    file_of(const VtuGrid                  &grid,
            const VolumeContent            &content,
            const double                    time,
            const std::vector<std::string> &body_names)
    {
      VtuFile file(grid, time, VtuFile::Precision::simple);
      file.add_names("body_names", body_names);
      for (const auto &[name, n_components, values, units] : content.of_points)
        file.add_point_data(name, n_components, values, units);
      for (const auto &[name, n_components, values, units] : content.of_cells)
        file.add_cell_data(name, n_components, values, units);
      return file;
    }
  } // namespace



  VolumeFiles::VolumeFiles(const std::string              &directory,
                           const unsigned int              number,
                           const double                    time,
                           const std::vector<std::string> &body_names)
    : directory(directory + "/")
    , name("solution_" + Utilities::int_to_string(number, 5))
    , time(time)
    , body_names(body_names)
  {}



  std::string
  VolumeFiles::write(const VolumeContent &content) const
  {
    const VtuGrid grid = grid_of(content);
    write_file_atomically(directory + name + ".vtu",
                          file_of(grid, content, time, body_names).text());
    return name + ".vtu";
  }



  void
  VolumeFiles::make_folder() const
  {
    std::error_code error;
    std::filesystem::create_directories(directory + name, error);
    if (error)
      throw InputError("The folder '" + directory + name +
                       "' cannot be created (" + error.message() + ").");
  }



  std::string
  VolumeFiles::piece(const unsigned int process) const
  {
    return name + "/" + Utilities::int_to_string(process, 5) + ".vtu";
  }



  void
  VolumeFiles::write_piece(const unsigned int   process,
                           const VolumeContent &own) const
  {
    const VtuGrid grid = grid_of(own);
    write_file_atomically(directory + piece(process),
                          file_of(grid, own, time, body_names).text());
  }



  std::string
  VolumeFiles::join_pieces(const unsigned int   n_processes,
                           const VolumeContent &own) const
  {
    std::vector<std::string> pieces;
    for (unsigned int p = 0; p < n_processes; ++p)
      pieces.push_back(piece(p));
    VolumeContent no_values;
    no_values.of_points = own.of_points;
    no_values.of_cells  = own.of_cells;
    for (auto *fields : {&no_values.of_points, &no_values.of_cells})
      for (VolumeContent::Field &field : *fields)
        field.values.clear();
    const VtuGrid no_cells;
    write_file_atomically(
      directory + name + ".pvtu",
      file_of(no_cells, no_values, time, body_names).text_that_joins(pieces));
    return name + ".pvtu";
  }
} // namespace StickSlip
