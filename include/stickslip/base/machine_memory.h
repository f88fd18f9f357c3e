// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_machine_memory_h
#define stickslip_base_machine_memory_h

#include <mpi.h>

namespace StickSlip
{
  /**
   * The memory of this machine, or of the part of it that the program may use,
   * bytes; infinity if it is not known.
   */
  double
  machine_memory();

  /**
   * The number of processes that share the memory of this machine. Collective.
   */
  unsigned int
  n_processes_on_machine(const MPI_Comm communicator);
} // namespace StickSlip

#endif
