// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/parameters/declared_entries.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/parameters/spatial_field.h>
#include <stickslip/scene/scene_checks.h>
#include <stickslip/scene/scene_declaration.h>
#include <stickslip/scene/scene_reader.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace StickSlip
{
  namespace
  {
    std::string
    naming(const Assignment &assignment)
    {
      return "'" + assignment.path() + "' = '" + assignment.value + "' (" +
             assignment.origin + ")";
    }



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



    /** Assignment to a region of a fault that takes the place of one to the
     * fault, if the region has such an entry. */
    std::optional<Assignment>
    inherited_by(const std::string                &fault,
                 const std::string                &region,
                 const Assignment                 &assignment,
                 const std::vector<DeclaredEntry> &entries)
    {
      if (assignment.sections != std::vector<std::string>{"Faults", fault})
        return {};
      Assignment copy = assignment;
      copy.sections.insert(copy.sections.end(), {"Regions", region});
      if (find_declared(entries, copy) == entries.end())
        return {};
      return copy;
    }



    /** Refuse what says nothing of bodies from mesh files, or of bricks. A
     * value that is the default may stand there. */
    void
    refuse_without_effect(const Assignment                 &assignment,
                          const std::vector<DeclaredEntry> &entries,
                          const bool                        has_mesh)
    {
      static const std::set<std::string> of_bricks = {"Base elevation",
                                                      "Lower lateral corner",
                                                      "Upper lateral corner",
                                                      "Thickness",
                                                      "Upper slope",
                                                      "Coarse cells",
                                                      "Periodic along x",
                                                      "Periodic along y"};
      static const std::set<std::string> of_meshes = {"Length unit",
                                                      "Mesh group",
                                                      "Between",
                                                      "Strike"};
      const auto declared = find_declared(entries, assignment);
      if ((has_mesh ? of_bricks : of_meshes).count(assignment.entry) > 0 &&
          declared != entries.end() &&
          declared->default_value != assignment.value)
        throw InputError(naming(assignment) + ": has no effect, since " +
                         (has_mesh ? "bodies are in mesh files." :
                                     "there is no 'Bodies/Mesh file'."));
    }



    void
    apply(ParameterHandler                 &prm,
          const std::vector<DeclaredEntry> &entries,
          const Assignment                 &assignment)
    {
      const auto declared = find_declared(entries, assignment);
      if (declared == entries.end())
        throw InputError(naming(assignment) + ": there is no such entry; " +
                         alternatives(assignment, entries) + ".");

      for (const std::string &section : assignment.sections)
        prm.enter_subsection(section);
      try
        {
          prm.set(assignment.entry,
                  declared->is_field ?
                    SpatialField::with_absolute_path(assignment.value,
                                                     assignment.folder) :
                    assignment.value);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          throw InputError(naming(assignment) + ": must be " +
                           declared->allowed + ".");
        }
      catch (const InputError &error)
        {
          throw InputError(naming(assignment) +
                           ": cannot be used: " + error.what());
        }
      for (unsigned int i = 0; i < assignment.sections.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace



  SceneReader::SceneReader(const std::string              &file_name,
                           const std::vector<std::string> &overrides)
    : file_name(file_name)
    , assignments(read_parameter_file(file_name))
  {
    for (const std::string &argument : overrides)
      assignments.push_back(parse_override(argument));
  }



  const Assignment *
  SceneReader::find(const std::string &path) const
  {
    const auto last = std::find_if(assignments.rbegin(),
                                   assignments.rend(),
                                   [&path](const Assignment &assignment) {
                                     return assignment.path() == path;
                                   });
    return last == assignments.rend() ? nullptr : &*last;
  }



  unsigned int
  SceneReader::dimension() const
  {
    const Assignment *const assignment = find("Dimension");
    if (assignment == nullptr)
      return 2;
    if (assignment->value != "2" && assignment->value != "3")
      throw InputError(naming(*assignment) + ": must be 2 or 3.");
    return assignment->value == "2" ? 2 : 3;
  }



  std::vector<std::string>
  SceneReader::names(const std::string &path,
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



  template <int dim>
  BoundaryCondition<dim>
  SceneReader::named_side(const std::string          &name,
                          const SceneParameters<dim> &scene) const
  {
    const std::string context =
      naming(*find("Boundary conditions/Sides")) + ": '" + name + "' ";
    const std::size_t space = name.find(' ');

    BoundaryCondition<dim> condition;
    condition.body = name.substr(0, space);
    const auto body =
      std::find_if(scene.bodies.begin(),
                   scene.bodies.end(),
                   [&condition](const BodyParameters<dim> &candidate) {
                     return candidate.name == condition.body;
                   });
    if (body == scene.bodies.end())
      throw InputError(context + "is on no body; the bodies are " +
                       find("Bodies/Names")->value + ".");

    const unsigned int number = body - scene.bodies.begin();
    std::map<types::boundary_id, std::string> sides;
    if (scene.mesh != nullptr)
      sides = scene.mesh->bodies[number].side_names;
    else
      for (unsigned int side = 0; side < 2 * dim; ++side)
        sides[side] = side_name<dim>(side);
    condition.side_name = name.substr(space + 1);
    const auto side =
      std::find_if(sides.begin(), sides.end(), [&](const auto &candidate) {
        return candidate.second == condition.side_name;
      });
    if (side == sides.end())
      {
        std::vector<std::string> names;
        for (const auto &candidate : sides)
          if (scene.mesh == nullptr ||
              !scene.topology.is_at_fault(number, candidate.first))
            names.push_back(candidate.second);
        throw InputError(context + "is no side; the sides of " +
                         (scene.mesh != nullptr ? "this" : "a") + " body are " +
                         join_names(names) + ".");
      }
    condition.side = side->first;

    // Entries depend on the axes.
    if (value_of("Boundary conditions/" + name + "/Axes") == "side")
      condition.axes = BoundaryAxes::side;

    if (scene.topology.is_at_fault(number, condition.side))
      throw InputError(context +
                       "is a fault; conditions are allowed on outer sides "
                       "only.");
    return condition;
  }



  std::string
  SceneReader::value_of(const std::string &path) const
  {
    const Assignment *const assignment = find(path);
    return assignment == nullptr ? "" : assignment->value;
  }



  template <int dim>
  void
  SceneReader::read_mesh(SceneParameters<dim> &scene) const
  {
    // Files are next to the parameter file, wherever the program runs.
    const Assignment        &files = *find("Bodies/Mesh file");
    std::vector<std::string> paths;
    for (const std::string &name :
         Utilities::split_string_list(files.value, ','))
      paths.push_back(
        std::filesystem::absolute(std::filesystem::path(files.folder) / name)
          .lexically_normal()
          .string());
    MeshEntries &entries = scene.mesh_entries;
    entries.files        = join_names(paths);

    if (const Assignment *const unit = find("Bodies/Length unit"))
      {
        const NumberRange positive = NumberRange().above(0);
        if (!positive.match(unit->value))
          throw InputError(naming(*unit) + ": must be " +
                           positive.description() + ".");
        entries.length_unit = NumberRange::values(unit->value)[0];
      }
    for (const FaultParameters &fault : scene.faults)
      {
        entries.faults.push_back({value_of(fault.section() + "/Mesh group"),
                                  value_of(fault.section() + "/Between")});
        try
          {
            parse_between(entries.faults.back().between);
          }
        catch (const InputError &error)
          {
            throw InputError("'" + fault.section() +
                             "/Between': " + error.what());
          }
      }
    // Files say where cells are small, unless the scene asks for more.
    for (BodyParameters<dim> &body : scene.bodies)
      body.geometry.refinement_passes = 0;
    scene.mesh     = std::make_shared<const CutMesh<dim>>(read_meshes<dim>(
      entries, names("Bodies/Names", 1), names("Faults/Names", 1)));
    scene.topology = scene.mesh->topology;
  }



  template <int dim>
  SceneParameters<dim>
  SceneReader::named_scene() const
  {
    SceneParameters<dim> scene;
    for (const std::string &name : names("Bodies/Names", 1))
      {
        scene.bodies.emplace_back();
        scene.bodies.back().name = name;
      }
    if (scene.bodies.empty())
      throw InputError("'Bodies/Names' = '' (" + file_name +
                       "): must list the bodies from bottom to top, at least "
                       "one.");

    for (const std::string &name : names("Faults/Names", 1))
      {
        scene.faults.emplace_back();
        FaultParameters &fault = scene.faults.back();
        fault.name             = name;
        for (const std::string &region :
             names(fault.section() + "/Regions/Names", 1))
          {
            fault.regions.emplace_back();
            fault.regions.back().name = region;
          }
      }
    if (!value_of("Bodies/Mesh file").empty())
      read_mesh(scene);
    else if (scene.faults.size() + 1 != scene.bodies.size())
      {
        const Assignment *const assignment = find("Faults/Names");
        throw InputError(
          (assignment != nullptr ? naming(*assignment) :
                                   "'Faults/Names' = '' (" + file_name + ")") +
          ": must list one fault between each two neighbouring bodies, " +
          std::to_string(scene.bodies.size() - 1) + " for the " +
          std::to_string(scene.bodies.size()) + " of 'Bodies/Names'.");
      }

    if (scene.mesh == nullptr)
      scene.topology =
        stack_topology<dim>(names("Bodies/Names", 1), names("Faults/Names", 1));

    for (const std::string &name : names("Boundary conditions/Sides", 2))
      scene.boundary_conditions.push_back(named_side<dim>(name, scene));
    return scene;
  }



  template <int dim>
  SceneParameters<dim>
  SceneReader::read() const
  {
    Assert(dim == dimension(), ExcDimensionMismatch(dim, dimension()));

    SceneParameters<dim> scene      = named_scene<dim>();
    const std::string    mesh_files = scene.mesh_entries.files;
    {
      ParameterHandler prm;
      declare_scene(prm, scene);
      const std::vector<DeclaredEntry> entries = declared_entries(prm);
      const auto is_of_region = [](const Assignment &assignment) {
        return assignment.sections.size() > 3 &&
               assignment.sections[2] == "Regions";
      };
      for (const Assignment &assignment : assignments)
        if (!is_of_region(assignment))
          {
            refuse_without_effect(assignment, entries, scene.mesh != nullptr);
            apply(prm, entries, assignment);
          }
      // Entries that a region does not set are as in its fault.
      for (const FaultParameters &fault : scene.faults)
        for (const FrictionRegion &region : fault.regions)
          for (const Assignment &assignment : assignments)
            if (std::optional<Assignment> inherited =
                  inherited_by(fault.name, region.name, assignment, entries))
              apply(prm, entries, *inherited);
      for (const Assignment &assignment : assignments)
        if (is_of_region(assignment))
          apply(prm, entries, assignment);
    }
    scene.mesh_entries.files = mesh_files;
    complete_geometry(scene);
    if (scene.output.directory.empty())
      scene.output.directory = (std::filesystem::path("output") /
                                std::filesystem::path(file_name).stem())
                                 .string();
    check_scene(scene);
    return scene;
  }



  template SceneParameters<2>
  SceneReader::read() const;
  template SceneParameters<3>
  SceneReader::read() const;
} // namespace StickSlip
