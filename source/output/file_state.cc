// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/file_state.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace StickSlip
{
  namespace
  {
    std::uint64_t
    size_of(const std::string &file_name)
    {
      std::error_code     error;
      const std::uint64_t size = std::filesystem::file_size(file_name, error);
      if (error)
        throw InputError("The file '" + file_name + "' cannot be read (" +
                         error.message() + ").");
      return size;
    }
  } // namespace



  FileState
  file_state(const std::string &file_name, ByteRanges final_ranges)
  {
    FileState state;
    state.size = size_of(file_name);
    std::sort(final_ranges.begin(), final_ranges.end());
    final_ranges.emplace_back(state.size, 0);

    std::ifstream file(file_name, std::ios::binary);
    std::uint64_t begin = 0;
    for (const auto &[next, n] : final_ranges)
      {
        if (next > begin)
          {
            std::string bytes(next - begin, '\0');
            file.seekg(begin);
            file.read(bytes.data(), bytes.size());
            state.parts.emplace_back(begin, std::move(bytes));
          }
        begin = std::max(begin, next + n);
      }
    if (!file)
      throw InputError("The file '" + file_name + "' cannot be read.");
    return state;
  }



  void
  restore_file(const std::string &file_name, const FileState &state)
  {
    if (size_of(file_name) < state.size)
      throw InputError("The file '" + file_name +
                       "' is shorter than it was at the checkpoint: the run "
                       "cannot go on in it.");
    std::fstream file(file_name,
                      std::ios::binary | std::ios::in | std::ios::out);
    for (const auto &[begin, bytes] : state.parts)
      {
        file.seekp(begin);
        file.write(bytes.data(), bytes.size());
      }
    file.close();
    std::error_code error;
    if (file)
      std::filesystem::resize_file(file_name, state.size, error);
    if (!file || error)
      throw InputError("The file '" + file_name + "' cannot be written.");
  }
} // namespace StickSlip
