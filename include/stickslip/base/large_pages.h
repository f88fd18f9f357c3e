// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_large_pages_h
#define stickslip_base_large_pages_h

#include <deal.II/base/aligned_vector.h>

#include <cstddef>

namespace StickSlip
{
  /**
   * Ask the system for large pages in a block of memory that nobody has written
   * to yet: a page of 2 MiB takes one interruption where small ones take 512.
   * Nothing happens where the system has none, or gives them unasked.
   */
  void
  ask_for_large_pages(void *begin, const std::size_t n_bytes);

  /** Reserve memory for the values of an empty vector, on large pages. */
  template <typename Number>
  void
  reserve_on_large_pages(const std::size_t              size,
                         dealii::AlignedVector<Number> &values)
  {
    values.reserve(size);
    ask_for_large_pages(values.data(), size * sizeof(Number));
  }
} // namespace StickSlip

#endif
