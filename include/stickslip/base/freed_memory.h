// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_freed_memory_h
#define stickslip_base_freed_memory_h

#include <cstddef>

namespace StickSlip
{
  /**
   * Let large blocks of memory go back to the system as soon as they are freed.
   * Some MPI libraries forbid that; the space that one matrix leaves is then
   * kept, and a larger one takes new space. To be called after MPI_Init().
   *
   * @param vector_size Bytes of a vector. Vectors are made in each time step,
   * and keep their space; what is twice as large, and at least 1 MiB, is taken
   * for a matrix.
   */
  void
  give_back_large_blocks(const std::size_t vector_size = 0);

  /**
   * Give what has been freed in small blocks back to the system.
   */
  void
  give_back_freed_memory();
} // namespace StickSlip

#endif
