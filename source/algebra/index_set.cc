// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/index_set.h>

#include <algorithm>

namespace StickSlip
{
  IndexSet
  make_index_set(const types::global_dof_index        size,
                 std::vector<types::global_dof_index> indices)
  {
    std::sort(indices.begin(), indices.end());
    IndexSet set(size);
    set.add_indices(indices.begin(),
                    std::unique(indices.begin(), indices.end()));
    set.compress();
    return set;
  }
} // namespace StickSlip
