// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_make_set_h
#define stickslip_base_make_set_h

#include <algorithm>
#include <vector>

namespace StickSlip
{
  /** Sort a list, and keep one of equal entries. */
  template <typename T>
  void
  make_set(std::vector<T> &list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /**
   * The columns of some rows of a sparsity pattern, each once, in ascending
   * order: without sorting, since most appear in several rows.
   */
  inline std::vector<unsigned int>
  columns_of_rows(const std::vector<unsigned int> &row_start,
                  const std::vector<unsigned int> &column,
                  const std::vector<unsigned int> &rows)
  {
    unsigned int end = 0;
    for (const unsigned int i : rows)
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
        end = std::max(end, column[k] + 1);
    std::vector<char> is_listed(end, 0);
    for (const unsigned int i : rows)
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
        is_listed[column[k]] = 1;
    std::vector<unsigned int> result;
    for (unsigned int j = 0; j < end; ++j)
      if (is_listed[j])
        result.push_back(j);
    return result;
  }
} // namespace StickSlip

#endif
