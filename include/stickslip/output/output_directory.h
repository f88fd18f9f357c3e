// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_directory_h
#define stickslip_output_output_directory_h

#include <stickslip/output/pvd_record.h>

#include <filesystem>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The folder all files of a run are written to.
   */
  class OutputDirectory
  {
  public:
    /**
     * Create the folder and those above it, and make sure that files can be
     * written there. Throws InputError if not.
     */
    explicit OutputDirectory(const std::string &path);

    /**
     * The path of a file in the folder.
     */
    std::string
    file(const std::string &name) const;

    /**
     * Delete the files a run writes, as far as an earlier run left them here;
     * nothing else is touched.
     */
    void
    remove_earlier_results() const;

    /** Delete the VTU files of an earlier run that are not among these, and
     * its summary: it goes on. */
    void
    remove_later_results(const VolumeEntries &kept) const;

    /** True if there is a file that remove_earlier_results() deletes. */
    bool
    has_results() const;

    /** True if this is a file of the folder by whose name a run writes. */
    bool
    would_replace(const std::string &file_name) const;

  private:
    /** Files and folders that a run writes. */
    std::vector<std::filesystem::path>
    results() const;

    std::string path;
  };
} // namespace StickSlip

#endif
