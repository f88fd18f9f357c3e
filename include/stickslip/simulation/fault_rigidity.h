// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_fault_rigidity_h
#define stickslip_simulation_fault_rigidity_h

#include <stickslip/mechanics/material.h>
#include <stickslip/scene/scene_parameters.h>

#include <functional>
#include <vector>

namespace StickSlip
{
  /** The sum over both sides of a fault of a number of the material next to
   * each of some points of it. Rigid bodies, which yield to nothing, add
   * nothing. */
  template <int dim>
  std::vector<double>
  sum_over_sides(const SceneParameters<dim>                    &scene,
                 const unsigned int                             fault,
                 const std::vector<Point<dim>>                 &points,
                 const std::function<double(const Material &)> &number);

  /**
   * The rigidity of the rock around a fault at some points of it, Pa: the
   * harmonic mean 2 / (1/G1 + 1/G2) of the shear moduli of its sides, as of two
   * springs in a row that share the slip. Next to a rigid body it is twice that
   * of the other side, which moves by the whole slip.
   */
  template <int dim>
  std::vector<double>
  fault_rigidity(const SceneParameters<dim>    &scene,
                 const unsigned int             fault,
                 const std::vector<Point<dim>> &points);
} // namespace StickSlip

#endif
