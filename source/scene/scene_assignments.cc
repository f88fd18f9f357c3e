// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/scene_assignments.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace StickSlip
{
  SceneAssignments::SceneAssignments(const std::string              &file_name,
                                     const std::vector<std::string> &overrides)
    : file_name(file_name)
  {
    ParameterText text = read_parameter_file(file_name);
    assignments        = std::move(text.assignments);
    empty_subsections  = std::move(text.empty_subsections);
    for (const std::string &argument : overrides)
      assignments.push_back(parse_override(argument));
  }



  const Assignment *
  SceneAssignments::find(const std::string &path) const
  {
    const auto last = std::find_if(assignments.rbegin(),
                                   assignments.rend(),
                                   [&path](const Assignment &assignment) {
                                     return assignment.path() == path;
                                   });
    return last == assignments.rend() ? nullptr : &*last;
  }



  const Assignment *
  SceneAssignments::find_or_inherited(const std::string &path) const
  {
    if (const Assignment *const assignment = find(path))
      return assignment;
    // Entries that a region does not set are as in its fault.
    const std::string regions = "/Regions/";
    const std::size_t begin = path.find(regions), end = path.rfind('/');
    return begin == std::string::npos ?
             nullptr :
             find(path.substr(0, begin) + path.substr(end));
  }



  std::string
  SceneAssignments::value_of(const std::string &path) const
  {
    const Assignment *const assignment = find(path);
    return assignment == nullptr ? "" : assignment->value;
  }



  std::vector<std::string>
  SceneAssignments::names(const std::string &path,
                          const unsigned int words_per_name) const
  {
    const Assignment *const assignment = find(path);
    if (assignment == nullptr)
      return {};

    const NameList pattern(words_per_name);
    if (!pattern.match(assignment->value))
      throw InputError(naming(*assignment) + ": must be " +
                       pattern.description() + ".");

    const std::vector<std::string> list = NameList::split(assignment->value);
    for (auto name = list.begin(); name != list.end(); ++name)
      {
        if (std::find(list.begin(), name, *name) != name)
          throw InputError(naming(*assignment) + ": '" + *name +
                           "' is listed twice; each may be listed once.");
        if (*name == "Names")
          throw InputError(naming(*assignment) +
                           ": 'Names' is an entry; choose another name.");
      }
    return list;
  }



  std::string
  SceneAssignments::with_paths(const std::string &path) const
  {
    const Assignment *const files = find(path);
    if (files == nullptr)
      return "";
    std::vector<std::string> meshes;
    for (const std::string &mesh :
         Utilities::split_string_list(files->value, ','))
      {
        std::vector<std::string> paths;
        for (const std::string &name : Utilities::split_string_list(mesh, '+'))
          paths.push_back(std::filesystem::absolute(
                            std::filesystem::path(files->folder) / name)
                            .lexically_normal()
                            .string());
        meshes.push_back(join_names(paths, " + "));
      }
    return join_names(meshes);
  }



  std::vector<std::string>
  SceneAssignments::input_files() const
  {
    std::set<std::string> files = {file_name};
    for (const Assignment &assignment : assignments)
      {
        if (!assignment.file.empty())
          files.insert(assignment.file);
        // Names of files stand between blanks, commas, quotes and brackets.
        std::string value = assignment.value;
        for (char &c : value)
          if (std::string(",;:'\"()").find(c) != std::string::npos)
            c = ' ';
        for (const std::string &word : Utilities::split_string_list(value, ' '))
          {
            const std::filesystem::path file =
              std::filesystem::path(assignment.folder) / word;
            std::error_code error;
            if (!word.empty() && std::filesystem::is_regular_file(file, error))
              files.insert(file.string());
          }
      }
    return {files.begin(), files.end()};
  }



  std::string
  SceneAssignments::with_origin(const std::string &message) const
  {
    const std::size_t end_of_path = message.find('\'', 1);
    if (message.empty() || message[0] != '\'' ||
        end_of_path == std::string::npos)
      return message;
    std::string path = message.substr(1, end_of_path - 1);
    // One of several components; the name itself may be misspelt as well.
    if (const std::size_t component = path.rfind(" (");
        component != std::string::npos && path.back() == ')')
      path.erase(component);
    const Assignment *const assignment = find_or_inherited(path);
    if (assignment == nullptr)
      return with_origin_of_other(message, path);

    // The value follows, if at all, as it was understood.
    const std::string before_value = " = '";
    std::size_t       end          = end_of_path + 1;
    if (message.compare(end, before_value.size(), before_value) == 0)
      end = message.find('\'', end + before_value.size()) + 1;
    if (end == 0 || message.compare(end, 2, " (") == 0)
      return message;
    Assignment named = *assignment;
    return message.substr(0, end_of_path + 1) + " = '" + named.value + "' (" +
           named.origin + ")" + message.substr(end);
  }



  std::string
  SceneAssignments::with_origin_of_other(const std::string &message,
                                         const std::string &path) const
  {
    const std::string section = path.substr(0, path.rfind('/') + 1);
    for (const Assignment &assignment : assignments)
      {
        const std::string named = "'" + assignment.entry + "' = '";
        const std::size_t place = message.find(named);
        if (place == std::string::npos ||
            section + assignment.entry != assignment.path())
          continue;
        const std::size_t end = message.find('\'', place + named.size());
        if (end != std::string::npos)
          return message.substr(0, end + 1) + " (" + assignment.origin + ")" +
                 message.substr(end + 1);
      }
    return message;
  }
} // namespace StickSlip
