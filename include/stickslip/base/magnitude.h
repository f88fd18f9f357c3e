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
   * The magnitude of a vector. Other than Tensor::norm() it does not form
   * squares, which are too small for a number where the vector is below
   * 1e-162.
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
