// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/parameter_file.h>
#include <stickslip/parameters/text_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace StickSlip
{
  using namespace dealii;

  namespace
  {
    /** The text with one blank in place of each run of more than a file name
     * can have, over which deal.II's lists would take the square of the
     * time. */
    std::string
    without_long_gaps(const std::string &text)
    {
      constexpr std::size_t longest_name = 255;
      std::string           result;
      std::size_t           begin = 0;
      while (begin < text.size())
        {
          const std::size_t gap = text.find(' ', begin);
          const std::size_t end = text.find_first_not_of(' ', gap);
          result += text.substr(begin, gap - begin);
          if (gap == std::string::npos)
            break;
          const std::size_t next = std::min(end, text.size());
          result +=
            std::string(next - gap > longest_name ? 1 : next - gap, ' ');
          begin = next;
        }
      return result;
    }



    // Inner spaces carry no meaning in names.
    std::string
    squeeze(const std::string &text)
    {
      std::string result;
      for (const char c : Utilities::trim(text))
        if (c != ' ' || result.back() != ' ')
          result += c;
      return result;
    }



    class FileScanner
    {
    public:
      FileScanner(const std::string &file_name, const unsigned int depth)
        : file_name(file_name)
        , depth(depth)
      {}

      ParameterText
      scan()
      {
        if (!std::filesystem::is_regular_file(file_name))
          throw InputError("The parameter file '" + file_name +
                           "' does not exist or is not a file.");
        std::ifstream file(file_name);
        if (!file)
          throw InputError("The parameter file '" + file_name +
                           "' cannot be read.");

        std::string statement, line;
        while (std::getline(file, line))
          {
            ++line_number;
            remove_byte_order_mark(line, line_number);
            if (line.find('\0') != std::string::npos)
              throw InputError(here() +
                               ": there is a byte of value zero; a parameter "
                               "file is plain text in UTF-8.");
            line                = line.substr(0, line.find('#'));
            const int character = control_character(line);
            if (character == '\r')
              throw InputError(here() +
                               ": there is a carriage return within the line; "
                               "lines end with a line feed.");
            if (character >= 0)
              throw InputError(here() + ": there is the control character " +
                               std::to_string(character) +
                               "; a parameter file is plain text in UTF-8.");
            std::replace(line.begin(), line.end(), '\t', ' ');
            line = without_long_gaps(Utilities::trim(line));

            // A backslash at the end continues the statement on the next line.
            const bool continues = !line.empty() && line.back() == '\\';
            if (continues)
              line.pop_back();
            statement += (statement.empty() ? "" : " ") + Utilities::trim(line);
            if (continues)
              continue;
            if (!statement.empty())
              interpret(statement);
            statement.clear();
          }
        if (!statement.empty())
          interpret(statement);

        if (!sections.empty())
          throw InputError(file_name + ": the subsection '" + sections.back() +
                           "' is not closed by an 'end'.");
        return std::move(text);
      }

    private:
      std::string
      here() const
      {
        return file_name + ", line " + std::to_string(line_number);
      }

      void
      interpret(const std::string &line)
      {
        const std::string word = line.substr(0, line.find(' '));
        const std::string rest = Utilities::trim(line.substr(word.size()));

        if (word == "set" || word == "SET")
          set(rest);
        else if (word == "include" || word == "INCLUDE")
          include(rest);
        else if ((word == "subsection" || word == "SUBSECTION") &&
                 !rest.empty())
          {
            sections.push_back(squeeze(rest));
            is_empty    = true;
            where_it_is = here();
          }
        else if ((word == "end" || word == "END") && rest.empty())
          {
            if (sections.empty())
              throw InputError(
                here() + ": 'end' closes a subsection, but none is open.");
            if (is_empty)
              text.empty_subsections.push_back({sections, where_it_is});
            is_empty = false;
            sections.pop_back();
          }
        else
          throw InputError(
            here() + ": cannot read '" + line +
            "'; a line is 'subsection NAME', 'set ENTRY = VALUE', "
            "'end' or 'include FILE'.");
      }

      void
      set(const std::string &rest)
      {
        const std::size_t equals = rest.find('=');
        if (equals == std::string::npos || equals == 0)
          throw InputError(here() + ": cannot read 'set " + rest +
                           "'; it must be 'set ENTRY = VALUE'.");

        Assignment assignment;
        assignment.sections = sections;
        assignment.entry    = squeeze(rest.substr(0, equals));
        assignment.value    = Utilities::trim(rest.substr(equals + 1));
        assignment.origin   = here();
        assignment.file     = file_name;
        assignment.folder =
          std::filesystem::path(file_name).parent_path().string();

        const auto [earlier, is_new] =
          line_of.emplace(assignment.path(), line_number);
        if (!is_new)
          throw InputError(here() + ": '" + assignment.path() + "' = '" +
                           assignment.value +
                           "' is set a second time, first in line " +
                           std::to_string(earlier->second) +
                           "; each entry may be set once in a file.");
        text.assignments.push_back(assignment);
        is_empty = false;
      }

      void
      include(const std::string &rest)
      {
        if (rest.empty())
          throw InputError(here() + ": 'include' names no file.");
        if (!sections.empty())
          throw InputError(here() + ": 'include " + rest +
                           "' must stand outside all subsections.");
        if (depth > 20)
          throw InputError(here() + ": 'include " + rest +
                           "' is nested more than 20 files deep.");

        const std::filesystem::path next_to_this =
          std::filesystem::path(file_name).parent_path() / rest;
        if (!std::filesystem::is_regular_file(next_to_this))
          throw InputError(here() + ": the file '" + next_to_this.string() +
                           "' to include does not exist.");
        ParameterText included =
          FileScanner(next_to_this.string(), depth + 1).scan();
        std::move(included.assignments.begin(),
                  included.assignments.end(),
                  std::back_inserter(text.assignments));
        std::move(included.empty_subsections.begin(),
                  included.empty_subsections.end(),
                  std::back_inserter(text.empty_subsections));
      }

      const std::string        file_name;
      const unsigned int       depth;
      unsigned int             line_number = 0;
      std::vector<std::string> sections;

      // True if the last subsection that has begun has nothing in it so far,
      // and its beginning.
      bool        is_empty = false;
      std::string where_it_is;

      ParameterText                       text;
      std::map<std::string, unsigned int> line_of;
    };
  } // namespace



  std::string
  Assignment::path() const
  {
    std::string joined;
    for (const std::string &section : sections)
      joined += section + "/";
    return joined + entry;
  }



  ParameterText
  read_parameter_file(const std::string &file_name)
  {
    return FileScanner(file_name, 0).scan();
  }



  Assignment
  parse_override(const std::string &argument)
  {
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos)
      throw InputError("--set '" + argument +
                       "': must be 'Section/Subsection/Entry=value'.");

    Assignment assignment;
    assignment.sections =
      Utilities::split_string_list(argument.substr(0, equals), '/');
    for (std::string &section : assignment.sections)
      section = squeeze(section);
    if (assignment.sections.empty() ||
        std::any_of(assignment.sections.begin(),
                    assignment.sections.end(),
                    [](const std::string &name) { return name.empty(); }))
      throw InputError("--set '" + argument +
                       "': names no entry; it must be "
                       "'Section/Subsection/Entry=value'.");
    assignment.entry = assignment.sections.back();
    assignment.sections.pop_back();
    assignment.value  = Utilities::trim(argument.substr(equals + 1));
    assignment.origin = "--set";
    return assignment;
  }
} // namespace StickSlip
