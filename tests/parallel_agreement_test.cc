// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>

#include "parallel_comparison.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Message that each process catches if one of them throws.
  template <typename Exception>
  std::string
  caught(const unsigned int thrower, const std::function<void()> &action)
  {
    try
      {
        carry_out_agreed(MPI_COMM_WORLD, [&]() {
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == thrower)
            action();
        });
      }
    catch (const Exception &error)
      {
        return error.what();
      }
    return "nothing";
  }
} // namespace



TEST(Agreement, AllThrowWhereOneDoes)
{
  const std::string reason = "the disk is full";
  for (unsigned int thrower = 0; thrower < n_processes(); ++thrower)
    {
      EXPECT_EQ(caught<AgreedFailure>(
                  thrower, [&]() { throw std::runtime_error(reason); }),
                reason);
      EXPECT_EQ(caught<InputError>(thrower,
                                   [&]() { throw InputError(reason); }),
                reason);
      // The library's exceptions, without where they come from.
      EXPECT_EQ(caught<AgreedFailure>(
                  thrower, [&]() { AssertThrow(false, ExcMessage(reason)); }),
                reason);
    }
  EXPECT_EQ(caught<std::exception>(n_processes(),
                                   []() { throw InputError("no one"); }),
            "nothing");
}
