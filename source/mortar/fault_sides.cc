// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

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
                     const unsigned int    lower,
                     const double          stiffness_ratio)
  {
    constexpr auto top        = BodyMesh<dim>::upper_side;
    constexpr auto bottom     = BodyMesh<dim>::lower_side;
    const double   size_below = face_sizes(level.surface(lower, top)).first;
    const double   size_above =
      face_sizes(level.surface(lower + 1, bottom)).first;
    // Equal numbers differ by rounding.
    const auto is_less = [](const double a, const double b) {
      return a < (1. - 1e-8) * b;
    };
    const bool lower_is_slave =
      level.bodies[lower + 1]->is_rigid() ? true :
      level.bodies[lower]->is_rigid()     ? false :
      stiffness_ratio > 4.                ? true :
      stiffness_ratio < 0.25              ? false :
      is_less(size_below, size_above)     ? true :
      is_less(size_above, size_below)     ? false :
                                            is_less(1., stiffness_ratio);
    if (lower_is_slave)
      return {lower, lower + 1, top, bottom};
    return {lower + 1, lower, bottom, top};
  }



  template <int dim>
  std::vector<types::global_dof_index>
  surface_nodes(const MeshLevel<dim>    &level,
                const unsigned int       body,
                const types::boundary_id side)
  {
    std::vector<types::global_dof_index> nodes;
    for (const auto dof : level.surface(body, side).dofs)
      nodes.push_back(level.global_node(body, dof));
    return nodes;
  }



#define STICKSLIP_INSTANTIATE(dim)                                         \
  template FaultSides choose_fault_sides<dim>(const MeshLevel<dim> &,      \
                                              const unsigned int,          \
                                              const double);               \
  template std::vector<types::global_dof_index> surface_nodes<dim>(        \
    const MeshLevel<dim> &, const unsigned int, const types::boundary_id); \
  template std::pair<double, double> face_sizes<dim>(const FaultSurface<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
