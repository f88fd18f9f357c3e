// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/csv_file.h>

#include <limits>

namespace StickSlip
{
  using namespace dealii;

  CsvFile::CsvFile(const std::string &file_name, const std::string &titles)
    : file(file_name)
    , file_name(file_name)
  {
    file.precision(std::numeric_limits<double>::max_digits10);
    file << titles << '\n' << std::flush;
    if (!file)
      throw InputError("The file '" + file_name + "' cannot be written.");
  }



  void
  CsvFile::end_row()
  {
    file << '\n' << std::flush;
    AssertThrow(file,
                ExcMessage("Writing the file '" + file_name + "' failed."));
  }
} // namespace StickSlip
