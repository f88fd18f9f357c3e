// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_block_entries_h
#define stickslip_scene_block_entries_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/geometry/block.h>

#include <array>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** Entries of a parameter file for a body that is given by its corners. */
  struct BlockEntries
  {
    /** Points, see PointList; no corners: the body is not a block. */
    std::string corners;

    /** Points on the left, right, bottom and top side. */
    std::array<std::string, 4> polylines;

    /** Lower and upper end along y, m. */
    std::array<double, 2> along_y = {{-2.5, 2.5}};

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm, const unsigned int dim);

    /**
     * The block, without its coarse cells. Throws InputError if an end along y
     * is not above the other.
     */
    template <int dim>
    Block<dim>
    block(const std::string &body_name) const;
  };

  /**
   * Throws InputError if the entry Between of a fault, of the value @p text,
   * does not name two sides of blocks, or one twice.
   */
  template <int dim>
  void
  check_between_blocks(const std::string              &entry,
                       const std::string              &text,
                       const std::vector<std::string> &body_names);
} // namespace StickSlip

#endif
