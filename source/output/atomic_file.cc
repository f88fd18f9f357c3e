// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/atomic_file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace StickSlip
{
  void
  write_file_atomically(const std::string &file_name,
                        const std::string &content)
  {
    const std::string temporary = file_name + ".tmp";
    errno                       = 0;
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    file.close();
    std::string     reason = file || errno == 0 ? "" : std::strerror(errno);
    std::error_code error;
    if (file)
      {
        std::filesystem::rename(temporary, file_name, error);
        if (!error)
          return;
        reason = error.message();
      }
    std::filesystem::remove(temporary, error);
    throw InputError("The file '" + file_name + "' cannot be written" +
                     (reason.empty() ? "" : " (" + reason + ")") + ".");
  }
} // namespace StickSlip
