// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_wright_omega_h
#define stickslip_friction_wright_omega_h

namespace StickSlip
{
  /**
   * The Wright omega function of a real argument: the positive solution y of
   *
   *   y + ln(y) = s.
   *
   * Underflows to zero for s < -745, as exp(s) does, and grows as s - ln(s).
   * For s >= -1 the iteration is that of Fritsch, Shafer and Crowley,
   * Algorithm 443 (Comm. ACM 16, 1973), of fourth order; below, y is so small
   * that ln(y) is the better unknown.
   */
  double
  wright_omega(const double s);
} // namespace StickSlip

#endif
