// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_lithostatic_stress_h
#define stickslip_simulation_lithostatic_stress_h

#include <stickslip/scene/scene_parameters.h>

#include <vector>

namespace StickSlip
{
  /**
   * The weight per area of all bodies above a fault, Pa, at each of some
   * points of it: the sum of the integrals of rho over the thickness of the
   * bodies along the last axis, times the part of gravity along that. Bodies
   * above are those on the upper side of the fault and of the faults on top of
   * them; of several on one side the nearest one counts. Beyond its sides a
   * body is taken as it is there. A density
   * that varies is integrated by Gauss quadrature with two points in each of
   * 200 parts of the thickness. Throws InputError if it is out of range.
   */
  template <int dim>
  std::vector<double>
  lithostatic_stress(const SceneParameters<dim>    &scene,
                     const unsigned int             fault,
                     const std::vector<Point<dim>> &points);
} // namespace StickSlip

#endif
