// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_run_ending_h
#define stickslip_simulation_run_ending_h

#include <mpi.h>

#include <exception>
#include <string>

namespace StickSlip
{
  /** Words for the ending of a run without error; @p time: the last one, s. */
  std::string
  describe_ending(const bool is_finished, const double time);

  /** Tell the user how a run has ended and where its results are, and warn of
   * an estimated error larger than Time/Tolerance. On the first process of
   * @p communicator. */
  void
  print_ending(const std::string &ending,
               const std::string &folder,
               const double       largest_error,
               const double       tolerance,
               const MPI_Comm     communicator);

  /** True if all processes have met an error. If only some have, the others
   * are elsewhere in the program and cannot take part in anything any more. */
  bool
  is_known_to_all(const std::exception &error, const MPI_Comm communicator);
} // namespace StickSlip

#endif
