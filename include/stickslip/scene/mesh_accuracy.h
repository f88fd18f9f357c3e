// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_mesh_accuracy_h
#define stickslip_scene_mesh_accuracy_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/cell_id.h>

#include <set>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** Entries of a parameter file for meshes whose cells the program chooses. */
  struct MeshAccuracy
  {
    /** Name of the file of the cells of a run in its folder. */
    static constexpr const char *file_of_run = "refined_cells.txt";

    /** Relative error of elastic energies; zero: meshes are as the entries of
     * the bodies say. */
    double relative_error = 0.;

    /** The file of the cells that are refined, found in an earlier run. */
    std::string refined_cells_file;

    /** The cells that are refined, in the order of the bodies; empty: none
     * beyond what entries of the bodies say. */
    std::vector<std::set<CellId>> refined_cells;

    /** True if the cells are still to be found. */
    bool
    is_wanted() const
    {
      return relative_error > 0. && refined_cells.empty();
    }

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
