// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_fault_sides_h
#define stickslip_mortar_fault_sides_h

#include <stickslip/mesh/mesh_level.h>

namespace StickSlip
{
  /**
   * Which side of a fault carries the multipliers and the jumps.
   */
  struct FaultSides
  {
    unsigned int       slave_body, master_body;
    types::boundary_id slave_side, master_side;

    bool
    slave_is_upper() const
    {
      return slave_body > master_body;
    }
  };

  /**
   * The sides of the fault between the bodies @p lower and lower + 1. Slave is,
   * in this order,
   *
   * - the side of the body that deforms, if the other one is rigid;
   * - the side of the softer body, if the other one is more than four times as
   *   stiff: multigrid and the rate problem of a stiff slave are hard to solve;
   * - the side with the smaller faces on average;
   * - the side of the softer body;
   * - the upper one.
   *
   * @p stiffness_ratio: a modulus of the upper body over that of the lower one.
   */
  template <int dim>
  FaultSides
  choose_fault_sides(const MeshLevel<dim> &level,
                     const unsigned int    lower,
                     const double          stiffness_ratio = 1.);

  /** The numbers of the nodes of a surface of one body. */
  template <int dim>
  std::vector<types::global_dof_index>
  surface_nodes(const MeshLevel<dim>    &level,
                const unsigned int       body,
                const types::boundary_id side);

  /** Extents of the faces of a surface: their mean and their least, m. */
  template <int dim>
  std::pair<double, double>
  face_sizes(const FaultSurface<dim> &surface);
} // namespace StickSlip

#endif
