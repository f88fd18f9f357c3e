// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/freed_memory.h>

#include <algorithm>
#include <cstdlib>
#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace StickSlip
{
  void
  give_back_large_blocks(const std::size_t vector_size)
  {
#ifdef __GLIBC__
    constexpr std::size_t least = 1u << 20;
    // glibc takes no more.
    constexpr std::size_t most  = 32u << 20;
    const int             large = std::clamp(2 * vector_size, least, most);
    mallopt(M_MMAP_MAX, 65536);
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, most);
#else
    (void)vector_size;
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
