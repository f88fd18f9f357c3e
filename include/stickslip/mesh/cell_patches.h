// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_cell_patches_h
#define stickslip_mesh_cell_patches_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Active cells in patches: those that one cell was refined into, without
   * those of them that are refined further; coarse cells one by one. Volumetric
   * strains of nearly incompressible bodies are means over patches: by the
   * nodes between the corners of two of them the volume of one can change at
   * the cost of the other, as their pressures ask for, which nodes of single
   * cells cannot do.
   */
  class CellPatches
  {
  public:
    /** Each cell by itself. */
    CellPatches() = default;

    /** Patches of cells that are trees. */
    template <int dim>
    static CellPatches
    of_trees(const Triangulation<dim> &mesh);

    /** Patches of a mesh whose cells are in the order of those that they are
     * parts of, 2^dim of each. */
    template <int dim>
    static CellPatches
    of_equal_parts(const Triangulation<dim> &mesh);

    /** The cells of a mesh that are kept in a part of it. */
    CellPatches(const CellPatches &whole, const std::vector<bool> &is_kept);

    /** True if each cell is by itself. */
    bool
    are_single() const
    {
      return order.empty();
    }

    /** Call @p visit(cells) on the active cells of each patch, all of them
     * cells of @p cells, such as a DoFHandler has. */
    template <typename Cells, typename Visitor>
    void
    for_each(const Cells &cells, const Visitor &visit) const
    {
      using Cell = typename Cells::active_cell_iterator;
      std::vector<Cell> patch;
      if (order.empty())
        {
          for (const auto &cell : cells.active_cell_iterators())
            {
              patch.assign(1, cell);
              visit(patch);
            }
          return;
        }
      std::vector<Cell> all;
      for (const auto &cell : cells.active_cell_iterators())
        all.push_back(cell);
      for (unsigned int p = 0; p + 1 < first.size(); ++p)
        {
          patch.clear();
          for (unsigned int k = first[p]; k < first[p + 1]; ++k)
            patch.push_back(all[order[k]]);
          visit(patch);
        }
    }

  private:
    /** Put the cells of the same number together. */
    explicit CellPatches(const std::vector<unsigned int> &patch_of_cell);

    /** Active cells by patch, and where each patch begins; none where each cell
     * is by itself. */
    std::vector<unsigned int> order, first;
  };
} // namespace StickSlip

#endif
