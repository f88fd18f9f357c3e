// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// Memory that is freed goes back to the system or stays, by the size of blocks.

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>
#include <stickslip/base/freed_memory.h>

#include <vector>

using namespace StickSlip;

namespace
{
  constexpr std::size_t MiB = 1u << 20;



  /** Memory of this process, bytes. */
  double
  resident()
  {
    dealii::Utilities::System::MemoryStats stats;
    dealii::Utilities::System::get_memory_stats(stats);
    return 1024. * stats.VmRSS;
  }



  /** MiB that go back to the system when forty blocks of 3 MiB are freed, each
   * before a smaller one that stays. Other tests would leave gaps in the heap
   * for these, so that there are none in the same program. */
  double
  given_back()
  {
    std::vector<std::vector<char>> large, small;
    for (unsigned int i = 0; i < 40; ++i)
      {
        large.emplace_back(3 * MiB, 'a');
        small.emplace_back(MiB / 4, 'b');
      }
    const double before = resident();
    large.clear();
    return (before - resident()) / MiB;
  }
} // namespace



TEST(FreedMemory, MatricesGoBackAndVectorsStay)
{
  give_back_large_blocks();
  EXPECT_GT(given_back(), 90.);
  // Half of the least size of a matrix.
  give_back_large_blocks(1.4 * MiB);
  EXPECT_GT(given_back(), 90.);
  give_back_large_blocks(1.6 * MiB);
  EXPECT_LT(given_back(), 30.);
  give_back_freed_memory();
  give_back_large_blocks();
}
