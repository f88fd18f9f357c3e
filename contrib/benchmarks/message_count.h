// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_message_count_h
#define stickslip_contrib_message_count_h

#include <cstdint>

namespace Measure
{
  /** Messages without waiting, and sums over processes, in which a process took
   * part since reset_message_count(). */
  struct MessageCount
  {
    std::uint64_t messages      = 0;
    std::uint64_t message_bytes = 0;
    std::uint64_t sums          = 0;
    std::uint64_t sum_bytes     = 0;
  };

  void
  reset_message_count();

  /**
   * The count of this process, of what any library has sent: the program takes
   * the place of MPI_Isend and MPI_Allreduce, which MPI's profiling interface
   * is for. No part of a rate problem uses others.
   */
  MessageCount
  message_count();
} // namespace Measure

#endif
