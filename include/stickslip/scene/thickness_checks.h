// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_thickness_checks_h
#define stickslip_scene_thickness_checks_h

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Check the lower and upper sides of the bodies of a stack. Throws InputError
   * if
   * - a body with a fault above it, or a rigid one, has a slope,
   * - a fault next to a rigid body is not level,
   * - a side is not the same at both ends of a periodic body,
   * - or a body has no thickness somewhere; the elevation of faults is looked
   * at in 200 places (50 along each axis in three dimensions).
   */
  template <int dim>
  void
  check_thicknesses(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
