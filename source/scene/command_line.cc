// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/scene/command_line.h>

namespace StickSlip
{
  CommandLine
  parse_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine       command_line;
    const std::string set     = "--set";
    bool              is_help = false, is_version = false, is_reference = false,
         is_check = false, is_parameters = false;
    for (unsigned int i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        if (argument == set)
          {
            if (i + 1 == arguments.size())
              throw InputError("--set: must be followed by "
                               "'Section/Subsection/Entry=value'.");
            command_line.overrides.push_back(arguments[++i]);
          }
        else if (argument.rfind(set + "=", 0) == 0)
          command_line.overrides.push_back(argument.substr(set.size() + 1));
        else if (argument == "--check")
          is_check = true;
        else if (argument == "--restart")
          command_line.restart = true;
        else if (argument == "--overwrite")
          command_line.overwrite = true;
        else if (argument == "--help" || argument == "-h")
          is_help = true;
        else if (argument == "--version")
          is_version = true;
        else if (argument == "--print-parameters")
          is_parameters = true;
        else if (argument == "--parameter-reference")
          is_reference = true;
        else if (argument.rfind("-", 0) == 0)
          throw InputError(
            "'" + argument +
            "': there is no such option; allowed are --set, --restart, "
            "--overwrite, --check, --print-parameters, --help, --version and "
            "--parameter-reference.");
        else if (!command_line.parameter_file.empty() && is_check)
          command_line.more_files.push_back(argument);
        else if (!command_line.parameter_file.empty())
          throw InputError("'" + argument +
                           "': a parameter file is already "
                           "given, '" +
                           command_line.parameter_file +
                           "'; one is allowed, or several after --check.");
        else
          command_line.parameter_file = argument;
      }

    if (is_help)
      command_line.task = CommandLine::Task::print_help;
    else if (is_version)
      command_line.task = CommandLine::Task::print_version;
    else if (is_reference)
      command_line.task = CommandLine::Task::print_parameter_reference;
    else if (command_line.parameter_file.empty())
      throw InputError("No parameter file is given; the program is called as "
                       "'stickslip FILE.prm', see 'stickslip --help'.");
    else if (command_line.restart && command_line.overwrite)
      throw InputError("--restart goes on with the results that are there, "
                       "--overwrite replaces them; one of both is allowed.");
    else if (is_parameters)
      command_line.task = CommandLine::Task::print_parameters;
    else if (is_check)
      command_line.task = CommandLine::Task::check;
    return command_line;
  }



  std::string
  command_line_help()
  {
    return R"text(Usage: stickslip FILE.prm [OPTION]...
       mpirun -np N stickslip FILE.prm [OPTION]...

Simulates the fault system that the parameter file describes, on one process or
on N. Results land in the folder Output/Output directory, by default
output/<name of the file> below the current one.

What is done with the scene:
  --set PATH=VALUE        override an entry, 'Section/Subsection/Entry=value';
                          may be repeated
  --restart               go on with the run whose results are in the output
                          directory, from its last whole checkpoint
  --overwrite             replace results that are there
  --check                 in place of a run, say what will happen in one, print
                          bodies, sides and faults, and write pictures of the
                          meshes into the output directory; several files may
                          follow
  --print-parameters      in place of a run, print all entries of the scene with
                          their values, defaults and --set included, and what
                          they mean; what is printed is a parameter file

Without a file:
  --help, -h              print this text
  --version               print the version, the revision of the sources, and the
                          versions of the libraries
  --parameter-reference   print all entries of parameter files, in Markdown

An interrupt (Ctrl-C), SIGTERM, SIGHUP or SIGUSR1 ends a run after the current step
with complete files; that to mpirun should be SIGUSR1, since it may kill a run half a
second after others. Exit status: 0 the end time was reached, 130 the run was
interrupted, 1 there was an error, of which one sentence is printed.

Entries are in doc/parameters.md, the files of a run in doc/output.md.
)text";
  }
} // namespace StickSlip
