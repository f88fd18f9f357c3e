// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_pvd_record_h
#define stickslip_output_pvd_record_h

#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Times, s, and names of VTU files. Several files of the same time are parts
   * that are seen together.
   */
  using VolumeEntries = std::vector<std::pair<double, std::string>>;

  /**
   * The list of VTU files with their times that ParaView opens as one
   * animation. The file is complete at any moment.
   */
  class PvdRecord
  {
  public:
    explicit PvdRecord(const std::string &file_name)
      : file_name(file_name)
    {}

    /**
     * Add the files of a time that have been written, by their names relative
     * to the list, and write the list. Throws InputError if that is impossible.
     */
    void
    add(const double time, const std::vector<std::string> &vtu_file_names);

    /** The files added so far. */
    const VolumeEntries &
    entries() const
    {
      return files;
    }

    /** Begin with the files of another list, and write it, if there are any.
     * Throws InputError if that is impossible. */
    void
    resume(const VolumeEntries &entries);

  private:
    void
    write() const;

    std::string   file_name;
    VolumeEntries files;
  };
} // namespace StickSlip

#endif
