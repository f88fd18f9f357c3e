// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_declaration_h
#define stickslip_scene_scene_declaration_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/scene/scene_parameters.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Declare the entries of a body in its subsection of @p prm.
   */
  template <int dim>
  void
  declare_body(ParameterHandler &prm, BodyParameters<dim> &body);

  /**
   * Declare the whole parameter file of @p scene, whose values are the
   * defaults. The bodies, faults and boundary conditions of the scene must be
   * there and named; what is set in @p prm afterwards goes into @p scene, which
   * must stay where it is for as long as @p prm is used. The entry for the base
   * elevation is that of the lowest body; complete_geometry() derives the
   * others.
   */
  template <int dim>
  void
  declare_scene(ParameterHandler &prm, SceneParameters<dim> &scene);

  /**
   * Complete the bodies' geometries from each other and from the scene: each
   * body lies on top of the one below, and all are periodic along the same
   * axes.
   */
  template <int dim>
  void
  complete_geometry(SceneParameters<dim> &scene);
} // namespace StickSlip

#endif
