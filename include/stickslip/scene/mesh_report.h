// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_mesh_report_h
#define stickslip_scene_mesh_report_h

#include <stickslip/scene/scene_parameters.h>

#include <ostream>
#include <string>

namespace StickSlip
{
  /**
   * Write what a scene consists of before any refinement: bodies and their
   * sides, faults, the places where these end inside bodies, and those where
   * more than two parts of bodies meet.
   */
  template <int dim>
  void
  report_meshes(const SceneParameters<dim> &scene, std::ostream &out);

  /**
   * Write the coarse cells of each body and its boundary faces, with the
   * numbers that report_meshes() has in brackets as material, in
   * 'mesh_<body>.vtk' in a folder, which is made. Throws InputError if that
   * cannot be.
   */
  template <int dim>
  void
  write_mesh_pictures(const SceneParameters<dim> &scene,
                      const std::string          &directory);
} // namespace StickSlip

#endif
