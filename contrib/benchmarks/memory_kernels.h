// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_memory_kernels_h
#define stickslip_contrib_memory_kernels_h

namespace Measure
{
  /** The triad of STREAM, a = b + s c. */
  void
  triad(double             *a,
        const double       *b,
        const double       *c,
        const double        s,
        const unsigned long size);

  /** The sum of an array, which is nothing but reading it. */
  double
  read(const double *a, const unsigned long size);
} // namespace Measure

#endif
