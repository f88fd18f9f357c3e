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
#include <string_view>

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
    if (file < 0)
      return;
    write_rows();
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
    rows.append(text.data(), result.ptr);
  }



  int
  TableFile::write_rows()
  {
    if (file < 0)
      return EBADF;
    const std::string_view text      = rows;
    const std::size_t      complete  = text.rfind('\n') + 1;
    std::size_t            n_written = 0;
    int                    error     = 0;
    while (n_written < complete && error == 0)
      {
        const ssize_t n =
          ::write(file, text.data() + n_written, complete - n_written);
        if (n >= 0)
          n_written += n;
        else if (errno != EINTR)
          error = errno;
      }
    size += text.substr(0, n_written).rfind('\n') + 1;
    rows.erase(0, complete);
    if (error != 0)
      {
        // Not by its name, which may be that of another file by now.
        [[maybe_unused]] const int status = ::ftruncate(file, size);
      }
    return error;
  }



  bool
  TableFile::has_name() const
  {
    // A file that has been deleted can still be written to.
    struct stat status;
    if (file >= 0 && ::fstat(file, &status) == 0 && status.st_nlink == 0)
      return false;
    std::error_code error;
    return std::filesystem::exists(file_name, error);
  }



  void
  TableFile::write_waiting_rows()
  {
    const int error     = write_rows();
    last_writing        = std::chrono::steady_clock::now();
    const bool is_there = has_name();
    if (error == 0 && is_there)
      return;
    std::string reason;
    if (!is_there)
      reason = "it is not there any more";
    else if (file >= 0)
      reason = std::strerror(error);
    throw InputError("The file '" + file_name + "' cannot be written" +
                     (reason.empty() ? "" : " (" + reason + ")") + ".");
  }



  void
  TableFile::end_row()
  {
    rows += '\n';
    write_waiting_rows();
  }



  void
  TableFile::end_waiting_row()
  {
    constexpr std::chrono::milliseconds interval(100);
    rows += '\n';
    if (std::chrono::steady_clock::now() - last_writing >= interval)
      write_waiting_rows();
  }



  FileState
  TableFile::state()
  {
    write_waiting_rows();
    FileState result;
    result.size = size;
    return result;
  }
} // namespace StickSlip
