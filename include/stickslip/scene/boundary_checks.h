// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_boundary_checks_h
#define stickslip_scene_boundary_checks_h

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Check the conditions on the sides of bodies. Throws InputError if
   * - a side is none, since bodies are periodic,
   * - a rigid body is to move other than as a whole,
   * - a value cannot be evaluated on its side, or has no effect,
   * - or nothing holds the bodies along an axis: the lowest of a stack, or any
   * of others.
   */
  template <int dim>
  void
  check_boundary_conditions(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
