// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/output_directory.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace StickSlip
{
  OutputDirectory::OutputDirectory(const std::string &path)
    : path(path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!std::filesystem::is_directory(path))
      throw InputError("'Output/Output directory' = '" + path +
                       "': the folder cannot be created" +
                       (error ? " (" + error.message() + ")" : std::string()) +
                       ".");

    const std::string probe = file(".write-test");
    std::ofstream     stream(probe);
    stream << "\n" << std::flush;
    const bool is_writable = static_cast<bool>(stream);
    stream.close();
    std::filesystem::remove(probe, error);
    if (!is_writable)
      throw InputError("'Output/Output directory' = '" + path +
                       "': files cannot be written there.");
  }



  std::string
  OutputDirectory::file(const std::string &name) const
  {
    return (std::filesystem::path(path) / name).string();
  }



  void
  OutputDirectory::remove_earlier_results() const
  {
    static const std::set<std::string> names = {"time_series.csv",
                                                "events.csv",
                                                "openings.csv",
                                                "faults.h5",
                                                "solution.pvd",
                                                "faults.pvd",
                                                "parameters.prm",
                                                "summary.txt"};
    std::error_code                    error;
    std::set<std::filesystem::path>    doomed;
    for (const auto &item : std::filesystem::directory_iterator(path))
      {
        const std::string name      = item.path().filename().string();
        const std::string extension = item.path().extension().string();
        if (names.count(name) > 0 ||
            ((name.rfind("solution", 0) == 0 || name.rfind("fault_", 0) == 0) &&
             (extension == ".vtu" || extension == ".pvtu")))
          doomed.insert(item.path());
      }
    for (const std::filesystem::path &file : doomed)
      std::filesystem::remove(file, error);
  }
} // namespace StickSlip
