// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/section_times.h>

#include <thread>

using namespace StickSlip;

TEST(SectionTimes, AddUpOverThePassesOfEachSection)
{
  SectionTimes times;
  const auto   pass = [&](const std::string &section) {
    const SectionTimes::Scope scope(times, section);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  EXPECT_TRUE(times.seconds().empty());
  pass("one");
  const double of_one = times.seconds().at("one");
  EXPECT_GE(of_one, 5e-3);
  pass("two");
  EXPECT_EQ(times.seconds().at("one"), of_one);
  pass("one");
  EXPECT_GE(times.seconds().at("one"), of_one + 5e-3);
  EXPECT_EQ(times.seconds().size(), 2u);
}
