// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_make_set_h
#define stickslip_algebra_make_set_h

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
} // namespace StickSlip

#endif
