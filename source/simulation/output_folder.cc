// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/output/output_directory.h>
#include <stickslip/simulation/output_folder.h>

#include <filesystem>

namespace StickSlip
{
  std::unique_ptr<FolderLock>
  claim_output_folder(const std::string   &path,
                      const SceneReader   &reader,
                      const EarlierResults earlier)
  {
    const OutputDirectory directory(path);
    auto                  lock = std::make_unique<FolderLock>(path);
    if (earlier != EarlierResults::go_on)
      for (const std::string &input : reader.input_files())
        if (directory.would_replace(input))
          throw InputError("'Output/Output directory' = '" + path +
                           "': the run would write over the file '" + input +
                           "', which it reads.");
    if (earlier == EarlierResults::refuse && directory.has_results())
      throw InputError("'Output/Output directory' = '" + path +
                       "': the results of another run are there; '--overwrite' "
                       "replaces them, '--restart' goes on with that run.");
    return lock;
  }
} // namespace StickSlip
