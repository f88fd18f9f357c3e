// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_local_products_h
#define stickslip_algebra_local_products_h

#include <stickslip/algebra/node_partition.h>

#include <array>

namespace StickSlip
{
  /** The part of a . b that this process has: sums of several products take one
   * message then. Not collective. */
  double
  local_product(const NodalVector &a, const NodalVector &b);

  /** Sums over all processes, in one message. Collective. */
  template <std::size_t n>
  std::array<double, n>
  sums(const std::array<double, n> &parts, const MPI_Comm communicator);
} // namespace StickSlip

#endif
