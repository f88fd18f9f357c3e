// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_checks_h
#define stickslip_scene_scene_checks_h

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Check all that no single entry shows: that lower bounds are below upper
   * ones, that neighbouring bodies face each other, that the lowest body is
   * held along every axis, and that all expressions can be evaluated on their
   * side or fault and give values that make sense there.
   *
   * Throws InputError with one sentence on the first contradiction. The bodies
   * must have been stacked.
   */
  template <int dim>
  void
  check_scene(const SceneParameters<dim> &scene);

  /**
   * Check that lower limits of steps and output are below upper ones, after
   * derive_limits(). Throws InputError with one sentence if not.
   */
  template <int dim>
  void
  check_limits(const SceneParameters<dim> &scene);

  /**
   * Check that everything the scene asks for runs on as many processes. Throws
   * InputError with one sentence if not.
   */
  template <int dim>
  void
  check_process_count(const SceneParameters<dim> &scene,
                      const unsigned int          n_processes);
} // namespace StickSlip

#endif
