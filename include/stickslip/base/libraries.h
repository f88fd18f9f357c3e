// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_libraries_h
#define stickslip_base_libraries_h

#include <deal.II/base/mpi.h>

#include <stickslip/base/freed_memory.h>

#include <array>

namespace StickSlip
{
  /**
   * MPI and all libraries below deal.II, with one thread a process, while an
   * object of this class lives. They see no options of the program: PETSc,
   * which deal.II brings along on Debian 13, complains of all that it does not
   * know.
   */
  class Libraries
  {
  public:
    Libraries()
      : arguments{{name.data(), nullptr}}
      , mpi(n_arguments, first_argument, 1)
    {
      give_back_large_blocks();
    }

  private:
    std::array<char, 10>                     name = {"stickslip"};
    std::array<char *, 2>                    arguments;
    int                                      n_arguments    = 1;
    char                                   **first_argument = arguments.data();
    dealii::Utilities::MPI::MPI_InitFinalize mpi;
  };
} // namespace StickSlip

#endif
