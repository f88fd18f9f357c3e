// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/base/make_set.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/spatial_field.h>
#include <stickslip/parameters/stress_field.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/known_entries.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Entries in the subsection of one that is not there, or subsections of
     * the deepest one that exists. */
    std::string
    alternatives(const Assignment                 &assignment,
                 const std::vector<DeclaredEntry> &entries)
    {
      std::vector<std::string> sections = assignment.sections;
      while (true)
        {
          std::vector<std::string> names;
          for (const DeclaredEntry &entry : entries)
            {
              if (entry.sections.size() < sections.size() ||
                  !std::equal(sections.begin(),
                              sections.end(),
                              entry.sections.begin()))
                continue;
              const std::string name =
                entry.sections.size() == sections.size() ?
                  entry.name :
                  entry.sections[sections.size()] + "/";
              if (std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
            }
          if (!names.empty())
            {
              std::string where;
              for (const std::string &section : sections)
                where += (where.empty() ? "" : "/") + section;
              return (where.empty() ? std::string("at the top level") :
                                      "in '" + where + "'") +
                     " there are " + join_names(names);
            }
          Assert(!sections.empty(), ExcInternalError());
          sections.pop_back();
        }
    }
  } // namespace



  std::string
  naming(const Assignment &assignment)
  {
    return "'" + assignment.path() + "' = '" + assignment.value + "' (" +
           assignment.origin + ")";
  }



  std::string
  naming(const std::string &path, const std::string &value)
  {
    return "'" + path + "' = '" + value + "'";
  }



  std::string
  naming(const std::string &path, const double value)
  {
    return naming(path, shortest_form(value));
  }



  std::string
  periodic_entry(const unsigned int axis)
  {
    return std::string("Boundary conditions/Periodic along ") + "xy"[axis];
  }



  std::vector<DeclaredEntry>::const_iterator
  find_declared(const std::vector<DeclaredEntry> &entries,
                const Assignment                 &assignment)
  {
    return std::find_if(entries.begin(),
                        entries.end(),
                        [&assignment](const DeclaredEntry &entry) {
                          return entry.name == assignment.entry &&
                                 entry.sections == assignment.sections;
                        });
  }



  void
  refuse_entry(const Assignment                 &assignment,
               const std::vector<DeclaredEntry> &entries)
  {
    std::vector<std::string> paths, of_this_name;
    for (const DeclaredEntry &entry : entries)
      {
        std::string path;
        for (const std::string &section : entry.sections)
          path += section + "/";
        paths.push_back(path + entry.name);
        if (entry.name == assignment.entry)
          of_this_name.push_back(paths.back());
      }
    make_set(of_this_name);
    std::string nearest = nearest_name(assignment.path(), paths);
    if (nearest.empty() && of_this_name.size() == 1)
      nearest = of_this_name[0];
    std::string missing = "entry";
    for (unsigned int n = 1; n <= assignment.sections.size(); ++n)
      if (std::none_of(entries.begin(),
                       entries.end(),
                       [&](const DeclaredEntry &entry) {
                         return entry.sections.size() >= n &&
                                std::equal(assignment.sections.begin(),
                                           assignment.sections.begin() + n,
                                           entry.sections.begin());
                       }))
        {
          missing = "subsection '" + assignment.sections[n - 1] + "'";
          break;
        }
    throw InputError(
      naming(assignment) + ": there is no such " + missing + "; " +
      (nearest.empty() ? "" : "did you mean '" + nearest + "'; ") +
      alternatives(assignment, entries) + ".");
  }



  void
  apply(ParameterHandler                 &prm,
        const std::vector<DeclaredEntry> &entries,
        const Assignment                 &assignment)
  {
    const auto declared = find_declared(entries, assignment);
    if (declared == entries.end())
      refuse_entry(assignment, entries);

    for (const std::string &section : assignment.sections)
      prm.enter_subsection(section);
    try
      {
        const std::string &value  = assignment.value,
                          &folder = assignment.folder;
        prm.set(assignment.entry,
                declared->is_field ?
                  SpatialField::with_absolute_path(value, folder) :
                declared->is_stress ?
                  StressField::with_absolute_paths(value, folder) :
                  value);
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        NumberRange range;
        if (!declared->unit.empty())
          range.in(declared->unit);
        const std::string mistake = range.mistaken_unit(assignment.value);
        throw InputError(naming(assignment) + ": " +
                         (mistake.empty() ? "" : mistake + "; it ") +
                         "must be " + declared->allowed + ".");
      }
    catch (const InputError &error)
      {
        throw InputError(naming(assignment) +
                         ": cannot be used: " + error.what());
      }
    for (unsigned int i = 0; i < assignment.sections.size(); ++i)
      prm.leave_subsection();
  }
} // namespace StickSlip
