// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_first_free_turns_h
#define stickslip_multigrid_first_free_turns_h

#include <vector>

namespace StickSlip
{
  /**
   * A turn for each of some things, so that those that exclude each other have
   * different ones: in this @p order, the first that nothing has yet that
   * excludes it. @p excluded has for each thing those that exclude it; of a
   * pair, the one that comes later has to know of the other.
   */
  std::vector<unsigned int>
  first_free_turns(const std::vector<std::vector<unsigned int>> &excluded,
                   const std::vector<unsigned int>              &order);
} // namespace StickSlip

#endif
