// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_command_line_h
#define stickslip_scene_command_line_h

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Task that the user gives to the program.
   */
  struct CommandLine
  {
    enum class Task
    {
      run,
      check,
      print_help,
      print_version,
      print_parameters,
      print_parameter_reference
    };

    Task        task = Task::run;
    std::string parameter_file;

    /** Further files to check. */
    std::vector<std::string> more_files;

    /** Go on with the run whose results are there, or replace them. */
    bool restart   = false;
    bool overwrite = false;

    /** The arguments of --set. */
    std::vector<std::string> overrides;
  };

  /**
   * Read the arguments, the program's name not among them. Throws InputError.
   */
  CommandLine
  parse_command_line(const std::vector<std::string> &arguments);

  /**
   * Text that says how the program is called.
   */
  std::string
  command_line_help();
} // namespace StickSlip

#endif
