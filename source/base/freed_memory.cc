// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/freed_memory.h>

#include <cstdlib>
#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace StickSlip
{
  void
  give_back_large_blocks()
  {
#ifdef __GLIBC__
    // Matrices, not vectors, which are made too often for new pages each time.
    constexpr int large = 32 * 1024 * 1024;
    mallopt(M_MMAP_MAX, 65536);
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
#endif
  }



  void
  give_back_freed_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace StickSlip
