// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_fault_sides_h
#define stickslip_mortar_fault_sides_h

#include <stickslip/mesh/mesh_level.h>

namespace StickSlip
{
  /**
   * The side of a fault that carries the multipliers and the jumps, the slave,
   * and the other one: the first (0) or the second (1) side of the topology.
   */
  struct FaultSides
  {
    unsigned int slave = 1, master = 0;

    bool
    slave_is_second() const
    {
      return slave == 1;
    }

    /** The jump from the first side to the second over that from master to
     * slave: 1 or -1. */
    double
    sign() const
    {
      return slave_is_second() ? 1. : -1.;
    }
  };

  /**
   * The sides of a fault of a level whose bodies are those of the @p topology.
   * Slave is, in this order,
   *
   * - the side that deforms, if the other one is rigid;
   * - the side that is interrupted by more nodes of other faults
   * (crosspoints.h): one that ends there is no jump to be seen from across;
   * - the softer side, if the other one is more than four times as stiff:
   *   multigrid and the rate problem of a stiff slave are hard to solve;
   * - the side with the smaller faces on average;
   * - the softer side;
   * - the second one.
   *
   * @p stiffness_ratio: a modulus of the second side over that of the first.
   */
  template <int dim>
  FaultSides
  choose_fault_sides(const MeshLevel<dim> &level,
                     const FaultTopology  &topology,
                     const unsigned int    fault,
                     const double          stiffness_ratio = 1.);

  /** Extents of the faces of a surface: their mean and their least, m. */
  template <int dim>
  std::pair<double, double>
  face_sizes(const FaultSurface<dim> &surface);
} // namespace StickSlip

#endif
