// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "memory_kernels.h"

namespace Measure
{
  void
  triad(double *__restrict a,
        const double *__restrict b,
        const double *__restrict c,
        const double        s,
        const unsigned long size)
  {
    for (unsigned long i = 0; i < size; ++i)
      a[i] = b[i] + s * c[i];
  }



  double
  read(const double *a, const unsigned long size)
  {
    // As many sums as hide the time that an addition takes.
    constexpr unsigned int n       = 64;
    double                 sums[n] = {};
    for (unsigned long i = 0; i + n <= size; i += n)
      for (unsigned int k = 0; k < n; ++k)
        sums[k] += a[i + k];
    double sum = 0;
    for (unsigned int k = 0; k < n; ++k)
      sum += sums[k];
    return sum;
  }
} // namespace Measure
