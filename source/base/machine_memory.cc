// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/machine_memory.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace StickSlip
{
  double
  machine_memory()
  {
    double     memory = std::numeric_limits<double>::infinity();
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    if (pages > 0 && size > 0)
      memory = static_cast<double>(pages) * static_cast<double>(size);
    // The limits of a container, in both versions of control groups. Where
    // there is none, the file has a word or a number that is far too large.
    for (const char *const name :
         {"/sys/fs/cgroup/memory.max",
          "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
      {
        std::ifstream file(name);
        if (double limit = 0.; file >> limit && limit > 0.)
          memory = std::min(memory, limit);
      }
    return memory;
  }



  unsigned int
  n_processes_on_machine(const MPI_Comm communicator)
  {
    MPI_Comm on_machine;
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &on_machine);
    int n = 1;
    MPI_Comm_size(on_machine, &n);
    MPI_Comm_free(&on_machine);
    return n;
  }
} // namespace StickSlip
