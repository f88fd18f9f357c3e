// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_directory_h
#define stickslip_output_output_directory_h

#include <string>

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

  private:
    std::string path;
  };
} // namespace StickSlip

#endif
