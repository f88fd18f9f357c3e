// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_assignments_h
#define stickslip_scene_scene_assignments_h

#include <stickslip/parameters/parameter_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * The assignments of a scene, from a parameter file and overrides of the form
   * `Section/Subsection/Entry=value`, which act after the file. Their values
   * are text that nobody has checked yet. Functions throw InputError with one
   * sentence.
   */
  class SceneAssignments
  {
  public:
    SceneAssignments(const std::string              &file_name,
                     const std::vector<std::string> &overrides);

    /** The parameter file. */
    const std::string &
    file() const
    {
      return file_name;
    }

    /** All in their order. */
    const std::vector<Assignment> &
    list() const
    {
      return assignments;
    }

    const std::vector<EmptySubsection> &
    list_of_empty_subsections() const
    {
      return empty_subsections;
    }

    /** The last assignment to an entry; nullptr if there is none. */
    const Assignment *
    find(const std::string &path) const;

    /** The value of an entry; empty if it is not set. */
    std::string
    value_of(const std::string &path) const;

    /** The names in a list, each of so many words. */
    std::vector<std::string>
    names(const std::string &path, const unsigned int words_per_name) const;

    /** The names of mesh files in an entry with absolute paths: files are next
     * to the parameter file, wherever the program runs. Empty if it is not
     * set. */
    std::string
    with_paths(const std::string &path) const;

    /** The files read: parameter files, and those that are named in them as far
     * as they are there. */
    std::vector<std::string>
    input_files() const;

    /** The message of an error that begins with the path of an entry in quotes,
     * with what the scene says there, and file and line. Other messages, and
     * those that have them, are returned as they are. */
    std::string
    with_origin(const std::string &message) const;

  private:
    /** The last assignment to an entry, or to that of the fault which an entry
     * of a region takes its value from; nullptr if there is none. */
    const Assignment *
    find_or_inherited(const std::string &path) const;

    /** As with_origin(), where the entry at the beginning is not set: the first
     * other one of its section that is named with its value. */
    std::string
    with_origin_of_other(const std::string &message,
                         const std::string &path) const;

    std::string                  file_name;
    std::vector<Assignment>      assignments;
    std::vector<EmptySubsection> empty_subsections;
  };
} // namespace StickSlip

#endif
