// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/ghost_numbers.h>

#include <algorithm>

namespace StickSlip
{
  std::vector<unsigned int>
  with_ghosts(const std::vector<unsigned int> &of_owned,
              const NodePartition             &nodes)
  {
    AssertDimension(of_owned.size(), nodes.n_owned());
    // A double holds all of these numbers.
    NodalVector values(nodes.nodes());
    std::copy(of_owned.begin(), of_owned.end(), values.begin());
    update_ghosts(values);
    return std::vector<unsigned int>(values.begin(),
                                     values.begin() + nodes.n_local());
  }
} // namespace StickSlip
