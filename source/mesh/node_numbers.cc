// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/node_numbers.h>

#include <numeric>

namespace StickSlip
{
  NodeNumbers
  number_whole_mesh(const std::vector<unsigned int> &owner,
                    const unsigned int               n_processes)
  {
    NodeNumbers result;
    result.n_nodes = owner.size();
    result.n_owned.resize(n_processes, 0);
    result.owner = owner;
    result.serial.resize(owner.size());
    std::iota(result.serial.begin(), result.serial.end(), 0);
    for (const unsigned int process : owner)
      result.place.push_back(result.n_owned[process]++);
    return result;
  }
} // namespace StickSlip
