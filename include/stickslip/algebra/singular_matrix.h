// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_singular_matrix_h
#define stickslip_algebra_singular_matrix_h

#include <stdexcept>
#include <string>

namespace StickSlip
{
  /**
   * Thrown where a matrix cannot be factorised; what() names it.
   */
  class SingularMatrix : public std::runtime_error
  {
  public:
    explicit SingularMatrix(const std::string &name)
      : std::runtime_error(name + " is singular")
    {}
  };
} // namespace StickSlip

#endif
