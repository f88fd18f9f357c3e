// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_ghost_numbers_h
#define stickslip_algebra_ghost_numbers_h

#include <stickslip/algebra/node_partition.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** Numbers of all local nodes, those of the ghosts fetched from their owners.
   * Collective among neighbours. */
  std::vector<unsigned int>
  with_ghosts(const std::vector<unsigned int> &of_owned,
              const NodePartition             &nodes);
} // namespace StickSlip

#endif
