// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/output_directory.h>
#include <stickslip/simulation/output_folder.h>

namespace StickSlip
{
  OutputFolder::OutputFolder(const std::string &path)
  {
    std::error_code       error;
    std::filesystem::path folder = std::filesystem::absolute(path, error);
    if (!folder.has_filename())
      folder = folder.parent_path();
    for (; !folder.empty() && !std::filesystem::exists(folder, error);
         folder = folder.parent_path())
      made.push_back(folder);
    OutputDirectory make(path);
    lock = std::make_unique<FolderLock>(path);
  }



  OutputFolder::~OutputFolder()
  {
    std::error_code error;
    for (const std::filesystem::path &folder : made)
      std::filesystem::remove(folder, error);
  }



  std::unique_ptr<OutputFolder>
  claim_output_folder(const std::string   &path,
                      const SceneReader   &reader,
                      const EarlierResults earlier)
  {
    auto                  folder = std::make_unique<OutputFolder>(path);
    const OutputDirectory directory(path);
    if (earlier != EarlierResults::go_on)
      for (const std::string &input : reader.assignments().input_files())
        if (directory.would_replace(input))
          throw InputError("'Output/Output directory' = '" + path +
                           "': the run would write over the file '" + input +
                           "', which it reads.");
    if (earlier == EarlierResults::refuse && directory.has_results())
      throw InputError("'Output/Output directory' = '" + path +
                       "': the results of another run are there; '--overwrite' "
                       "replaces them, '--restart' goes on with that run.");
    return folder;
  }
} // namespace StickSlip
