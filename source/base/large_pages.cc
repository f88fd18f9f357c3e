// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/large_pages.h>

#include <cstdint>
#ifdef __linux__
#  include <sys/mman.h>
#  include <unistd.h>
#endif

namespace StickSlip
{
  void
  ask_for_large_pages(void *begin, const std::size_t n_bytes)
  {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // The call takes whole small pages.
    const std::uintptr_t     page  = sysconf(_SC_PAGESIZE);
    const std::uintptr_t     first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t     start = (first + page - 1) / page * page;
    const std::uintptr_t     end   = (first + n_bytes) / page * page;
    constexpr std::uintptr_t large_page = 2u << 20;
    // A refusal, by a system without such pages, changes nothing.
    if (end > start && end - start >= large_page)
      (void)madvise(reinterpret_cast<void *>(start),
                    end - start,
                    MADV_HUGEPAGE);
#else
    (void)begin;
    (void)n_bytes;
#endif
  }
} // namespace StickSlip
