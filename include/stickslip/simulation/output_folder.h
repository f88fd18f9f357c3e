// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_output_folder_h
#define stickslip_simulation_output_folder_h

#include <stickslip/output/folder_lock.h>
#include <stickslip/scene/scene_reader.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /** Fate of the results that are in the output folder. */
  enum class EarlierResults
  {
    refuse,
    overwrite,
    go_on
  };

  /**
   * The right of a run to its output folder. Where that was made for the run
   * and is still empty in the end, it is removed again, with the folders above
   * it that were made as well.
   */
  class OutputFolder
  {
  public:
    /** Make the folder if it is not there, and lock it. Throws InputError. */
    explicit OutputFolder(const std::string &path);

    ~OutputFolder();

    OutputFolder(const OutputFolder &) = delete;

    OutputFolder &
    operator=(const OutputFolder &) = delete;

  private:
    /** Folders that were made, the innermost first. */
    std::vector<std::filesystem::path> made;
    std::unique_ptr<FolderLock>        lock;
  };

  /**
   * Make the output folder of a run if it is not there, and lock it. Throws
   * InputError, and changes nothing, if another run is writing there, if a file
   * of the run would take the place of one that @p reader reads, or if there
   * are results that are to stay. For one process.
   */
  std::unique_ptr<OutputFolder>
  claim_output_folder(const std::string   &path,
                      const SceneReader   &reader,
                      const EarlierResults earlier);
} // namespace StickSlip

#endif
