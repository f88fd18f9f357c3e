// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_automatic_limits_h
#define stickslip_scene_automatic_limits_h

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  /**
   * Derive the limits and numbers of sweeps that the scene leaves to the
   * program (`auto`) from its end time, loading, characteristic slip, faults
   * and bodies. In the laboratory, with runs of up to 1000 s, they are
   * constants; the entries say which. All else of the scene must have been
   * checked. Throws InputError if friction has no value at
   * a point.
   */
  template <int dim>
  void
  derive_limits(SceneParameters<dim> &scene);

  /** Keep what has been derived as if it was given. */
  template <int dim>
  void
  fix_limits(SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
