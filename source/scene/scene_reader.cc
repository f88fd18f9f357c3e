// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <stickslip/base/input_error.h>
#include <stickslip/base/machine_memory.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/automatic_limits.h>
#include <stickslip/scene/coarser_mesh_files.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/known_entries.h>
#include <stickslip/scene/load_breaks.h>
#include <stickslip/scene/mesh_estimate.h>
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



    /** Refuse what says nothing of bodies of another kind. A value that is the
     * default may stand there. */
    void
    refuse_without_effect(const Assignment                 &assignment,
                          const std::vector<DeclaredEntry> &entries,
                          const std::string                &kind_of_bodies)
    {
      static const std::set<std::string> stack = {"bricks in a stack"},
                                         files = {"in mesh files"},
                                         stack_or_blocks = {"bricks in a stack",
                                                            "blocks"},
                                         blocks_or_files = {"blocks",
                                                            "in mesh files"},
                                         blocks          = {"blocks"};
      static const std::map<std::string, std::set<std::string>> kinds = {
        {"Base elevation", stack},
        {"Lower lateral corner", stack},
        {"Upper lateral corner", stack},
        {"Thickness", stack},
        {"Upper slope", stack},
        {"Elevation", stack},
        {"Periodic along x", stack},
        {"Periodic along y", stack},
        {"Coarse cells", stack_or_blocks},
        {"Corners", blocks},
        {"Left polyline", blocks},
        {"Right polyline", blocks},
        {"Bottom polyline", blocks},
        {"Top polyline", blocks},
        {"Extent along y", blocks},
        {"Between", blocks_or_files},
        {"Shape", blocks_or_files},
        {"Shape axis", blocks_or_files},
        {"Strike", blocks_or_files},
        {"Initial gap from mesh", blocks_or_files},
        {"Coarser mesh files", files},
        {"Length unit", files},
        {"Mesh group", files}};
      const auto declared = find_declared(entries, assignment);
      const auto kind     = kinds.find(assignment.entry);
      if (kind != kinds.end() && kind->second.count(kind_of_bodies) == 0 &&
          declared != entries.end() &&
          declared->default_value != assignment.value)
        throw InputError(naming(assignment) +
                         ": has no effect, since bodies are " + kind_of_bodies +
                         ".");
    }
  } // namespace



  SceneReader::SceneReader(const std::string              &file_name,
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
      sides = brick_side_names<dim>();
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

    // Entries depend on components and axes.
    condition.n_components = scene.n_components();
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



  std::string
  SceneReader::with_paths(const std::string &path) const
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



  bool
  SceneReader::has_gap_from_mesh(const FaultParameters &fault) const
  {
    return value_of(fault.section() + "/Initial gap from mesh") == "true";
  }



  std::array<std::vector<MeshFault::Side>, 2>
  SceneReader::parsed_between(const FaultParameters &fault) const
  {
    const std::string entry = fault.section() + "/Between";
    try
      {
        return parse_between(value_of(entry));
      }
    catch (const InputError &error)
      {
        throw InputError("'" + entry + "': " + error.what());
      }
  }



  template <int dim>
  void
  SceneReader::read_mesh(SceneParameters<dim> &scene) const
  {
    // Files are next to the parameter file, wherever the program runs.
    MeshEntries &entries  = scene.mesh_entries;
    entries.files         = with_paths("Bodies/Mesh file");
    entries.coarser_files = with_paths("Bodies/Coarser mesh files");

    if (const Assignment *const unit = find("Bodies/Length unit"))
      {
        const NumberRange positive = NumberRange().above(0).in("m");
        if (!positive.match(unit->value))
          throw InputError(naming(*unit) + ": must be " +
                           positive.description() + ".");
        entries.length_unit = NumberRange::values(unit->value)[0];
      }
    for (const FaultParameters &fault : scene.faults)
      {
        entries.faults.push_back({value_of(fault.section() + "/Mesh group"),
                                  value_of(fault.section() + "/Between"),
                                  has_gap_from_mesh(fault)});
        parsed_between(fault);
      }
    // Files say where cells are small, unless the scene asks for more.
    for (BodyParameters<dim> &body : scene.bodies)
      body.geometry.refinement_passes = 0;
    scene.mesh = std::make_shared<const CutMesh<dim>>(read_meshes<dim>(
      entries, names("Bodies/Names", 1), names("Faults/Names", 1)));
    scene.coarser_meshes = read_coarser_meshes<dim>(entries,
                                                    names("Bodies/Names", 1),
                                                    names("Faults/Names", 1),
                                                    *scene.mesh);
    scene.topology       = scene.mesh->topology;
  }



  void
  SceneReader::read_refinement(MeshAccuracy &accuracy) const
  {
    accuracy.refined_cells_file = with_paths("Mesh/Refined cells");
    if (accuracy.refined_cells_file.empty())
      return;
    try
      {
        accuracy.refined_cells = read_refined_cells(accuracy.refined_cells_file,
                                                    names("Bodies/Names", 1));
      }
    catch (const InputError &error)
      {
        throw InputError(naming(*find("Mesh/Refined cells")) + ": " +
                         error.what());
      }
  }



  template <int dim>
  void
  SceneReader::read_blocks(SceneParameters<dim> &scene) const
  {
    const std::vector<std::string> body_names = names("Bodies/Names", 1);
    std::vector<Block<dim>>        blocks;
    for (const BodyParameters<dim> &body : scene.bodies)
      {
        ParameterHandler    prm;
        BodyParameters<dim> parameters = body;
        declare_body(prm, parameters);
        const std::vector<DeclaredEntry> entries = declared_entries(prm);
        for (const Assignment &assignment : assignments)
          if (find_declared(entries, assignment) != entries.end())
            apply(prm, entries, assignment);
        if (parameters.block.corners.empty())
          throw InputError("'" + body.section() +
                           "/Corners' = '': must be given, since other bodies "
                           "have corners; either all have or none.");
        blocks.push_back(parameters.block.template block<dim>(body.name));
        blocks.back().cells = parameters.geometry.coarse_cells;
      }
    MeshEstimate estimate;
    for (const Block<dim> &block : blocks)
      {
        double cells = 1.;
        for (const unsigned int n : block.cells)
          cells *= n;
        estimate.cells += cells;
      }
    estimate.nodes = estimate.cells;
    refuse_too_large(estimate, dim, 1, machine_memory());
    std::vector<MeshFault> faults;
    for (const FaultParameters &fault : scene.faults)
      {
        const std::string entry = fault.section() + "/Between";
        parsed_between(fault);
        check_between_blocks<dim>(entry, value_of(entry), body_names);
        faults.push_back({fault.name,
                          fault.name,
                          parsed_between(fault),
                          has_gap_from_mesh(fault)});
        if (value_of(fault.section() + "/Shape") == "smooth")
          smoothen(blocks, faults.back());
      }
    CutMesh<dim> mesh = cut_at_faults(cells_of_blocks(blocks), faults);
    note_outlines(blocks, mesh);
    scene.topology = mesh.topology;
    scene.mesh     = std::make_shared<const CutMesh<dim>>(std::move(mesh));
  }



  template <int dim>
  SceneParameters<dim>
  SceneReader::named_scene() const
  {
    SceneParameters<dim> scene;
    if (value_of("Deformation") == "antiplane")
      scene.deformation = Deformation::antiplane;
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
    else if (std::any_of(
               scene.bodies.begin(),
               scene.bodies.end(),
               [&](const BodyParameters<dim> &body) {
                 return !value_of(body.section() + "/Corners").empty();
               }))
      read_blocks(scene);
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

    try
      {
        refuse_unknown_entries(assignments);
        refuse_unknown_subsections(empty_subsections);
        // The form of lists first, then what is not in them.
        names("Bodies/Names", 1);
        for (const std::string &fault : names("Faults/Names", 1))
          names("Faults/" + fault + "/Regions/Names", 1);
        refuse_unlisted_names(assignments,
                              empty_subsections,
                              {"Bodies", "Faults"});
        return checked_scene<dim>();
      }
    catch (const InputError &error)
      {
        throw InputError(with_origin(error.what()));
      }
  }



  template <int dim>
  SceneParameters<dim>
  SceneReader::checked_scene() const
  {
    SceneParameters<dim> scene = named_scene<dim>();
    refuse_unlisted_names(assignments,
                          empty_subsections,
                          {"Boundary conditions"});
    const MeshEntries mesh_entries = scene.mesh_entries;
    // Meshes that the program chooses start from the coarse cells.
    if (value_of("Mesh/Refined cells") != "" ||
        !(value_of("Mesh/Accuracy") == "" || value_of("Mesh/Accuracy") == "0"))
      for (BodyParameters<dim> &body : scene.bodies)
        body.geometry.refinement_passes = 0;
    {
      ParameterHandler prm;
      declare_scene(prm, scene);
      const std::vector<DeclaredEntry> entries = declared_entries(prm);
      const auto is_of_region = [](const Assignment &assignment) {
        return assignment.sections.size() > 3 &&
               assignment.sections[2] == "Regions";
      };
      const std::string kind_of_bodies =
        scene.mesh == nullptr      ? "bricks in a stack" :
        mesh_entries.files.empty() ? "blocks" :
                                     "in mesh files";
      for (const Assignment &assignment : assignments)
        if (!is_of_region(assignment))
          {
            refuse_without_effect(assignment, entries, kind_of_bodies);
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
    scene.mesh_entries.files         = mesh_entries.files;
    scene.mesh_entries.coarser_files = mesh_entries.coarser_files;
    read_refinement(scene.mesh_accuracy);
    complete_geometry(scene);
    if (scene.output.directory.empty())
      scene.output.directory = (std::filesystem::path("output") /
                                std::filesystem::path(file_name).stem())
                                 .string();
    check_scene(scene);
    derive_limits(scene);
    scene.time.step_ends = load_breaks(scene);
    check_limits(scene);
    return scene;
  }



  std::vector<std::string>
  SceneReader::warnings() const
  {
    std::vector<std::string> result;
    const auto               look_for = [&](const std::string &section,
                              const std::string &list,
                              const unsigned int words) {
      for (const std::string &name : names(section + "/" + list, words))
        {
          const std::string beginning = section + "/" + name + "/";
          if (std::none_of(assignments.begin(),
                           assignments.end(),
                           [&beginning](const Assignment &assignment) {
                             return assignment.path().rfind(beginning, 0) == 0;
                           }))
            result.push_back("'" + section + "/" + list + "': lists '" + name +
                             "', for which the scene says nothing, so that all "
                                           "of it is as by default.");
        }
    };
    look_for("Bodies", "Names", 1);
    look_for("Faults", "Names", 1);
    for (const std::string &fault : names("Faults/Names", 1))
      look_for("Faults/" + fault + "/Regions", "Names", 1);
    look_for("Boundary conditions", "Sides", 2);
    return result;
  }



  std::string
  SceneReader::with_origin(const std::string &message) const
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
  SceneReader::with_origin_of_other(const std::string &message,
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



  const Assignment *
  SceneReader::find_or_inherited(const std::string &path) const
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



  std::vector<std::string>
  SceneReader::input_files() const
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



  template SceneParameters<2>
  SceneReader::read() const;
  template SceneParameters<3>
  SceneReader::read() const;
} // namespace StickSlip
