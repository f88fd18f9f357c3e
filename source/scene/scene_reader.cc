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
    : given(file_name, overrides)
  {}



  unsigned int
  SceneReader::dimension() const
  {
    const Assignment *const assignment = given.find("Dimension");
    if (assignment == nullptr)
      return 2;
    if (assignment->value != "2" && assignment->value != "3")
      throw InputError(naming(*assignment) + ": must be 2 or 3.");
    return assignment->value == "2" ? 2 : 3;
  }



  template <int dim>
  BoundaryCondition<dim>
  SceneReader::named_side(const std::string          &name,
                          const SceneParameters<dim> &scene) const
  {
    const std::string context =
      naming(*given.find("Boundary conditions/Sides")) + ": '" + name + "' ";
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
                       given.find("Bodies/Names")->value + ".");

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
    if (given.value_of("Boundary conditions/" + name + "/Axes") == "side")
      condition.axes = BoundaryAxes::side;

    if (scene.topology.is_at_fault(number, condition.side))
      throw InputError(context +
                       "is a fault; conditions are allowed on outer sides "
                       "only.");
    return condition;
  }



  bool
  SceneReader::has_gap_from_mesh(const FaultParameters &fault) const
  {
    return given.value_of(fault.section() + "/Initial gap from mesh") == "true";
  }



  std::array<std::vector<MeshFault::Side>, 2>
  SceneReader::parsed_between(const FaultParameters &fault) const
  {
    const std::string entry = fault.section() + "/Between";
    try
      {
        return parse_between(given.value_of(entry));
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
    entries.files         = given.with_paths("Bodies/Mesh file");
    entries.coarser_files = given.with_paths("Bodies/Coarser mesh files");

    if (const Assignment *const unit = given.find("Bodies/Length unit"))
      {
        const NumberRange positive = NumberRange().above(0).in("m");
        if (!positive.match(unit->value))
          throw InputError(naming(*unit) + ": must be " +
                           positive.description() + ".");
        entries.length_unit = NumberRange::values(unit->value)[0];
      }
    for (const FaultParameters &fault : scene.faults)
      {
        entries.faults.push_back(
          {given.value_of(fault.section() + "/Mesh group"),
           given.value_of(fault.section() + "/Between"),
           has_gap_from_mesh(fault)});
        parsed_between(fault);
      }
    // Files say where cells are small, unless the scene asks for more.
    for (BodyParameters<dim> &body : scene.bodies)
      body.geometry.refinement_passes = 0;
    scene.mesh = std::make_shared<const CutMesh<dim>>(read_meshes<dim>(
      entries, given.names("Bodies/Names", 1), given.names("Faults/Names", 1)));
    scene.coarser_meshes =
      read_coarser_meshes<dim>(entries,
                               given.names("Bodies/Names", 1),
                               given.names("Faults/Names", 1),
                               *scene.mesh);
    scene.topology = scene.mesh->topology;
  }



  void
  SceneReader::read_refinement(MeshAccuracy &accuracy) const
  {
    accuracy.refined_cells_file = given.with_paths("Mesh/Refined cells");
    if (accuracy.refined_cells_file.empty())
      return;
    try
      {
        accuracy.refined_cells =
          read_refined_cells(accuracy.refined_cells_file,
                             given.names("Bodies/Names", 1));
      }
    catch (const InputError &error)
      {
        throw InputError(naming(*given.find("Mesh/Refined cells")) + ": " +
                         error.what());
      }
  }



  template <int dim>
  void
  SceneReader::read_blocks(SceneParameters<dim> &scene) const
  {
    const std::vector<std::string> body_names = given.names("Bodies/Names", 1);
    std::vector<Block<dim>>        blocks;
    for (const BodyParameters<dim> &body : scene.bodies)
      {
        ParameterHandler    prm;
        BodyParameters<dim> parameters = body;
        declare_body(prm, parameters);
        const std::vector<DeclaredEntry> entries = declared_entries(prm);
        for (const Assignment &assignment : given.list())
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
        check_between_blocks<dim>(entry, given.value_of(entry), body_names);
        faults.push_back({fault.name,
                          fault.name,
                          parsed_between(fault),
                          has_gap_from_mesh(fault)});
        if (given.value_of(fault.section() + "/Shape") == "smooth")
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
    if (given.value_of("Deformation") == "antiplane")
      scene.deformation = Deformation::antiplane;
    for (const std::string &name : given.names("Bodies/Names", 1))
      {
        scene.bodies.emplace_back();
        scene.bodies.back().name = name;
      }
    if (scene.bodies.empty())
      throw InputError("'Bodies/Names' = '' (" + given.file() +
                       "): must list the bodies from bottom to top, at least "
                       "one.");

    for (const std::string &name : given.names("Faults/Names", 1))
      {
        scene.faults.emplace_back();
        FaultParameters &fault = scene.faults.back();
        fault.name             = name;
        for (const std::string &region :
             given.names(fault.section() + "/Regions/Names", 1))
          {
            fault.regions.emplace_back();
            fault.regions.back().name = region;
          }
      }
    if (!given.value_of("Bodies/Mesh file").empty())
      read_mesh(scene);
    else if (std::any_of(
               scene.bodies.begin(),
               scene.bodies.end(),
               [&](const BodyParameters<dim> &body) {
                 return !given.value_of(body.section() + "/Corners").empty();
               }))
      read_blocks(scene);
    else if (scene.faults.size() + 1 != scene.bodies.size())
      {
        const Assignment *const assignment = given.find("Faults/Names");
        throw InputError(
          (assignment != nullptr ?
             naming(*assignment) :
             "'Faults/Names' = '' (" + given.file() + ")") +
          ": must list one fault between each two neighbouring bodies, " +
          std::to_string(scene.bodies.size() - 1) + " for the " +
          std::to_string(scene.bodies.size()) + " of 'Bodies/Names'.");
      }

    if (scene.mesh == nullptr)
      scene.topology = stack_topology<dim>(given.names("Bodies/Names", 1),
                                           given.names("Faults/Names", 1));

    for (const std::string &name : given.names("Boundary conditions/Sides", 2))
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
        refuse_unknown_entries(given.list());
        refuse_unknown_subsections(given.list_of_empty_subsections());
        // The form of lists first, then what is not in them.
        given.names("Bodies/Names", 1);
        for (const std::string &fault : given.names("Faults/Names", 1))
          given.names("Faults/" + fault + "/Regions/Names", 1);
        refuse_unlisted_names(given.list(),
                              given.list_of_empty_subsections(),
                              {"Bodies", "Faults"});
        return checked_scene<dim>();
      }
    catch (const InputError &error)
      {
        throw InputError(given.with_origin(error.what()));
      }
  }



  template <int dim>
  SceneParameters<dim>
  SceneReader::checked_scene() const
  {
    SceneParameters<dim> scene = named_scene<dim>();
    refuse_unlisted_names(given.list(),
                          given.list_of_empty_subsections(),
                          {"Boundary conditions"});
    const MeshEntries mesh_entries = scene.mesh_entries;
    // Meshes that the program chooses start from the coarse cells.
    if (given.value_of("Mesh/Refined cells") != "" ||
        !(given.value_of("Mesh/Accuracy") == "" ||
          given.value_of("Mesh/Accuracy") == "0"))
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
      for (const Assignment &assignment : given.list())
        if (!is_of_region(assignment))
          {
            refuse_without_effect(assignment, entries, kind_of_bodies);
            apply(prm, entries, assignment);
          }
      // Entries that a region does not set are as in its fault.
      for (const FaultParameters &fault : scene.faults)
        for (const FrictionRegion &region : fault.regions)
          for (const Assignment &assignment : given.list())
            if (std::optional<Assignment> inherited =
                  inherited_by(fault.name, region.name, assignment, entries))
              apply(prm, entries, *inherited);
      for (const Assignment &assignment : given.list())
        if (is_of_region(assignment))
          apply(prm, entries, assignment);
    }
    scene.mesh_entries.files         = mesh_entries.files;
    scene.mesh_entries.coarser_files = mesh_entries.coarser_files;
    read_refinement(scene.mesh_accuracy);
    complete_geometry(scene);
    if (scene.output.directory.empty())
      scene.output.directory = (std::filesystem::path("output") /
                                std::filesystem::path(given.file()).stem())
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
      for (const std::string &name : given.names(section + "/" + list, words))
        {
          const std::string beginning = section + "/" + name + "/";
          if (std::none_of(given.list().begin(),
                           given.list().end(),
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
    for (const std::string &fault : given.names("Faults/Names", 1))
      look_for("Faults/" + fault + "/Regions", "Names", 1);
    look_for("Boundary conditions", "Sides", 2);
    return result;
  }



  template SceneParameters<2>
  SceneReader::read() const;
  template SceneParameters<3>
  SceneReader::read() const;
} // namespace StickSlip
