// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <fcntl.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/table_file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
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



    int
    open_file(const std::string &file_name, const int how)
    {
      constexpr mode_t for_all = 0666;
      return ::open(file_name.c_str(), O_WRONLY | O_CLOEXEC | how, for_all);
    }
  } // namespace



  TableFile::TableFile(const std::string &file_name)
    : file_name(file_name)
    , file(open_file(file_name, O_CREAT | O_TRUNC))
  {}



  TableFile::TableFile(const std::string &file_name, const FileState &earlier)
    : file_name(restored(file_name, earlier))
    , file(open_file(file_name, O_APPEND))
    , size(earlier.size)
  {}



  TableFile::~TableFile()
  {
    if (file >= 0)
      ::close(file);
  }



  void
  TableFile::add_number(const double value)
  {
    std::array<char, 32> text;
    const auto           result =
      std::to_chars(text.data(),
                    text.data() + text.size(),
                    value,
                    std::chars_format::general,
                    std::numeric_limits<double>::max_digits10);
    row.append(text.data(), result.ptr);
  }



  int
  TableFile::write_row()
  {
    if (file < 0)
      return EBADF;
    for (std::size_t n_written = 0; n_written < row.size();)
      {
        const ssize_t n =
          ::write(file, row.data() + n_written, row.size() - n_written);
        if (n >= 0)
          n_written += n;
        else if (errno != EINTR)
          return errno;
      }
    return 0;
  }



  bool
  TableFile::is_there()
  {
    // Names take time to look up; a file that has been deleted tells by itself.
    constexpr std::chrono::milliseconds interval(100);
    struct stat                         status;
    if (file >= 0 && ::fstat(file, &status) == 0 && status.st_nlink == 0)
      return false;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_look < interval)
      return true;
    last_look = now;
    std::error_code error;
    return std::filesystem::exists(file_name, error);
  }



  void
  TableFile::end_row()
  {
    row += '\n';
    const int error = write_row();
    if (const bool was_deleted = !is_there(); error != 0 || was_deleted)
      {
        std::string reason;
        if (was_deleted)
          reason = "it is not there any more";
        else if (file >= 0)
          reason = std::strerror(error);
        // A file that has been deleted can still be written to.
        std::error_code ignored;
        std::filesystem::resize_file(file_name, size, ignored);
        throw InputError("The file '" + file_name + "' cannot be written" +
                         (reason.empty() ? "" : " (" + reason + ")") + ".");
      }
    size += row.size();
    row.clear();
  }



  FileState
  TableFile::state() const
  {
    FileState result;
    result.size = size;
    return result;
  }
} // namespace StickSlip
