// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/parameters/text_file.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace StickSlip
{
  template <int dim>
  std::set<CellId>
  refined_cells(const Triangulation<dim> &mesh)
  {
    std::set<CellId> result;
    for (const auto &cell : mesh.cell_iterators())
      if (cell->has_children())
        result.insert(cell->id());
    return result;
  }



  namespace
  {
    /** Flag the cells across a joint from flagged ones; returns true if there
     * are new ones. */
    template <int dim>
    bool
    flag_images(const Triangulation<dim> &mesh)
    {
      bool any = false;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->refine_flag_set())
          for (const unsigned int face : cell->face_indices())
            if (cell->has_periodic_neighbor(face))
              {
                const auto image = cell->periodic_neighbor(face);
                if (image->is_active() && !image->refine_flag_set() &&
                    image->level() <= cell->level())
                  {
                    image->set_refine_flag();
                    any = true;
                  }
              }
      return any;
    }
  } // namespace



  template <int dim>
  void
  refine_flagged(Triangulation<dim> &mesh)
  {
    if (!mesh.get_periodic_face_map().empty())
      do
        mesh.prepare_coarsening_and_refinement();
      while (flag_images(mesh));
    mesh.execute_coarsening_and_refinement();
  }



  template <int dim>
  void
  refine_listed(const std::set<CellId> &list, Triangulation<dim> &mesh)
  {
    while (!list.empty())
      {
        bool any = false;
        for (const auto &cell : mesh.active_cell_iterators())
          if (list.count(cell->id()) > 0)
            {
              cell->set_refine_flag();
              any = true;
            }
        if (!any)
          return;
        refine_flagged(mesh);
      }
  }



  std::string
  table_of_refined_cells(const std::vector<std::string>      &body_names,
                         const std::vector<std::set<CellId>> &cells)
  {
    AssertDimension(body_names.size(), cells.size());
    std::ostringstream text;
    for (unsigned int b = 0; b < cells.size(); ++b)
      for (const CellId &cell : cells[b])
        text << body_names[b] << ' ' << cell << '\n';
    return text.str();
  }



  std::vector<std::set<CellId>>
  read_refined_cells(const std::string              &file_name,
                     const std::vector<std::string> &body_names)
  {
    // Coarse cell, level, and the child on each level.
    static const std::regex form("[0-9]{1,9}_[0-9]{1,2}:[0-7]*");

    std::ifstream file(file_name);
    if (!file)
      throw InputError("The file '" + file_name + "' cannot be read.");
    std::vector<std::set<CellId>> cells(body_names.size());
    unsigned int                  line_number = 0;
    for (std::string line; std::getline(file, line);)
      {
        remove_byte_order_mark(line, ++line_number);
        std::istringstream words(line);
        std::string        name, cell, more;
        if (!(words >> name))
          continue;
        words >> cell;
        const auto body = std::find(body_names.begin(), body_names.end(), name);
        const std::size_t level = cell.find('_'), path = cell.find(':');
        if (body == body_names.end() || !std::regex_match(cell, form) ||
            std::stoul(cell.substr(level + 1)) != cell.size() - path - 1 ||
            words >> more)
          throw InputError("The file '" + file_name + "', line " +
                           std::to_string(line_number) +
                           ", must have the name of a body and a cell such as "
                           "'12_2:03'.");
        cells[body - body_names.begin()].emplace(cell);
      }
    return cells;
  }



  template decltype(refined_cells<2>)  refined_cells<2>;
  template decltype(refined_cells<3>)  refined_cells<3>;
  template decltype(refine_flagged<2>) refine_flagged<2>;
  template decltype(refine_flagged<3>) refine_flagged<3>;
  template decltype(refine_listed<2>)  refine_listed<2>;
  template decltype(refine_listed<3>)  refine_listed<3>;
} // namespace StickSlip
