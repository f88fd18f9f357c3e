// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_magnitude_h
#define stickslip_base_magnitude_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The magnitude of a slip rate. Other than Tensor::norm() it does not form
   * squares: slip rates of stuck faults below 1e-162 m/s, whose squares are
   * too small for a number, are nothing unusual.
   */
  inline double
  magnitude(const Tensor<1, 1> &v)
  {
    return std::abs(v[0]);
  }

  inline double
  magnitude(const Tensor<1, 2> &v)
  {
    return std::hypot(v[0], v[1]);
  }
} // namespace StickSlip

#endif
