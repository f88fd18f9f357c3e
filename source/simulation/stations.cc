// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <boost/serialization/map.hpp>

#include <stickslip/base/input_error.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/geometry/place_finder.h>
#include <stickslip/parameters/name_list.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/simulation/stations.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    Point<dim>
    point_of(const Station &station)
    {
      Point<dim> point;
      std::copy_n(station.position.begin(), dim, point.begin_raw());
      return point;
    }



    /** Refuse a place that is not the point of the station itself. */
    template <typename Place>
    void
    refuse_outside(const Station     &station,
                   const std::string &what,
                   const Place       &place)
    {
      // Faces are chords of curved faults.
      constexpr double allowed_part = 0.01;
      if (place.distance <= allowed_part * place.size)
        return;
      std::vector<std::string> coordinates;
      for (const double x : station.position)
        coordinates.push_back(shortest_form(x));
      throw InputError("'Output/Stations': '" + station.name + "' at (" +
                       join_names(coordinates) + ") m is outside of the " +
                       what + " '" + station.place + "', " +
                       shortest_form(place.distance) + " m from it.");
    }



    double
    log10_of(const double value)
    {
      return std::log10(
        std::max(std::abs(value), std::numeric_limits<double>::min()));
    }



    /** Titles of the components of a vector: those of one that has only one are
     * without a number. */
    void
    add_components(TableColumns      &columns,
                   const std::string &title,
                   const unsigned int n,
                   const unsigned int first,
                   const std::string &unit,
                   const std::string &meaning)
    {
      for (unsigned int c = 0; c < n; ++c)
        if (n == 1)
          columns.push_back({title, unit, meaning});
        else
          {
            const std::string number = std::to_string(first + c);
            columns.push_back(
              {title + "_" + number, unit, meaning + " " + number});
          }
    }



    /** A place in a body: values of nodes' basis functions there by global
     * numbers; m. */
    struct BodyPlace
    {
      std::map<types::global_dof_index, double> values;
      double                                    distance = 0., size = 0.;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &values &distance &size;
      }
    };



    /** The place of a point in the cells of all processes, or the one next to
     * it. Collective. */
    template <int dim>
    BodyPlace
    nearest_place(const MeshLevel<dim> &level,
                  const unsigned int    body,
                  const Point<dim>     &point)
    {
      const BodyMesh<dim> &mesh = *level.bodies[body];
      const auto found = PlaceFinder<dim>(mesh.triangulation()).find(point);

      const std::vector<types::global_dof_index> dofs = mesh.dofs_of_vertices();
      BodyPlace                                  place;
      for (const auto &[vertex, value] : found.values)
        for (const auto &[node, factor] : level.resolve(body, dofs[vertex]))
          place.values[node] += factor * value;
      place.distance = found.distance;
      place.size     = found.size;

      const std::vector<BodyPlace> places =
        Utilities::MPI::all_gather(level.nodes.communicator(), place);
      return *std::min_element(places.begin(),
                               places.end(),
                               [](const auto &a, const auto &b) {
                                 return a.distance < b.distance;
                               });
    }



    template <int dim>
    TableColumns
    fault_columns(const bool with_normal_stress)
    {
      TableColumns columns;
      add_components(columns, "slip", dim - 1, 2, "m", "Slip");
      add_components(
        columns, "slip_rate", dim - 1, 2, "log10 m/s", "Slip rate");
      add_components(
        columns, "shear_stress", dim - 1, 2, "MPa", "Shear stress");
      if (with_normal_stress)
        columns.push_back({"normal_stress", "MPa", "Normal stress"});
      columns.push_back({"state", "log10 s", "State"});
      return columns;
    }
  } // namespace



  template <int dim>
  Stations<dim>::Stations(const SceneParameters<dim> &scene,
                          const MeshLevel<dim>       &level,
                          const JumpBasis<dim>       &basis)
    : n_components(scene.n_components())
  {
    const std::vector<std::string> faults = names_of(scene.faults),
                                   bodies = names_of(scene.bodies);
    for (const Station &station : scene.output.stations)
      {
        const auto fault =
          std::find(faults.begin(), faults.end(), station.place);
        if (fault != faults.end())
          {
            const unsigned int f = fault - faults.begin();
            add_on_fault(station,
                         f,
                         scene.faults[f].normal_stress_follows,
                         basis);
          }
        else
          add_in_body(station,
                      std::find(bodies.begin(), bodies.end(), station.place) -
                        bodies.begin(),
                      level);
      }
  }



  template <int dim>
  void
  Stations<dim>::add_on_fault(const Station        &station,
                              const unsigned int    fault,
                              const bool            with_normal_stress,
                              const JumpBasis<dim> &basis)
  {
    const FaultSurface<dim> &surface = basis.faults()[fault].slave;
    std::vector<std::vector<unsigned int>> faces;
    for (unsigned int face = 0; face < surface.faces.size(); ++face)
      {
        // Faces across the end of a period are not where their nodes are.
        const bool wraps =
          !surface.wraps.empty() &&
          std::any_of(surface.wraps[face].begin(),
                      surface.wraps[face].end(),
                      [](const auto &periods) {
                        return std::any_of(periods.begin(),
                                           periods.end(),
                                           [](const int n) { return n != 0; });
                      });
        if (!wraps)
          faces.emplace_back(surface.faces[face].begin(),
                             surface.faces[face].begin() +
                               surface.n_vertices_of(face));
      }
    const auto place =
      PlaceFinder<dim>(faces, surface.points).find(point_of<dim>(station));
    refuse_outside(station, "fault", place);
    places.push_back({fault, place.values, with_normal_stress});
    headers.push_back(
      {station, true, place.size, fault_columns<dim>(with_normal_stress)});
  }



  template <int dim>
  void
  Stations<dim>::add_in_body(const Station        &station,
                             const unsigned int    body,
                             const MeshLevel<dim> &level)
  {
    const BodyPlace place = nearest_place(level, body, point_of<dim>(station));
    refuse_outside(station, "body", place);

    for (unsigned int c = 0; c < n_components; ++c)
      {
        of_bodies.emplace_back();
        for (const auto &[node, value] : place.values)
          if (level.nodes.owned().is_element(node))
            of_bodies.back().emplace_back(
              level.nodes.local_index(node) * n_components + c, value);
      }

    TableColumns columns;
    add_components(columns, "disp", n_components, 1, "m", "Displacement");
    add_components(columns, "vel", n_components, 1, "m/s", "Velocity");
    headers.push_back({station, false, place.size, columns});
  }



  template <int dim>
  std::vector<double>
  Stations<dim>::fault_values(const Place              &place,
                              const FaultSnapshot<dim> &fault) const
  {
    Tensor<1, dim - 1> slip, rate, traction;
    double             normal_stress = 0., log_state = 0.;
    for (const auto &[node, value] : place.nodes)
      {
        slip += value * fault.slip[node];
        rate += value * fault.slip_rate[node];
        traction += value * fault.shear_traction[node];
        normal_stress += value * fault.normal_stress[node];
        log_state += value * log10_of(fault.state[node]);
      }
    std::vector<double> result;
    for (unsigned int c = 0; c < dim - 1; ++c)
      result.push_back(slip[c]);
    for (unsigned int c = 0; c < dim - 1; ++c)
      result.push_back(log10_of(rate[c]));
    for (unsigned int c = 0; c < dim - 1; ++c)
      result.push_back(1e-6 * traction[c]);
    if (place.with_normal_stress)
      result.push_back(1e-6 * normal_stress);
    result.push_back(log_state);
    return result;
  }



  template <int dim>
  std::vector<std::vector<double>>
  Stations<dim>::values(const std::vector<FaultSnapshot<dim>> &faults,
                        const FunctionalValues                &in_bodies) const
  {
    AssertDimension(in_bodies.of_displacement.size(), of_bodies.size());
    std::vector<std::vector<double>> result;
    auto                             place = places.begin();
    unsigned int                     next  = 0;
    for (const StationTable &station : headers)
      if (station.is_on_fault)
        {
          result.push_back(fault_values(*place, faults[place->number]));
          ++place;
        }
      else
        {
          result.emplace_back();
          for (const auto *field :
               {&in_bodies.of_displacement, &in_bodies.of_velocity})
            result.back().insert(result.back().end(),
                                 field->begin() + next,
                                 field->begin() + next + n_components);
          next += n_components;
        }
    return result;
  }



  template class Stations<2>;
  template class Stations<3>;
} // namespace StickSlip
