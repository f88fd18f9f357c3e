// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/simulation/run_ending.h>

#include <iostream>
#include <sstream>

namespace StickSlip
{
  std::string
  describe_ending(const bool is_finished, const double time)
  {
    std::ostringstream text;
    text << (is_finished ? "reached the end time" : "interrupted by the user")
         << ", t = " << time << " s";
    return text.str();
  }



  void
  print_ending(const std::string &ending,
               const std::string &folder,
               const double       largest_error,
               const double       tolerance,
               const MPI_Comm     communicator)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::cout << "Run " << ending << ". Results are in " << folder << '.'
              << std::endl;
    if (largest_error > tolerance)
      std::cout << "Warning: the estimated error of a time step reached "
                << largest_error << ", more than Time/Tolerance = " << tolerance
                << ". Steps of one size do not follow the error." << std::endl;
  }



  bool
  is_known_to_all(const std::exception &error, const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::n_mpi_processes(communicator) == 1 ||
           dynamic_cast<const AgreedFailure *>(&error) != nullptr;
  }
} // namespace StickSlip
