// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_parameter_file_h
#define stickslip_parameters_parameter_file_h

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * One `set` of a parameter file or one override from the command line.
   */
  struct Assignment
  {
    /** Names of the nested subsections, outermost first. */
    std::vector<std::string> sections;

    std::string entry;
    std::string value;

    /** Origin, such as "a.prm, line 3" or "--set". */
    std::string origin;

    /** The file; empty for the command line. */
    std::string file;

    /** Folder in which names of files that the value may have begin, that of
     * the file of origin; empty for the current folder. */
    std::string folder;

    /** Sections and entry joined by '/'. */
    std::string
    path() const;
  };

  /**
   * A subsection of a parameter file with nothing in it.
   */
  struct EmptySubsection
  {
    /** Names of the nested subsections, outermost first, its own last. */
    std::vector<std::string> sections;

    /** Origin, such as "a.prm, line 3". */
    std::string origin;
  };

  /**
   * Contents of a parameter file and of those that it includes.
   */
  struct ParameterText
  {
    std::vector<Assignment>      assignments;
    std::vector<EmptySubsection> empty_subsections;
  };

  /**
   * All assignments of a parameter file in their order, and its empty
   * subsections. The format is that of
   * ParameterHandler, with two differences: the file of an `include` line is
   * looked for next to the file that includes it, and setting an entry twice in
   * one file is an error (an including file may override the included one).
   *
   * Throws InputError naming file and line.
   */
  ParameterText
  read_parameter_file(const std::string &file_name);

  /**
   * Take apart `Section/Subsection/Entry=value`; the first '=' ends the path.
   *
   * Throws InputError.
   */
  Assignment
  parse_override(const std::string &argument);
} // namespace StickSlip

#endif
