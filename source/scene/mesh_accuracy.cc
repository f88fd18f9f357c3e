// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/entries.h>
#include <stickslip/scene/mesh_accuracy.h>

namespace StickSlip
{
  void
  MeshAccuracy::add_parameters(ParameterHandler &prm)
  {
    add_number(
      prm,
      "Accuracy",
      relative_error,
      NumberRange().at_least(0).below(1),
      "Relative error of the elastic energy, and so of the compliance "
      "of bodies and faults, that the meshes shall have under the loads "
      "and under slip of the faults, without unit: cells are refined "
      "where it comes from, starting from the coarse cells. 0: meshes "
      "are as the entries of the bodies say.");
    add_text(prm,
             "Refined cells",
             refined_cells_file,
             "Name of a file of cells that are refined, which a run with an "
             "accuracy has written in its output folder, next to the "
             "parameter file unless a path is given: the meshes are those of "
             "that run. Empty: none.");
  }
} // namespace StickSlip
