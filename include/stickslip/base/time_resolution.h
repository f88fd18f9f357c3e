// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_time_resolution_h
#define stickslip_base_time_resolution_h

#include <limits>

namespace StickSlip
{
  /**
   * The shortest time, s, that can be told well from zero after @p time.
   */
  inline double
  time_resolution(const double time)
  {
    return 64. * std::numeric_limits<double>::epsilon() * time;
  }
} // namespace StickSlip

#endif
