// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_load_breaks_h
#define stickslip_scene_load_breaks_h

#include <stickslip/scene/scene_parameters.h>

#include <functional>
#include <vector>

namespace StickSlip
{
  /**
   * Times at which a function jumps or has a kink, s, to 1e-12 of @p end, in
   * ascending order; a jump lies behind its time. The function is looked at in
   * 20000 intervals between 0 and @p end. One jump or kink is found in each of
   * those where it differs more from a straight line than in the next ones, or
   * by more than @p tolerance times its largest value, and whose second
   * differences do not fall with the square of the distance.
   */
  std::vector<double>
  breaks_of(const std::function<double(const double)> &function,
            const double                               end,
            const double                               tolerance);

  /**
   * Times at which steps must end, s, in ascending order: those that the scene
   * names, and the breaks of prescribed velocities and tractions at corners
   * and centres of sides (vertices of mesh files).
   */
  template <int dim>
  std::vector<double>
  load_breaks(const SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
