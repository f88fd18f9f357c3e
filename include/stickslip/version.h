// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_version_h
#define stickslip_version_h

namespace StickSlip
{
  /** Version of the program. */
  inline constexpr char version[] = "0.1.0";
} // namespace StickSlip

#endif
