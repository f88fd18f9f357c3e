// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_secant_axes_h
#define stickslip_mortar_secant_axes_h

#include <mpi.h>
#include <stickslip/mortar/fault_axes.h>
#include <stickslip/mortar/fault_displacement.h>

#include <vector>

namespace StickSlip
{
  /** Slope of the chord against the surface of the slave side, at most. Chords
   * of bends that the mesh resolves are far below this; gaps that are there for
   * other reasons close more slowly. */
  constexpr double largest_tilt = 0.1;

  /**
   * The largest gap between the two sides of a fault, see side_gaps(), in
   * either direction.
   */
  struct LargestGap
  {
    /** In m. */
    double absolute = 0;

    /** Over the smallest slave face at the same node, without unit. */
    double over_face = 0;
  };

  /**
   * Axes that couple a fault that bends while it slides on.
   *
   * The velocities of its sides have no jump along the normal, and this normal
   * is kept until the fault is coupled again. Were it the one at the start, a
   * node that slides by delta along a bend of curvature kappa would leave the
   * other side by kappa delta^2 / 2 each time, all to the same side. So the
   * direction of sliding is the chord from where a node is to the place on the
   * other side that it will have come to: with the tangent t and the normal n
   * of the slave side as it is now, and the gap g at x_s + delta t,
   *
   *   t' ~ delta t - g n,   n' normal to it in the plane of t and n.
   *
   * g is the whole gap, so that one that is left closes by sliding on. The
   * partners of slave nodes are those half way, at x_s + delta t/2.
   */
  template <int dim>
  struct SecantCoupling
  {
    /** Axes with n' and the tangents that belong to it. */
    FaultAxes<dim> axes;

    /** The displacements with which the sides are to be coupled. */
    FaultDisplacement<dim> displacement;

    /** The gap as it is now. */
    LargestGap gap;
  };

  /**
   * The coupling of the two sides of a fault, displaced by @p displacement.
   *
   * @p expected_slip: what each slave node will slide by until the fault is
   * coupled again, relative to the master side, m, along its axes as they are
   * before they tilt; empty: nothing slides. A node that slides by a part of
   * @p farthest, the most that any node will, tilts by this part of the slope
   * that it would have if it slid so far: bends and gaps ahead of it matter the
   * less the slower it is, and those that are stuck do not tilt. No slope is
   * larger than largest_tilt.
   *
   * Tangents follow from the @p reference axis as in FaultAxes. Throws
   * InputError if it comes too near to a normal, and ExcMessage as
   * moved_surface() does. All processes get the result, and each finds a part
   * of the gaps. Collective.
   */
  template <int dim>
  SecantCoupling<dim>
  secant_coupling(
    const FaultSurface<dim>               &slave,
    const FaultSurface<dim>               &master,
    const FaultSides                      &sides,
    const FaultDisplacement<dim>          &displacement,
    const std::vector<Tensor<1, dim - 1>> &expected_slip,
    const double                           farthest,
    const Tensor<1, dim> &reference    = FaultAxes<dim>::first_axis(),
    const MPI_Comm       &communicator = MPI_COMM_SELF);

} // namespace StickSlip

#endif
