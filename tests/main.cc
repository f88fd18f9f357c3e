// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <stickslip/base/libraries.h>

#include <iostream>

namespace
{
  // The first process tells how the tests go, the others only what fails.
  class FailurePrinter : public ::testing::EmptyTestEventListener
  {
    void
    OnTestPartResult(const ::testing::TestPartResult &result) override
    {
      if (result.failed())
        std::cout << "On process "
                  << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)
                  << ", " << result.file_name() << ':' << result.line_number()
                  << ": " << result.message() << std::endl;
    }
  };
} // namespace



int
main(int argc, char **argv)
{
  const StickSlip::Libraries libraries;
  ::testing::InitGoogleTest(&argc, argv);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    {
      auto &listeners = ::testing::UnitTest::GetInstance()->listeners();
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new FailurePrinter);
    }
  return RUN_ALL_TESTS();
}
