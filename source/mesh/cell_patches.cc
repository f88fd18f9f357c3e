// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>

#include <stickslip/mesh/cell_patches.h>

#include <map>
#include <utility>

namespace StickSlip
{
  CellPatches::CellPatches(const std::vector<unsigned int> &patch_of_cell)
  {
    // Patches in the order of their first cells.
    std::map<unsigned int, unsigned int>   places;
    std::vector<std::vector<unsigned int>> patches;
    for (unsigned int cell = 0; cell < patch_of_cell.size(); ++cell)
      {
        const auto [place, is_new] =
          places.emplace(patch_of_cell[cell], patches.size());
        if (is_new)
          patches.emplace_back();
        patches[place->second].push_back(cell);
      }
    first.push_back(0);
    for (const std::vector<unsigned int> &patch : patches)
      {
        order.insert(order.end(), patch.begin(), patch.end());
        first.push_back(order.size());
      }
  }



  template <int dim>
  CellPatches
  CellPatches::of_trees(const Triangulation<dim> &mesh)
  {
    std::map<std::pair<int, int>, unsigned int> numbers;
    std::vector<unsigned int>                   patch_of_cell;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const std::pair<int, int> key =
          cell->level() == 0 ?
            std::make_pair(-1, cell->index()) :
            std::make_pair(cell->parent()->level(), cell->parent()->index());
        patch_of_cell.push_back(
          numbers.emplace(key, numbers.size()).first->second);
      }
    return CellPatches(patch_of_cell);
  }



  template <int dim>
  CellPatches
  CellPatches::of_equal_parts(const Triangulation<dim> &mesh)
  {
    std::vector<unsigned int> patch_of_cell;
    for (unsigned int cell = 0; cell < mesh.n_active_cells(); ++cell)
      patch_of_cell.push_back(cell / GeometryInfo<dim>::max_children_per_cell);
    return CellPatches(patch_of_cell);
  }



  CellPatches::CellPatches(const CellPatches       &whole,
                           const std::vector<bool> &is_kept)
  {
    if (whole.order.empty())
      return;
    std::vector<unsigned int> number(is_kept.size(),
                                     numbers::invalid_unsigned_int);
    unsigned int              n_kept = 0;
    for (unsigned int cell = 0; cell < is_kept.size(); ++cell)
      if (is_kept[cell])
        number[cell] = n_kept++;
    first.push_back(0);
    for (unsigned int p = 0; p + 1 < whole.first.size(); ++p)
      {
        for (unsigned int k = whole.first[p]; k < whole.first[p + 1]; ++k)
          if (is_kept[whole.order[k]])
            order.push_back(number[whole.order[k]]);
        if (order.size() > first.back())
          first.push_back(order.size());
      }
  }



  template CellPatches
  CellPatches::of_trees<2>(const Triangulation<2> &);
  template CellPatches
  CellPatches::of_trees<3>(const Triangulation<3> &);
  template CellPatches
  CellPatches::of_equal_parts<2>(const Triangulation<2> &);
  template CellPatches
  CellPatches::of_equal_parts<3>(const Triangulation<3> &);
} // namespace StickSlip
