// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/crosspoints.h>
#include <stickslip/mortar/fault_sides.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  template <int dim>
  std::pair<double, double>
  face_sizes(const FaultSurface<dim> &surface)
  {
    double sum = 0, least = std::numeric_limits<double>::max();
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      {
        const double size = surface.face_size(f);
        sum += size;
        least = std::min(least, size);
      }
    return {sum / surface.faces.size(), least};
  }



  template <int dim>
  FaultSides
  choose_fault_sides(const MeshLevel<dim> &level,
                     const FaultTopology  &topology,
                     const unsigned int    fault,
                     const double          stiffness_ratio)
  {
    const auto is_rigid = [&](const unsigned int side) {
      const std::vector<BodySide> &parts = topology.faults()[fault].sides[side];
      return std::all_of(parts.begin(), parts.end(), [&](const BodySide &part) {
        return level.bodies[part.body]->is_rigid();
      });
    };
    const std::vector<types::global_dof_index> crossings =
      crosspoints(level, topology.faults().size());
    const auto n_crossings = [&](const unsigned int side) {
      const auto &nodes = level.surface(fault, side).nodes;
      return std::count_if(nodes.begin(), nodes.end(), [&](const auto node) {
        return std::binary_search(crossings.begin(), crossings.end(), node);
      });
    };
    const double first_size  = face_sizes(level.surface(fault, 0)).first;
    const double second_size = face_sizes(level.surface(fault, 1)).first;
    // Equal numbers differ by rounding.
    const auto is_less = [](const double a, const double b) {
      return a < (1. - 1e-8) * b;
    };
    const bool first_is_slave =
      is_rigid(1)                      ? true :
      is_rigid(0)                      ? false :
      n_crossings(0) > n_crossings(1)  ? true :
      n_crossings(1) > n_crossings(0)  ? false :
      stiffness_ratio > 4.             ? true :
      stiffness_ratio < 0.25           ? false :
      is_less(first_size, second_size) ? true :
      is_less(second_size, first_size) ? false :
                                         is_less(1., stiffness_ratio);
    if (first_is_slave)
      return {0, 1};
    return {1, 0};
  }



#define STICKSLIP_INSTANTIATE(dim)                                    \
  template FaultSides choose_fault_sides<dim>(const MeshLevel<dim> &, \
                                              const FaultTopology &,  \
                                              const unsigned int,     \
                                              const double);          \
  template std::pair<double, double> face_sizes<dim>(const FaultSurface<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
