// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_index_set_h
#define stickslip_algebra_index_set_h

#include <deal.II/base/index_set.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The set of some indices below @p size, given in any order and as often as
   * may be.
   */
  IndexSet
  make_index_set(const types::global_dof_index        size,
                 std::vector<types::global_dof_index> indices);
} // namespace StickSlip

#endif
