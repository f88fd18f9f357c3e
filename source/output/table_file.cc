// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/table_file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>

namespace StickSlip
{
  namespace
  {
    std::string
    restored(const std::string &file_name, const FileState &state)
    {
      restore_file(file_name, state);
      return file_name;
    }
  } // namespace



  TableFile::TableFile(const std::string &file_name)
    : file_name(file_name)
    , file(file_name)
  {
    row.precision(std::numeric_limits<double>::max_digits10);
  }



  TableFile::TableFile(const std::string &file_name, const FileState &earlier)
    : file_name(restored(file_name, earlier))
    , file(file_name, std::ios::app)
    , size(earlier.size)
  {
    row.precision(std::numeric_limits<double>::max_digits10);
  }



  void
  TableFile::end_row()
  {
    row << '\n';
    errno = 0;
    file << row.str() << std::flush;
    std::string reason = errno == 0 ? "" : std::strerror(errno);
    // A file that has been deleted can still be written to.
    std::error_code error;
    const bool      is_there = std::filesystem::exists(file_name, error);
    if (!file || !is_there)
      {
        if (!is_there)
          reason = "it is not there any more";
        std::filesystem::resize_file(file_name, size, error);
        throw InputError("The file '" + file_name + "' cannot be written" +
                         (reason.empty() ? "" : " (" + reason + ")") + ".");
      }
    size += row.str().size();
    row.str("");
  }



  FileState
  TableFile::state() const
  {
    FileState result;
    result.size = size;
    return result;
  }
} // namespace StickSlip
