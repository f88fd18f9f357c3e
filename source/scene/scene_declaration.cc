// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_declaration.h>

namespace StickSlip
{
  template <int dim>
  void
  declare_body(ParameterHandler &prm, BodyParameters<dim> &body)
  {
    prm.enter_subsection("Bodies");
    prm.enter_subsection(body.name);
    body.geometry.section = body.section();
    body.geometry.add_parameters(prm);
    body.block.add_parameters(prm, dim);
    prm.enter_subsection("Material");
    body.material.section = body.section() + "/Material";
    body.material.add_parameters(prm);
    prm.leave_subsection();
    prm.leave_subsection();
    prm.leave_subsection();
  }



  namespace
  {
    template <int dim>
    void
    declare_bodies(ParameterHandler &prm, SceneParameters<dim> &scene)
    {
      prm.enter_subsection("Bodies");
      prm.declare_entry(
        "Names",
        join_names(names_of(scene.bodies)),
        NameList(),
        "Names of the bodies: from bottom to top, or blocks, or "
        "those in the mesh files. Each has a subsection of its "
        "name.");
      add_text(prm,
               "Mesh file",
               scene.mesh_entries.files,
               "Names of mesh files of Gmsh, of versions 2.2 or 4.1, separated "
               "by commas, next to the parameter file unless a path is given; "
               "empty for bodies that are bricks in a stack. Physical groups "
               "of volumes (in two dimensions, of surfaces) are the bodies of "
               "the same names, those of surfaces (of lines) their sides and "
               "the faults. Bodies are cut open along the faults.");
      add_text(
        prm,
        "Coarser mesh files",
        scene.mesh_entries.coarser_files,
        "Names of mesh files of the same bodies and faults with fewer "
        "cells, finest first, separated by commas; files of one mesh are "
        "joined by a plus sign. They are levels of the multigrid method "
        "below the unrefined mesh, and need not be nested. They pay "
        "where that has more than 40000 unknowns in two dimensions or "
        "10000 in three. Empty: none.");
      add_number(prm,
                 "Length unit",
                 scene.mesh_entries.length_unit,
                 NumberRange().above(0).in("m"),
                 "Unit of length in the mesh files, in m.");
      add_number(prm,
                 "Base elevation",
                 scene.bodies.front().geometry.base,
                 NumberRange().in("m"),
                 "Elevation of the lower side of the lowest body, in m.");
      prm.leave_subsection();
      for (BodyParameters<dim> &body : scene.bodies)
        declare_body(prm, body);
    }



    template <int dim>
    void
    declare_faults(ParameterHandler &prm, SceneParameters<dim> &scene)
    {
      prm.enter_subsection("Faults");
      prm.declare_entry(
        "Names",
        join_names(names_of(scene.faults)),
        NameList(),
        "Names of the faults from bottom to top, one between "
        "each two neighbouring bodies; empty for a single "
        "body. With blocks or mesh files, any faults. Each has a "
        "subsection of its name.");
      scene.mesh_entries.faults.resize(scene.faults.size());
      scene.fault_geometries.resize(scene.faults.size());
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          prm.enter_subsection(scene.faults[f].name);
          scene.faults[f].add_parameters(prm, dim);
          MeshEntries::OfFault &entries = scene.mesh_entries.faults[f];
          add_text(prm,
                   "Mesh group",
                   entries.group,
                   "The physical group of its faces in the mesh files; empty: "
                   "that of the fault's name.");
          add_text(prm,
                   "Between",
                   entries.between,
                   "With mesh files, the bodies on both sides of the fault, "
                   "separated by a comma: slip is the motion of the second "
                   "relative to the first, and the normal points to the "
                   "second. Empty: the body listed first in 'Bodies/Names' is "
                   "first; where a body is on both sides, the normal points "
                   "upwards. Sides with nodes of their own, whose meshes need "
                   "not match, and those of blocks, are given as '<body> "
                   "<side>', several of them joined by a plus sign: 'lower "
                   "top, left bottom + right bottom'.");
          add_switch(prm,
                     "Initial gap from mesh",
                     entries.may_be_apart,
                     "Whether the sides that 'Between' names may be apart in "
                     "the mesh files or blocks, by less than a face is large; "
                     "with 'Contact = unilateral' that distance along the "
                     "normal is the gap at the start, with what 'Initial gap' "
                     "says.");
          scene.fault_geometries[f].section = scene.faults[f].section();
          scene.fault_geometries[f].add_parameters(prm);
          if (dim == 3)
            add_numbers(
              prm,
              "Strike",
              entries.strike,
              NumberRange(),
              "Direction of the first component of slip and traction "
              "on a fault in mesh files, of any length: it is "
              "projected onto the fault at each node, and must be at "
              "least 15 degrees off its normal; the second component "
              "is along normal times first. 0, 0, 0: the x axis, or, "
              "where the fault comes within 15 degrees of being "
              "normal to that, its mean horizontal direction, towards "
              "positive y.");
          prm.leave_subsection();
        }
      prm.leave_subsection();
    }



    template <int dim>
    void
    declare_boundary_conditions(ParameterHandler     &prm,
                                SceneParameters<dim> &scene)
    {
      std::vector<std::string> sides;
      for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
        sides.push_back(condition.body + " " + condition.side_name);

      prm.enter_subsection("Boundary conditions");
      prm.declare_entry("Sides",
                        join_names(sides),
                        NameList(2),
                        "The sides that are not free, each as '<body> <side>', "
                        "where side is left, right, bottom or top and in three "
                        "dimensions also front or back, or with mesh files a "
                        "physical group. Each has a subsection of this "
                        "name.");
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        add_switch(prm,
                   std::string("Periodic along ") + "xy"[axis],
                   scene.periodic[axis],
                   "Whether bodies and faults have no ends along this axis: "
                   "the two sides of each body are joined, all fields repeat "
                   "after the extent of the bodies, which must be the same for "
                   "all, and what slides out on one side comes back on the "
                   "other.");
      for (unsigned int i = 0; i < sides.size(); ++i)
        {
          prm.enter_subsection(sides[i]);
          scene.boundary_conditions[i].add_parameters(prm);
          prm.leave_subsection();
        }
      prm.leave_subsection();
    }



    // The solver itself knows nothing of parameter files.
    void
    declare_solver_entries(ParameterHandler &prm, TNNMGParameters &parameters)
    {
      add_number(
        prm,
        "Tolerance",
        parameters.tolerance,
        NumberRange().above(0).below(1),
        "The iteration ends when the error, estimated from the last two "
        "corrections, is below this times the iterate, both in the "
        "energy norm, without unit. A third of Time/Tolerance adds "
        "nothing to the error of the time steps.");
      add_count(prm,
                "Largest number of iterations",
                parameters.max_iterations,
                1,
                100000,
                "More iterations than this are a failure.");
      add_number(prm,
                 "Truncation factor",
                 parameters.truncation_factor,
                 NumberRange().above(0),
                 "A node is left out of the linear correction where the least "
                 "curvature of its friction exceeds this times the diagonal of "
                 "the matrix, without unit.");
      add_choice(
        prm,
        "Linear correction",
        parameters.linear_correction,
        {{LinearCorrectionType::multigrid, "multigrid"},
         {LinearCorrectionType::umfpack, "UMFPACK"},
         {LinearCorrectionType::mumps, "MUMPS"}},
        "How the linearised problem of an iteration is solved: by some "
        "steps of conjugate gradients with the geometric multigrid "
        "method (multigrid, recommended), or exactly, by sparse "
        "factorisation with UMFPACK or MUMPS, for small problems and "
        "comparisons. UMFPACK and MUMPS run on one process only.");
      add_count(
        prm,
        "Cycles per correction",
        parameters.cycles_per_correction,
        1,
        1000,
        "Steps of conjugate gradients, each with one multigrid V-cycle, "
        "in a linear correction after the first ones; more where that "
        "reduces the residual too little.");
      add_number(prm,
                 "Linear reduction",
                 parameters.linear_reduction,
                 NumberRange().above(0).at_most(1),
                 "Corrections of more than one V-cycle take more steps, up to "
                 "a hundred, until the residual of the linear problem is "
                 "expected to be below this times the initial one, in the norm "
                 "of the preconditioner, without unit; 1: never more.");
      add_count(
        prm,
        "Single-cycle corrections",
        parameters.single_cycle_corrections,
        0,
        1000,
        "So many corrections of each problem take one multigrid V-cycle "
        "only: a time step, which begins at its prediction, hardly needs "
        "more, and from far away the first ones need not be exact.");
      add_number(prm,
                 "Smoothing sweeps",
                 parameters.smoothing_sweeps,
                 NumberRange().whole().at_least(1).at_most(100),
                 "Gauss-Seidel sweeps before and after each coarse grid "
                 "correction; auto: 2 where a fault may open or a body is "
                 "of tetrahedra, else 1.");
      add_number(prm,
                 "Coarse update threshold",
                 parameters.coarse_update_threshold,
                 NumberRange().at_least(0),
                 "The coarse levels, which only precondition, are given the "
                 "curvature of the friction anew where it has changed by more "
                 "than this fraction since the last time, without unit; 0: in "
                 "every iteration.");
      add_choice(
        prm,
        "Cycle precision",
        parameters.cycle_precision,
        {{CyclePrecision::single_precision, "single"},
         {CyclePrecision::double_precision, "double"}},
        "The precision of matrices and vectors in the multigrid cycles, "
        "which only precondition; the solution is in double precision "
        "either way. Single precision is faster and takes as many "
        "iterations; double precision is for bodies whose stiffness "
        "differs by many orders of magnitude.");
      add_choice(prm,
                 "Coarse solver",
                 parameters.coarse_solver,
                 {{CoarseSolverType::direct, "direct"},
                  {CoarseSolverType::amg, "AMG"}},
                 "How the coarsest level, which belongs to one process, is "
                 "solved: by factorisation (direct), or, for coarse meshes of "
                 "many thousand cells in three dimensions, by two cycles of "
                 "algebraic multigrid (AMG).");
      add_switch(prm,
                 "Print iterations",
                 parameters.print_iterations,
                 "Whether a line is printed for every iteration.");
    }



    template <typename Parameters>
    void
    declare_section(ParameterHandler  &prm,
                    const std::string &name,
                    Parameters        &parameters)
    {
      prm.enter_subsection(name);
      parameters.add_parameters(prm);
      prm.leave_subsection();
    }
  } // namespace



  template <int dim>
  void
  declare_scene(ParameterHandler &prm, SceneParameters<dim> &scene)
  {
    Assert(!scene.bodies.empty(), ExcMessage("A scene needs a body."));

    prm.declare_entry("Dimension",
                      std::to_string(dim),
                      NumberRange().whole().at_least(2).at_most(3),
                      "Dimension of space: 2 or 3. The last axis is "
                      "vertical.");
    add_choice(prm,
               "Deformation",
               scene.deformation,
               {{Deformation::plane_strain, "plane strain"},
                {Deformation::antiplane, "antiplane"}},
               "In two dimensions: displacements in the plane (plane strain), "
               "or out of it only (antiplane), along z, as of a strike-slip "
               "fault whose slip does not depend on z. Then conditions on "
               "sides are 'z condition' and 'z value', what entries of faults "
               "say of the x axis holds for z, contact is bilateral, and the "
               "normal stress is given.");
    declare_bodies(prm, scene);
    declare_section(prm, "Mesh", scene.mesh_accuracy);
    declare_faults(prm, scene);
    declare_boundary_conditions(prm, scene);

    prm.enter_subsection("Gravity");
    add_number(prm,
               "Acceleration",
               scene.gravity,
               NumberRange().at_least(0).in("m/s^2"),
               "Acceleration of gravity, downwards, in m/s^2.");
    add_number(
      prm,
      "Dip",
      scene.dip,
      NumberRange().above(-90).below(90).in("degrees"),
      "Angle by which the faults dip towards positive x, in degrees. "
      "The axes of the scene stay along the faults: gravity has a part "
      "g sin(dip) along x, and g cos(dip) presses the bodies "
      "together.");
    prm.leave_subsection();

    declare_section(prm, "Contact", scene.contact);
    prm.enter_subsection("TNNMG");
    declare_solver_entries(prm, scene.tnnmg);
    prm.leave_subsection();
    declare_section(prm, "Time", scene.time);
    declare_section(prm, "Output", scene.output);
  }



  namespace
  {
    /** A function that has the same values at both ends of a periodic body. */
    template <int dim>
    std::function<double(const Point<dim> &)>
    periodic_function(const std::function<double(const Point<dim> &)> &function,
                      const BodyGeometry<dim>                         &body)
    {
      if (body.period().norm() == 0.)
        return function;
      return [function, period = body.period(), lower = body.lateral_lower](
               Point<dim> point) {
        for (unsigned int axis = 0; axis + 1 < dim; ++axis)
          if (point[axis] > lower[axis] + (1. - 1e-10) * period[axis] &&
              period[axis] > 0.)
            point[axis] = lower[axis];
        return function(point);
      };
    }
  } // namespace



  template <int dim>
  void
  complete_geometry(SceneParameters<dim> &scene)
  {
    if (scene.mesh != nullptr)
      {
        for (unsigned int f = 0; f < scene.faults.size(); ++f)
          scene.topology.set_strike(f, scene.mesh_entries.faults[f].strike);
        return;
      }
    for (unsigned int i = 1; i < scene.bodies.size(); ++i)
      scene.bodies[i].geometry.base = scene.bodies[i - 1].geometry.base +
                                      scene.bodies[i - 1].geometry.thickness;
    for (BodyParameters<dim> &body : scene.bodies)
      body.geometry.periodic = scene.periodic;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        if (scene.fault_geometries[f].is_level())
          continue;
        const auto [below, above] = scene.below_and_above(f);
        BodyGeometry<dim> &lower  = scene.bodies[below[0].body].geometry;
        BodyGeometry<dim> &upper  = scene.bodies[above[0].body].geometry;
        lower.upper_elevation = upper.lower_elevation = periodic_function<dim>(
          scene.fault_geometries[f].template elevation_function<dim>(), lower);
      }
  }



  template decltype(declare_body<2>)      declare_body<2>;
  template decltype(declare_body<3>)      declare_body<3>;
  template decltype(declare_scene<2>)     declare_scene<2>;
  template decltype(declare_scene<3>)     declare_scene<3>;
  template decltype(complete_geometry<2>) complete_geometry<2>;
  template decltype(complete_geometry<3>) complete_geometry<3>;
} // namespace StickSlip
