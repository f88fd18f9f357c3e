// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/first_free_turns.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  std::vector<unsigned int>
  first_free_turns(const std::vector<std::vector<unsigned int>> &excluded,
                   const std::vector<unsigned int>              &order)
  {
    std::vector<unsigned int> turns(excluded.size(),
                                    std::numeric_limits<unsigned int>::max());
    std::vector<unsigned int> taken;
    for (const unsigned int thing : order)
      {
        taken.clear();
        for (const unsigned int other : excluded[thing])
          taken.push_back(turns[other]);
        turns[thing] = 0;
        while (std::find(taken.begin(), taken.end(), turns[thing]) !=
               taken.end())
          ++turns[thing];
      }
    return turns;
  }
} // namespace StickSlip
