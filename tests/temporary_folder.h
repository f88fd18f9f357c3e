// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_temporary_folder_h
#define stickslip_tests_temporary_folder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace StickSlip::Tests
{
  /**
   * An empty folder that is deleted with everything in it at the end.
   */
  class TemporaryFolder
  {
  public:
    TemporaryFolder()
    {
      std::string pattern =
        (std::filesystem::temp_directory_path() / "stickslip-XXXXXX").string();
      if (mkdtemp(pattern.data()) == nullptr)
        throw std::runtime_error("no temporary folder");
      path = pattern;
    }

    ~TemporaryFolder()
    {
      std::error_code error;
      std::filesystem::remove_all(path, error);
    }

    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &
    operator=(const TemporaryFolder &) = delete;

    std::string
    file(const std::string &name) const
    {
      return (path / name).string();
    }

    std::string
    write(const std::string &name, const std::string &content) const
    {
      std::ofstream(file(name)) << content;
      return file(name);
    }

    std::filesystem::path path;
  };

  inline std::string
  content_of(const std::string &file_name)
  {
    std::ifstream file(file_name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
} // namespace StickSlip::Tests

#endif
