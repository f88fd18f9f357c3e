// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_mesh_adaptation_h
#define stickslip_simulation_mesh_adaptation_h

#include <stickslip/scene/scene_parameters.h>

#include <ostream>

namespace StickSlip
{
  /**
   * Find the cells that have to be refined for MeshAccuracy::relative_error,
   * and put them into the scene.
   *
   * From the coarse cells on, each round solves static problems that stand for
   * those of a run on the mesh and on the one with all its cells refined once,
   * which gives the error of each cell (HalvingError). If that of the latter is
   * small enough for each of the problems, it is the mesh; otherwise the cells
   * with the largest errors are refined that together have 0.6 of it (Doerfler
   * 1996). The problems are those of test_displacements(), with two kinds of
   * slip of each fault: a patch as large as the part with b > a, or else the
   * fault, and there a wave whose wave number is one over the process zone.
   *
   * Every process does the same. A line on the rounds goes to @p out. Throws
   * InputError if more memory would be needed than @p available_memory, bytes,
   * AgreedFailure if nothing holds a body.
   */
  template <int dim>
  void
  adapt_meshes(SceneParameters<dim> &scene,
               const double          available_memory,
               std::ostream         &out);
} // namespace StickSlip

#endif
