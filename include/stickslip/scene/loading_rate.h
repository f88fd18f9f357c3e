// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_loading_rate_h
#define stickslip_scene_loading_rate_h

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * The largest magnitude of the velocities prescribed on outer sides and of
   * the slip rates prescribed on faults, m/s: sampled at the corners and the
   * centre of each side, at 101 times over the run, and at some points of each
   * fault, without ramps. Zero if none is prescribed.
   */
  template <int dim>
  double
  largest_prescribed_velocity(const SceneParameters<dim> &scene);

  /**
   * The mean slip rate above which an event begins, m/s: as the scene says, or
   * twice the largest prescribed velocity.
   */
  template <int dim>
  double
  event_start_slip_rate(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
