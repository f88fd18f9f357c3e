// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_flush_to_zero_h
#define stickslip_base_flush_to_zero_h

#ifdef __SSE2__
#  include <xmmintrin.h>
#endif

namespace StickSlip
{
  /**
   * While an object of this class lives, results too small for a normalised
   * number are zero. A sweep of Gauss-Seidel carries the influence of a point
   * along a row of nodes, smaller and smaller, and arithmetic with denormalised
   * numbers is slow. Has no effect on processors other than x86.
   */
  class FlushToZero
  {
  public:
#ifdef __SSE2__
    FlushToZero()
      : previous(_mm_getcsr())
    {
      constexpr unsigned int flush_results = 0x8000, zero_operands = 0x0040;
      _mm_setcsr(previous | flush_results | zero_operands);
    }

    ~FlushToZero()
    {
      _mm_setcsr(previous);
    }
#else
    FlushToZero() = default;
#endif

    FlushToZero(const FlushToZero &) = delete;
    FlushToZero &
    operator=(const FlushToZero &) = delete;

#ifdef __SSE2__
  private:
    const unsigned int previous;
#endif
  };
} // namespace StickSlip

#endif
