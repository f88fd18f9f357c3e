// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_volume_files_h
#define stickslip_output_volume_files_h

#include <stickslip/output/volume_writer.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The VTU files of the bodies in a folder, of one number and time, s: one
   * file, or one piece for each process and a PVTU file that joins them. The
   * names of the bodies are the strings body_names of the files. Functions
   * return names relative to the folder, and throw InputError where a file
   * cannot be written.
   */
  class VolumeFiles
  {
  public:
    VolumeFiles(const std::string              &directory,
                const unsigned int              number,
                const double                    time,
                const std::vector<std::string> &body_names);

    /** Write all in one file. */
    std::string
    write(const VolumeContent &content) const;

    /** Make the folder of the pieces. */
    void
    make_folder() const;

    /** Write the piece of a process. */
    void
    write_piece(const unsigned int process, const VolumeContent &own) const;

    /** Write the file that joins the pieces of all processes, with the fields
     * that one of them has. */
    std::string
    join_pieces(const unsigned int n_processes, const VolumeContent &own) const;

  private:
    /** The piece of a process. */
    std::string
    piece(const unsigned int process) const;

    const std::string              directory, name;
    const double                   time;
    const std::vector<std::string> body_names;
  };
} // namespace StickSlip

#endif
