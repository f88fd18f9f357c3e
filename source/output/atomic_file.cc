// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/atomic_file.h>

#include <filesystem>
#include <fstream>

namespace StickSlip
{
  void
  write_file_atomically(const std::string &file_name,
                        const std::string &content)
  {
    const std::string temporary = file_name + ".tmp";
    std::ofstream     file(temporary);
    file << content;
    file.close();
    std::error_code error;
    if (file)
      std::filesystem::rename(temporary, file_name, error);
    if (!file || error)
      throw InputError("The file '" + file_name + "' cannot be written.");
  }
} // namespace StickSlip
