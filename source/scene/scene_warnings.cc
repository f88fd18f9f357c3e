// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/bounding_box.h>

#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/scene/scene_warnings.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace StickSlip
{
  namespace
  {
    // Cells in space that are so much longer along one axis than along both
    // others take many iterations; other flat and tall ones do not.
    constexpr double largest_aspect_ratio = 10.;

    constexpr double nearly_incompressible = 0.45;

    // At this distance of held sides, in lengths of the fault, the first event
    // of doc/seas.md comes a percent early.
    constexpr double wanted_lengths = 5.;

    constexpr double many_steps = 1e6, many_records = 1e5, many_sets = 1e4;



    std::string
    in_quotes(const std::string &text)
    {
      return "'" + text + "'";
    }



    /** A point of a triangle or quadrilateral, or of a line, given by two
     * numbers from zero to one. */
    template <int dim>
    Point<dim>
    point_of_face(const std::vector<Point<dim>> &v,
                  const double                   s,
                  const double                   t)
    {
      Tensor<1, dim> p;
      if (v.size() == 2)
        p = (1. - s) * v[0] + s * Tensor<1, dim>(v[1]);
      else if (v.size() == 3)
        p = (1. - s) * v[0] +
            s * ((1. - t) * Tensor<1, dim>(v[1]) + t * Tensor<1, dim>(v[2]));
      else
        p = (1. - t) *
              ((1. - s) * Tensor<1, dim>(v[0]) + s * Tensor<1, dim>(v[1])) +
            t * ((1. - s) * Tensor<1, dim>(v[2]) + s * Tensor<1, dim>(v[3]));
      return Point<dim>(p);
    }



    const std::vector<CellData<1>> &
    boundary_faces(const BodyCells<2> &body)
    {
      return body.boundary.boundary_lines;
    }



    const std::vector<CellData<2>> &
    boundary_faces(const BodyCells<3> &body)
    {
      return body.boundary.boundary_quads;
    }



    /** Points of a fault, about as many as its nodes. */
    template <int dim>
    std::vector<Point<dim>>
    points_like_nodes(const SceneParameters<dim> &scene,
                      const unsigned int          f,
                      const double                n_faces)
    {
      const double most = dim == 2 ? 4096. : 128.,
                   along =
                     dim == 2 ? n_faces : std::sqrt(std::max(n_faces, 1.));
      if (scene.mesh == nullptr)
        return fault_points(scene,
                            f,
                            static_cast<unsigned int>(
                              std::clamp(std::ceil(along), 20., most)));
      std::vector<Point<dim>> points;
      for (const BodySide &part : scene.topology.faults()[f].sides[0])
        {
          const BodyCells<dim> &body    = scene.mesh->bodies[part.body];
          const auto           &faces   = boundary_faces(body);
          const auto            is_here = [&](const auto &face) {
            return face.boundary_id == part.side;
          };
          const double coarse =
            std::count_if(faces.begin(), faces.end(), is_here);
          if (coarse == 0.)
            continue;
          const unsigned int n = static_cast<unsigned int>(std::clamp(
            std::ceil(std::pow(n_faces / coarse, 1. / (dim - 1))), 1., 64.));
          for (const auto &face : faces)
            if (is_here(face))
              {
                std::vector<Point<dim>> vertices;
                for (const unsigned int v : face.vertices)
                  vertices.push_back(body.vertices[v]);
                for (unsigned int i = 0; i <= n; ++i)
                  for (unsigned int j = 0; j <= (dim == 2 ? 0 : n); ++j)
                    points.push_back(point_of_face<dim>(vertices,
                                                        double(i) / n,
                                                        double(j) / n));
              }
        }
      return points;
    }



    /** Names of the entries other than 'Contact' that two say differently. */
    std::vector<std::string>
    different_entries(const OpeningParameters &a, const OpeningParameters &b)
    {
      std::vector<std::string> names;
      const auto add_if = [&names](const bool is_different, const char *name) {
        if (is_different)
          names.push_back(name);
      };
      add_if(a.tensile_strength.text() != b.tensile_strength.text(),
             "Tensile strength");
      add_if(a.cohesion.text() != b.cohesion.text(), "Cohesion");
      add_if(a.bond_healing_time != b.bond_healing_time, "Bond healing time");
      add_if(a.initial_gap.text() != b.initial_gap.text(), "Initial gap");
      add_if(a.open_state != b.open_state, "State while open");
      return names;
    }



    /** Entries on opening of a fault or region that keeps its sides together;
     * @p others are those that it has if nothing is said. */
    void
    warn_of_bilateral_part(const FrictionParameters &friction,
                           const OpeningParameters  &others,
                           const std::string        &section,
                           std::vector<std::string> &warnings)
    {
      for (const std::string &entry :
           different_entries(friction.opening, others))
        warnings.push_back(in_quotes(section + "/" + entry) +
                           ": has no effect, since 'Contact' is 'bilateral'.");
    }



    void
    warn_of_part_without_law(const FrictionParameters &friction,
                             const std::string        &section,
                             std::vector<std::string> &warnings)
    {
      warnings.push_back(
        in_quotes(section + "/Contact") +
        " = 'unilateral': has no effect, since a fault with 'Friction' = '" +
        friction.kind().name + "' does not open.");
    }



    /** Regions have the entries of their fault where they say nothing else. */
    void
    warn_of_openings(const FaultParameters    &fault,
                     std::vector<std::string> &warnings)
    {
      if (!fault.may_open())
        warn_of_bilateral_part(fault,
                               OpeningParameters(),
                               fault.section(),
                               warnings);
      else if (fault.opening.may_open() && fault.has_prescribed_slip() &&
               std::all_of(fault.regions.begin(),
                           fault.regions.end(),
                           [](const FrictionRegion &region) {
                             return region.friction.has_prescribed_slip();
                           }))
        warn_of_part_without_law(fault, fault.section(), warnings);

      for (const FrictionRegion &region : fault.regions)
        {
          const std::string section =
            fault.section() + "/Regions/" + region.name;
          if (!region.friction.opening.may_open())
            warn_of_bilateral_part(region.friction,
                                   fault.opening,
                                   section,
                                   warnings);
          else if (!fault.opening.may_open() &&
                   region.friction.has_prescribed_slip())
            warn_of_part_without_law(region.friction, section, warnings);
        }
    }



    template <int dim>
    double
    distance_from(const BoundingBox<dim> &box, const Point<dim> &point)
    {
      Tensor<1, dim> difference;
      for (unsigned int d = 0; d < dim; ++d)
        difference[d] = std::max(
          {box.lower_bound(d) - point[d], 0., point[d] - box.upper_bound(d)});
      return difference.norm();
    }



    /** Warn of held sides that are near to the part of a fault with friction,
     * where the fault slips at a known rate beyond that part, and its shear
     * stress at the start is not that of the bodies: it is one in a medium
     * without end then. */
    template <int dim>
    void
    warn_of_near_sides(const SceneParameters<dim>    &scene,
                       const FaultParameters         &fault,
                       const std::vector<Point<dim>> &points,
                       const std::vector<FaultPart>  &parts,
                       std::vector<std::string>      &warnings)
    {
      std::vector<Point<dim>> with_friction;
      bool                    goes_on = false;
      for (const FaultPart &part : parts)
        if (part.friction->has_prescribed_slip())
          goes_on |= !part.positions.empty();
        else
          for (const Point<dim> &point : part.select(points))
            with_friction.push_back(point);
      if (!goes_on || with_friction.empty() ||
          !fault.given_starts(with_friction, fault.section())
             .front()
             .shear_stress)
        return;
      const BoundingBox<dim> box(with_friction);
      const double           length = box.get_boundary_points().first.distance(
        box.get_boundary_points().second);
      for (const BoundaryCondition<dim> &side : scene.boundary_conditions)
        {
          if (std::none_of(side.type.begin(),
                           side.type.end(),
                           [](const auto t) {
                             return t == BoundaryType::fixed ||
                                    t == BoundaryType::velocity;
                           }))
            continue;
          double distance = std::numeric_limits<double>::max();
          for (const Point<dim> &point : side_points(scene, side))
            distance = std::min(distance, distance_from(box, point));
          if (distance < wanted_lengths * length)
            warnings.push_back(
              in_quotes(fault.section()) + ": the part with friction, " +
              shortest_form(length) + " m, is long for the box: '" + side.body +
              " " + side.side_name + "' is held " + shortest_form(distance) +
              " m from it, and should be " + shortest_form(wanted_lengths) +
              " lengths or more from it.");
        }
    }



    template <int dim>
    void
    warn_of_faults(const SceneParameters<dim> &scene,
                   const MeshEstimate         &meshes,
                   std::vector<std::string>   &warnings)
    {
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const FaultParameters &fault = scene.faults[f];
          warn_of_openings(fault, warnings);
          const std::vector<Point<dim>> points =
            points_like_nodes(scene, f, meshes.faults[f].faces);
          const std::vector<FaultPart> parts = fault.parts(points);
          for (const FaultPart &part : parts)
            {
              for (const std::string &entry :
                   part.friction->tables_elsewhere(points))
                warnings.push_back(
                  in_quotes(part.section + "/" + entry) +
                  ": the table has no values on the fault, which takes those at "
                  "the table's ends.");
              if (part.friction != &fault && part.positions.empty())
                warnings.push_back(
                  in_quotes(part.section + "/Where") +
                  ": the region has no node of the fault, or those that it has "
                  "are all in regions named later.");
            }
          warn_of_near_sides(scene, fault, points, parts, warnings);
          if (fault.normal_stress.is_table_elsewhere(points))
            warnings.push_back(
              in_quotes(fault.section() + "/Normal stress function") +
              ": the table has no values on the fault, which takes those at the "
              "table's ends.");
        }
    }



    /** The value that a side prescribes at a point and time; nothing if it
     * prescribes none. */
    template <int dim>
    std::optional<double>
    prescribed(const BoundaryCondition<dim> &condition,
               const unsigned int            component,
               const Point<dim>             &point,
               const double                  time)
    {
      if (condition.type[component] == BoundaryType::fixed)
        return 0.;
      if (condition.type[component] != BoundaryType::velocity)
        return {};
      return smooth_ramp(time, condition.ramp_length) *
             Expression<dim>(condition.expression[component], true)
               .value(point, time);
    }



    /** Corners that two sides of a body have, and at which they say different
     * things. */
    template <int dim>
    void
    warn_of_corners(const SceneParameters<dim> &scene,
                    std::vector<std::string>   &warnings)
    {
      const auto before = [](const Point<dim> &a, const Point<dim> &b) {
        return std::lexicographical_compare(a.begin_raw(),
                                            a.end_raw(),
                                            b.begin_raw(),
                                            b.end_raw());
      };
      const auto &sides = scene.boundary_conditions;
      for (unsigned int i = 0; i < sides.size(); ++i)
        for (unsigned int j = i + 1; j < sides.size(); ++j)
          {
            if (sides[i].body != sides[j].body ||
                sides[i].axes != BoundaryAxes::space ||
                sides[j].axes != BoundaryAxes::space)
              continue;
            std::vector<Point<dim>> one   = side_points(scene, sides[i]),
                                    other = side_points(scene, sides[j]),
                                    common;
            std::sort(one.begin(), one.end(), before);
            std::sort(other.begin(), other.end(), before);
            std::set_intersection(one.begin(),
                                  one.end(),
                                  other.begin(),
                                  other.end(),
                                  std::back_inserter(common),
                                  before);
            if (common.size() > 2)
              common = {common.front(), common.back()};
            bool is_found = false;
            for (const Point<dim> &point : common)
              for (unsigned int c = 0; c < dim && !is_found; ++c)
                {
                  const double time = scene.time.end_time;
                  const auto   a    = prescribed(sides[i], c, point, time),
                             b      = prescribed(sides[j], c, point, time);
                  if (!a || !b ||
                      std::abs(*a - *b) <=
                        1e-9 * std::max(std::abs(*a), std::abs(*b)))
                    continue;
                  is_found = true;
                  std::string place;
                  for (unsigned int d = 0; d < dim; ++d)
                    place += (d == 0 ? "" : ", ") + shortest_form(point[d]);
                  warnings.push_back(
                    "'Boundary conditions/Sides': '" + sides[i].body + " " +
                    sides[i].side_name + "' and '" + sides[j].body + " " +
                    sides[j].side_name +
                    "' prescribe different velocities along " + "xyz"[c] +
                    " at (" + place + ") m, " + shortest_form(*a) + " and " +
                    shortest_form(*b) + " m/s; the side listed last counts.");
                }
          }
    }



    template <int dim>
    void
    warn_of_bodies(const SceneParameters<dim> &scene,
                   const MeshEstimate         &meshes,
                   std::vector<std::string>   &warnings)
    {
      if (dim == 3 && meshes.aspect_ratio > largest_aspect_ratio)
        warnings.push_back(
          "'" + scene.bodies[meshes.stretched_body].section() +
          "': cells are up to " + rounded_count(meshes.aspect_ratio) +
          " times as long along one axis as along both others; from about ten "
          "on, steps take many more iterations.");
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          const BodyParameters<dim> &body = scene.bodies[b];
          if (body.geometry.rigid)
            continue;
          const auto material = body.material.template function<dim>();
          double     greatest = 0.;
          bool       is_full  = false;
          for (const Point<dim> &point : body_points(scene, b))
            {
              const Material values = material(point);
              greatest              = std::max(greatest, values.poissons_ratio);
              is_full |= values.volumetric_strain == VolumetricStrain::full;
            }
          if (greatest > nearly_incompressible && is_full)
            warnings.push_back(
              in_quotes(body.section() + "/Material/Poisson ratio") + " = '" +
              shortest_form(greatest) +
              "': cells are far too stiff in bending with 'Volumetric strain' = "
              "'full'; choose 'patch mean'.");
        }
    }
  } // namespace



  FewestOutputs::FewestOutputs(const TimeParameters   &time,
                               const OutputParameters &output)
    : steps(time.end_time / time.largest_step)
    , fault_records(output.write_faults ?
                      time.end_time /
                        std::max<double>(output.fault_cadence.longest_interval,
                                         time.largest_step) :
                      0.)
    , volume_sets(output.write_volume || output.write_fault_surfaces ?
                    time.end_time /
                      std::max<double>(output.volume_cadence.longest_interval,
                                       time.largest_step) :
                    0.)
  {}



  template <int dim>
  std::vector<std::string>
  scene_warnings(const SceneParameters<dim> &scene, const MeshEstimate &meshes)
  {
    std::vector<std::string> warnings;
    warn_of_faults(scene, meshes, warnings);
    warn_of_corners(scene, warnings);
    warn_of_bodies(scene, meshes, warnings);

    const FewestOutputs fewest(scene.time, scene.output);
    const auto          warn_if_many = [&](const std::string &entry,
                                  const double       value,
                                  const double       count,
                                  const double       many,
                                  const std::string &what) {
      if (count > many)
        warnings.push_back("'" + entry + "' = '" + shortest_form(value) +
                           "': means at least " + rounded_count(count) + ' ' +
                           what + '.');
    };
    warn_if_many("Time/Largest step",
                 scene.time.largest_step,
                 fewest.steps,
                 many_steps,
                 "steps up to 'End time'");
    warn_if_many("Output/Fault longest interval",
                 scene.output.fault_cadence.longest_interval,
                 fewest.fault_records,
                 many_records,
                 "records of the faults");
    warn_if_many("Output/Volume longest interval",
                 scene.output.volume_cadence.longest_interval,
                 fewest.volume_sets,
                 many_sets,
                 "sets of VTU files");
    return warnings;
  }



  template decltype(scene_warnings<2>) scene_warnings<2>;
  template decltype(scene_warnings<3>) scene_warnings<3>;
} // namespace StickSlip
