// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/large_pages.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

using namespace StickSlip;

namespace
{
  /** True if the system gives large pages to who asks for them. */
  bool
  has_large_pages()
  {
    std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
    std::string   text;
    return std::getline(file, text) &&
           text.find("[never]") == std::string::npos;
  }



  /** True if large pages have been asked for in the mapping of an address. */
  bool
  is_on_large_pages(const void *address)
  {
    const auto    wanted = reinterpret_cast<std::uintptr_t>(address);
    std::ifstream file("/proc/self/smaps");
    bool          is_in_mapping = false;
    for (std::string line; std::getline(file, line);)
      {
        std::istringstream words(line);
        std::uintptr_t     begin, end;
        char               minus;
        if (words >> std::hex >> begin >> minus >> end && minus == '-')
          is_in_mapping = wanted >= begin && wanted < end;
        else if (is_in_mapping && line.rfind("VmFlags:", 0) == 0)
          return line.find(" hg") != std::string::npos;
      }
    return false;
  }
} // namespace



TEST(MemoryLargePages, AreAskedForInLargeBlocks)
{
  if (!has_large_pages())
    GTEST_SKIP() << "The system has no large pages.";
  const std::size_t             n = 4u << 20;
  dealii::AlignedVector<double> values;
  reserve_on_large_pages(n, values);
  EXPECT_TRUE(values.empty());
  const double *reserved = values.data();
  values.resize(n);
  EXPECT_EQ(values.data(), reserved);
  EXPECT_EQ(values[0], 0.);
  EXPECT_EQ(values[n - 1], 0.);
  // The system gives them if it has any at the time.
  EXPECT_TRUE(is_on_large_pages(reserved + n / 2));
}



TEST(MemoryLargePages, AreNotAskedForInSmallBlocks)
{
  dealii::AlignedVector<double> values;
  reserve_on_large_pages(0, values);
  reserve_on_large_pages(10, values);
  values.resize(10);
  EXPECT_EQ(values[9], 0.);
  EXPECT_FALSE(is_on_large_pages(values.data()));
}
