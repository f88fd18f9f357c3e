// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_layout_h
#define stickslip_output_fault_layout_h

#include <stickslip/mesh/fault_surface.h>

#include <cmath>
#include <vector>

namespace StickSlip
{
  /**
   * Place and axes of a fault, for its files.
   */
  template <int dim>
  struct FaultLayout
  {
    /** The side whose nodes have the fields of a FaultSnapshot, in their
     * order. */
    FaultSurface<dim> surface;

    /** Unit vectors at each node as columns: those along which the components
     * of slip and traction are, and last the normal from the first to the
     * second side. On level faults the former are the horizontal axes of space
     * even where the normal points downwards. */
    std::vector<Tensor<2, dim>> axes;

    /** Rigidity of the rock at each node, Pa, see fault_rigidity(); empty where
     * nobody needs it. */
    std::vector<double> rigidity;

    /** True if the fault is level. */
    bool
    is_level() const
    {
      return surface.is_plane() && std::abs(surface.normal[dim - 1]) == 1.;
    }
  };

  /**
   * The places in FaultSurface::faces of the vertices of a face, one after the
   * other around it.
   */
  template <int dim>
  std::vector<unsigned int>
  vertices_around(const FaultSurface<dim> &surface, const unsigned int face);

  /**
   * The way along a fault in two dimensions to each of its nodes, m, in the
   * order of the nodes: the length of the faces on it, in the reference
   * configuration. It
   * begins at the end that the tangents (the first axes) point away from, so
   * that it grows in the direction in which slip is positive; if the fault has
   * no ends, as a ring or a periodic fault, at the node of the least x (then
   * y). Pieces without a node in common follow each other along the fault, and
   * the way includes what is between them: nothing where another fault crosses.
   */
  std::vector<double>
  arc_lengths(const FaultLayout<2> &fault);
} // namespace StickSlip

#endif
