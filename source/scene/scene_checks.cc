// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/scene/boundary_checks.h>
#include <stickslip/scene/entry_assignment.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_checks.h>
#include <stickslip/scene/scene_declaration.h>
#include <stickslip/scene/side_points.h>
#include <stickslip/scene/thickness_checks.h>

#include <algorithm>
#include <map>
#include <set>

namespace StickSlip
{
  namespace
  {
    /** The name of an entry and its value. */
    using Entry = std::pair<std::string, double>;



    void
    check_order(const std::string &section,
                const Entry       &lower,
                const Entry       &upper)
    {
      if (lower.second > upper.second)
        throw InputError(naming(section + "/" + lower.first, lower.second) +
                         ": must not be larger than " +
                         naming(upper.first, upper.second) + ".");
    }



    void
    check_time(const TimeParameters &time)
    {
      const Entry smallest("Smallest step", time.smallest_step),
        initial("Initial step", time.initial_step),
        largest("Largest step", time.largest_step);
      check_order("Time", smallest, largest);
      if (time.control == StepSizeControl::constant)
        return;
      check_order("Time", smallest, initial);
      check_order("Time", initial, largest);
    }



    void
    check_output(const OutputParameters &output, const Inertia inertia)
    {
      for (const auto &[name, cadence] :
           {std::make_pair(std::string("Fault"), output.fault_cadence),
            std::make_pair(std::string("Station"), output.station_cadence),
            std::make_pair(std::string("Volume"), output.volume_cadence)})
        check_order("Output",
                    {name + " shortest interval", cadence.shortest_interval},
                    {name + " longest interval", cadence.longest_interval});
      if (output.write_volume && inertia != Inertia::dynamic &&
          has_field(output.volume_fields, VolumeField::acceleration))
        throw InputError("'Output/Volume fields' lists 'acceleration', which "
                         "there is for 'Time/Inertia' = 'dynamic' only.");
    }



    template <int dim>
    void
    check_stations(const SceneParameters<dim> &scene)
    {
      std::set<std::string> places, names;
      for (const std::string &fault : names_of(scene.faults))
        places.insert(fault);
      for (const std::string &body : names_of(scene.bodies))
        places.insert(body);
      for (const Station &station : scene.output.stations)
        {
          const std::string context =
            "'Output/Stations': '" + station.name + "' ";
          if (!names.insert(station.name).second)
            throw InputError(context +
                             "is listed twice; each may be listed once.");
          if (places.count(station.place) == 0)
            throw InputError(context + "is at '" + station.place +
                             "', which is neither a fault nor a body.");
          if (station.position.size() != dim)
            throw InputError(context + "has " +
                             std::to_string(station.position.size()) +
                             " coordinates, but the scene has " +
                             std::to_string(dim) + " axes.");
        }
    }



    /** Two bodies on the two sides of a fault. */
    template <int dim>
    void
    check_neighbours(const SceneParameters<dim> &scene,
                     const BodyParameters<dim>  &below,
                     const BodyParameters<dim>  &above)
    {
      if (below.geometry.rigid && above.geometry.rigid)
        throw InputError(naming("Bodies/" + above.name + "/Rigid", "true") +
                         ": '" + below.name +
                         "' below is rigid too; of two neighbours at least one "
                         "must deform.");
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        {
          const auto extent = [axis](const BodyParameters<dim> &body) {
            return std::make_pair(body.geometry.lateral_lower[axis],
                                  body.geometry.lateral_upper[axis]);
          };
          const auto range = [&extent](const BodyParameters<dim> &body) {
            return shortest_form(extent(body).first) + ", " +
                   shortest_form(extent(body).second);
          };
          const std::string entry =
            naming("Bodies/" + above.name + "/Lower and Upper lateral corner",
                   range(above)) +
            " along " + "xy"[axis];
          if (std::max(extent(below).first, extent(above).first) >=
              std::min(extent(below).second, extent(above).second))
            throw InputError(entry + ": must overlap those of '" + below.name +
                             "' below, '" + range(below) +
                             "', for there to be a fault between the two.");
          if (scene.periodic[axis] && extent(below) != extent(above))
            throw InputError(entry + ": must be those of '" + below.name +
                             "' below, '" + range(below) + "', since '" +
                             periodic_entry(axis) + "' = 'true'.");
        }
    }



    template <int dim>
    void
    check_bodies(const SceneParameters<dim> &scene)
    {
      const std::vector<BodyParameters<dim>> &bodies = scene.bodies;
      for (const BodyParameters<dim> &body : bodies)
        for (unsigned int axis = 0; axis + 1 < dim; ++axis)
          if (body.geometry.lateral_lower[axis] >=
              body.geometry.lateral_upper[axis])
            throw InputError(
              naming("Bodies/" + body.name + "/Lower lateral corner",
                     body.geometry.lateral_lower[axis]) +
              ": must be less than " +
              naming("Upper lateral corner",
                     body.geometry.lateral_upper[axis]) +
              " along " + "xy"[axis] + ".");

      check_thicknesses(scene);

      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const auto [below, above] = scene.below_and_above(f);
          for (const BodySide &lower : below)
            for (const BodySide &upper : above)
              check_neighbours(scene, bodies[lower.body], bodies[upper.body]);
        }
    }



    /** One of the bodies on the two sides of a fault must deform. */
    template <int dim>
    void
    check_rigid_bodies(const SceneParameters<dim> &scene)
    {
      for (const Fault &fault : scene.topology.faults())
        for (const BodySide &first : fault.sides[0])
          for (const BodySide &second : fault.sides[1])
            if (scene.bodies[first.body].geometry.rigid &&
                scene.bodies[second.body].geometry.rigid)
              throw InputError(
                naming("Bodies/" + scene.bodies[second.body].name + "/Rigid",
                       "true") +
                ": on the two sides of the fault '" + fault.name +
                "' at least one body must deform.");
    }



    /** Tetrahedra can be refined as a whole only. */
    void
    check_refinement(const SceneParameters<3> &scene)
    {
      const MeshAccuracy &wanted = scene.mesh_accuracy;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (scene.mesh->bodies[b].cells[0].vertices.size() != 4)
          continue;
        else if (wanted.relative_error > 0. || !wanted.refined_cells.empty())
          throw InputError(naming("Mesh/Accuracy", wanted.relative_error) +
                           ": must be 0, and no refined cells be given, since "
                           "tetrahedra are refined all over only.");
        else if (scene.bodies[b].geometry.refinement_passes > 0)
          throw InputError(
            naming("Bodies/" + scene.bodies[b].name + "/Refinement passes",
                   scene.bodies[b].geometry.refinement_passes) +
            ": must be 0, since tetrahedra are refined all over only; those at "
            "the faults must be small in the mesh file.");
    }



    // Fields are checked again wherever they are needed; this comes before the
    // meshes are made.
    template <int dim>
    void
    check_materials(const SceneParameters<dim> &scene)
    {
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          const auto material =
            scene.bodies[b].material.template function<dim>();
          for (const Point<dim> &point : body_points(scene, b))
            material(point);
        }
    }



    template <int dim>
    void
    check_faults(const SceneParameters<dim> &scene)
    {
      for (unsigned int i = 0; i < scene.faults.size(); ++i)
        {
          const FaultParameters &fault  = scene.faults[i];
          const auto             points = fault_points(scene, i);
          if (scene.mesh != nullptr &&
              fault.normal_stress_source == NormalStressSource::lithostatic)
            throw InputError(
              naming(fault.section() + "/Normal stress", "lithostatic") +
              ": is for bricks in a stack only, since bodies of any shape have no "
              "thickness.");
          if (scene.topology.faults()[i].may_be_apart && !fault.may_open())
            throw InputError(
              naming(fault.section() + "/Initial gap from mesh", "true") +
              ": needs 'Contact' = 'unilateral', since sides that always touch "
              "cannot be apart.");
          for (const FaultPart &part : fault.parts(points))
            part.friction->check(part.select(points), part.section);
          if (fault.normal_stress_source == NormalStressSource::function)
            fault.normal_stress.values(points, fault.section());
          fault.background_stress.values(points, fault.section());
        }
    }



    /** Step doubling compares states, so some part of a fault must have one. */
    template <int dim>
    void
    check_doubling(const SceneParameters<dim> &scene)
    {
      if (scene.time.control != StepSizeControl::step_doubling ||
          scene.faults.empty())
        return;
      for (const FaultParameters &fault : scene.faults)
        if (fault.has_state() ||
            std::any_of(fault.regions.begin(),
                        fault.regions.end(),
                        [](const FrictionRegion &region) {
                          return region.friction.has_state();
                        }))
          return;
      std::vector<std::string> with_state;
      for (const LawKind &kind : law_registry().kinds())
        if (kind.has_state)
          with_state.push_back("'" + kind.name + "'");
      throw InputError(
        naming("Time/Step size control", "step doubling") +
        ": compares the states of two small steps and a large one, and no fault "
        "has 'Friction' = " +
        join_names(with_state, " or ") + "; choose embedded or constant.");
    }



    /** Explicit steps need slip rates that follow from the forces alone, or
     * from these and the mass of nodes. */
    template <int dim>
    void
    check_explicit(const SceneParameters<dim> &scene)
    {
      const bool has_mass =
        scene.time.control == StepSizeControl::central_differences;
      if (!has_mass && scene.time.control != StepSizeControl::runge_kutta)
        return;
      const std::string entry =
        naming("Time/Step size control",
               has_mass ? "central differences" : "Runge-Kutta");
      if (has_mass && scene.time.inertia != Inertia::dynamic)
        throw InputError(entry +
                         ": needs 'Time/Inertia' = 'dynamic', since the mass "
                         "of each node must tell its acceleration.");
      if (!has_mass && scene.time.inertia != Inertia::quasi_dynamic)
        throw InputError(entry +
                         ": needs 'Time/Inertia' = 'quasi-dynamic', since slip "
                         "rates must follow from the forces of each moment.");
      for (const FaultParameters &fault : scene.faults)
        {
          if (fault.may_open())
            throw InputError(entry + ": is for faults that do not open, but '" +
                             fault.section() + "/Contact' = 'unilateral'.");
          if (has_mass && fault.normal_stress_follows)
            throw InputError(
              entry + ": is for normal stresses that stay as they are, but '" +
              fault.section() + "/Normal stress follows' = 'true'.");
        }
    }



    /** Antiplane scenes have no displacements in the plane. */
    template <int dim>
    void
    check_antiplane(const SceneParameters<dim> &scene)
    {
      if (scene.deformation != Deformation::antiplane)
        return;
      const auto refuse = [](const std::string &path,
                             const std::string &value,
                             const std::string &reason) {
        throw InputError(naming(path, value) + ": " + reason +
                         " with 'Deformation' = 'antiplane'.");
      };
      if (dim == 3)
        throw InputError(naming("Deformation", "antiplane") +
                         ": is for two dimensions, but 'Dimension' = '3'.");
      for (const FaultParameters &fault : scene.faults)
        {
          if (fault.may_open())
            refuse(fault.section() + "/Contact",
                   "unilateral",
                   "faults cannot open");
          if (fault.normal_stress_follows)
            refuse(fault.section() + "/Normal stress follows",
                   "true",
                   "slip does not change the normal stress");
          if (fault.background_stress.is_given())
            throw InputError("'" + fault.section() +
                             "/Background stress': is in the plane; give "
                             "'Normal stress' and 'Initial shear stress' with "
                             "'Deformation' = 'antiplane'.");
          if (fault.normal_stress_source ==
              NormalStressSource::initial_equilibrium)
            refuse(fault.section() + "/Normal stress",
                   "initial equilibrium",
                   "there is no contact pressure, so that it must be function "
                   "or lithostatic");
        }
      for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
        if (condition.axes == BoundaryAxes::side)
          refuse("Boundary conditions/" + condition.body + " " +
                   condition.side_name + "/Axes",
                 "side",
                 "there is one axis, z,");
    }



  } // namespace



  template <int dim>
  void
  check_scene(const SceneParameters<dim> &scene)
  {
    if (scene.mesh == nullptr)
      {
        check_bodies(scene);
      }
    else
      {
        check_rigid_bodies(scene);
        if constexpr (dim == 3)
          check_refinement(scene);
      }
    check_materials(scene);
    check_faults(scene);
    check_antiplane(scene);
    check_doubling(scene);
    check_explicit(scene);
    check_boundary_conditions(scene);
    check_stations(scene);

    if (!scene.faults.empty() && scene.output.event_start_slip_rate == 0 &&
        event_start_slip_rate(scene) == 0)
      throw InputError(
        "'Output/Event start slip rate' = '0': stands for twice the largest "
        "prescribed velocity, which is 0 in this scene; give a slip rate > 0 "
        "m/s.");
  }



  template <int dim>
  void
  check_limits(const SceneParameters<dim> &scene)
  {
    check_time(scene.time);
    check_output(scene.output, scene.time.inertia);
  }



  template <int dim>
  void
  check_process_count(const SceneParameters<dim> &scene,
                      const unsigned int          n_processes)
  {
    if (n_processes == 1)
      return;
    const std::string ending = ": runs on one process only, but there are " +
                               std::to_string(n_processes) + ".";
    if (scene.time.rate_solver == RateSolver::condensed_newton)
      throw InputError(naming("Time/Rate solver", "condensed Newton") + ending);
    const std::map<LinearCorrectionType, std::string> names = {
      {LinearCorrectionType::umfpack, "UMFPACK"},
      {LinearCorrectionType::mumps, "MUMPS"}};
    const auto serial = names.find(scene.tnnmg.linear_correction);
    if (serial != names.end())
      throw InputError(naming("TNNMG/Linear correction", serial->second) +
                       ending);
  }



  template decltype(check_scene<2>)         check_scene<2>;
  template decltype(check_scene<3>)         check_scene<3>;
  template decltype(check_limits<2>)        check_limits<2>;
  template decltype(check_limits<3>)        check_limits<3>;
  template decltype(check_process_count<2>) check_process_count<2>;
  template decltype(check_process_count<3>) check_process_count<3>;
} // namespace StickSlip
