// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_message_count_h
#define stickslip_contrib_message_count_h

#include <cstdint>

namespace Measure
{
  /** All that a process has sent since reset_message_count(). */
  struct MessageCount
  {
    std::uint64_t messages      = 0;
    std::uint64_t message_bytes = 0;
    std::uint64_t receivers     = 0;
    std::uint64_t sums          = 0;
    std::uint64_t sum_bytes     = 0;
  };

  void
  reset_message_count();

  /**
   * The count of this process, of what has been sent by whichever library: the
   * program takes the place of MPI's functions for sending and reducing, which
   * MPI's profiling interface is for.
   */
  MessageCount
  message_count();
} // namespace Measure

#endif
