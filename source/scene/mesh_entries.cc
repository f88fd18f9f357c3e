// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/scene/mesh_entries.h>

#include <sstream>

namespace StickSlip
{
  std::array<std::vector<MeshFault::Side>, 2>
  parse_between(const std::string &text)
  {
    std::array<std::vector<MeshFault::Side>, 2> result;
    if (Utilities::trim(text).empty())
      return result;
    const auto refuse = [&text]() {
      throw InputError("'" + text +
                       "' must be two bodies separated by a comma, such as "
                       "'footwall, hanging_wall', or two sides of bodies, such "
                       "as 'lower top, left bottom + right bottom'.");
    };
    // Neither a comma nor a plus sign may stand at the end.
    const auto split = [](const std::string &list, const char separator) {
      std::vector<std::string> parts = {""};
      for (const char c : list)
        if (c == separator)
          parts.emplace_back();
        else
          parts.back() += c;
      return parts;
    };
    const std::vector<std::string> sides = split(text, ',');
    if (sides.size() != 2)
      refuse();
    for (const unsigned int side : {0, 1})
      for (const std::string &part : split(sides[side], '+'))
        {
          std::istringstream       stream(part);
          std::vector<std::string> words;
          for (std::string word; stream >> word;)
            words.push_back(word);
          if (words.empty() || words.size() > 2)
            refuse();
          result[side].push_back({words[0], words.size() == 2 ? words[1] : ""});
        }
    return result;
  }



  template <int dim>
  CutMesh<dim>
  read_meshes(const MeshEntries              &entries,
              const std::vector<std::string> &body_names,
              const std::vector<std::string> &fault_names)
  {
    AssertDimension(entries.faults.size(), fault_names.size());
    std::vector<GmshFile> files;
    for (const std::string &name :
         Utilities::split_string_list(entries.files, ','))
      files.emplace_back(name, entries.length_unit);
    std::vector<MeshFault> faults;
    for (unsigned int f = 0; f < fault_names.size(); ++f)
      {
        const MeshEntries::OfFault &fault = entries.faults[f];
        faults.push_back({fault_names[f],
                          fault.group.empty() ? fault_names[f] : fault.group,
                          parse_between(fault.between),
                          fault.may_be_apart});
      }
    return cut_at_faults(GroupedCells<dim>(files, body_names), faults);
  }



  template CutMesh<2>
  read_meshes(const MeshEntries &,
              const std::vector<std::string> &,
              const std::vector<std::string> &);
  template CutMesh<3>
  read_meshes(const MeshEntries &,
              const std::vector<std::string> &,
              const std::vector<std::string> &);
} // namespace StickSlip
