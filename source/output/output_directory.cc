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



  namespace
  {
    bool
    is_field_file(const std::filesystem::path &name)
    {
      const std::string text      = name.filename().string();
      const std::string extension = name.extension().string();
      return (text.rfind("solution", 0) == 0 || text.rfind("fault_", 0) == 0) &&
             (extension == ".vtu" || extension == ".pvtu");
    }



    /** True if pieces of fields are in a folder of this name. */
    bool
    is_folder_of_pieces(const std::filesystem::path &name)
    {
      const std::string text = name.filename().string(), begin = "solution_";
      return text.rfind(begin, 0) == 0 && text.size() > begin.size() &&
             text.find_first_not_of("0123456789", begin.size()) ==
               std::string::npos;
    }



    /** True if a run, or a figure of it, has this name. */
    bool
    is_result(const std::filesystem::path &name)
    {
      static const std::set<std::string> names = {"time_series.csv",
                                                  "energy.csv",
                                                  "columns.csv",
                                                  "events.csv",
                                                  "openings.csv",
                                                  "faults.h5",
                                                  "solution.pvd",
                                                  "faults.pvd",
                                                  "parameters.prm",
                                                  "refined_cells.txt",
                                                  "summary.txt",
                                                  "checkpoints",
                                                  "stations",
                                                  "run.png",
                                                  "run.html"};
      return names.count(name.filename().string()) > 0 || is_field_file(name) ||
             is_folder_of_pieces(name);
    }
  } // namespace



  std::vector<std::filesystem::path>
  OutputDirectory::results() const
  {
    std::vector<std::filesystem::path> found;
    for (const auto &item : std::filesystem::directory_iterator(path))
      if (is_result(item.path()) &&
          (item.is_regular_file() || item.path().filename() == "checkpoints" ||
           item.path().filename() == "stations" ||
           is_folder_of_pieces(item.path())))
        found.push_back(item.path());
    return found;
  }



  void
  OutputDirectory::remove_earlier_results() const
  {
    std::error_code error;
    for (const std::filesystem::path &item : results())
      std::filesystem::remove_all(item, error);
  }



  void
  OutputDirectory::remove_later_results(const VolumeEntries &kept) const
  {
    std::set<std::string> names;
    for (const auto &entry : kept)
      {
        names.insert(entry.second);
        // Folder of its pieces.
        names.insert(std::filesystem::path(entry.second).stem().string());
      }
    std::error_code error;
    for (const std::filesystem::path &item : results())
      if (item.filename() == "summary.txt" ||
          ((is_field_file(item) || is_folder_of_pieces(item)) &&
           names.count(item.filename().string()) == 0))
        std::filesystem::remove_all(item, error);
  }



  bool
  OutputDirectory::has_results() const
  {
    return !results().empty();
  }



  bool
  OutputDirectory::would_replace(const std::string &file_name) const
  {
    std::error_code             error;
    const std::filesystem::path file =
      std::filesystem::canonical(file_name, error);
    return !error && is_result(file) &&
           std::filesystem::equivalent(file.parent_path(), path, error);
  }
} // namespace StickSlip
