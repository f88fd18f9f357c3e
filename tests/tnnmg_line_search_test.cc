// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/tnnmg/line_search.h>

#include <cmath>
#include <limits>

using namespace StickSlip;

namespace
{
  /**
   * A slope that notes how often and where it was asked for.
   */
  struct Recorder
  {
    std::function<double(double)> slope;
    unsigned int                  calls   = 0;
    double                        largest = 0;

    LineSearchResult
    search()
    {
      const auto asked = [this](const double t) {
        ++calls;
        largest = std::max(largest, t);
        return slope(t);
      };
      const double at_start = asked(0.), at_end = asked(1.);
      return find_step_length(asked, at_start, at_end);
    }
  };
} // namespace



TEST(LineSearch, FullStepWhereTheFunctionStillDecreases)
{
  Recorder recorder{[](const double t) { return t - 1.5; }};
  EXPECT_EQ(recorder.search().step_length, 1.);

  // Also where it ends exactly in the minimum, as Newton's method does.
  recorder.slope = [](const double t) { return 1e-300 * (t - 1.); };
  EXPECT_EQ(recorder.search().step_length, 1.);
}



TEST(LineSearch, NoStepWithoutDescent)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double initial : {0., 1e-300, 1., nan})
    {
      Recorder recorder{[&](const double t) { return initial + t; }};
      EXPECT_EQ(recorder.search().step_length, 0.) << initial;
    }
  // A slope that is not a number at the end says nothing of what is between.
  Recorder recorder{[&](const double t) { return t < 1. ? -1. : nan; }};
  EXPECT_EQ(recorder.search().step_length, 0.);
}



TEST(LineSearch, StopsBeforeTheMinimumWithATenthOfTheSlope)
{
  for (const double minimum : {0.999, 0.5, 0.1, 1e-3, 1e-6, 1e-12})
    {
      Recorder recorder{[=](const double t) { return t / minimum - 1.; }};
      const LineSearchResult result = recorder.search();
      SCOPED_TRACE(minimum);
      EXPECT_LE(result.step_length, minimum * (1 + 1e-14));
      EXPECT_GE(result.step_length, 0.9 * minimum * (1 - 1e-14));
      EXPECT_EQ(result.evaluations, recorder.calls);
      EXPECT_LE(recorder.largest, 1.);
    }
}



TEST(LineSearch, FindsAKink)
{
  // The derivative of |t - kink|: the search brackets it to rounding.
  for (const double kink : {0.9, 1. / 3., 1e-5})
    {
      Recorder recorder{[=](const double t) { return t < kink ? -1. : 1.; }};
      const LineSearchResult result = recorder.search();
      EXPECT_LE(result.step_length, kink);
      EXPECT_NEAR(result.step_length, kink, 1e-14 * kink);
      EXPECT_LT(result.evaluations, 100u);
    }
}



TEST(LineSearch, SlopesOfVeryDifferentSize)
{
  // Next to nothing at the one end, enormous at the other: regula falsi alone
  // would hardly move.
  for (const double factor : {30., 100., 600.})
    for (const double minimum : {0.01, 0.3, 0.9})
      {
        Recorder               recorder{[=](const double t) {
          return std::exp(factor * (t - minimum)) - 1.;
        }};
        const LineSearchResult result = recorder.search();
        EXPECT_GT(result.step_length, 0.);
        EXPECT_LE(result.step_length, minimum * (1 + 1e-14));
        EXPECT_GE(recorder.slope(result.step_length),
                  0.1 * recorder.slope(0.) - 1e-12);
        EXPECT_LT(result.evaluations, 100u);

        Recorder               mirrored{[=](const double t) {
          return 1. - std::exp(factor * (minimum - t));
        }};
        const LineSearchResult other = mirrored.search();
        EXPECT_GT(other.step_length, 0.);
        EXPECT_LE(other.step_length, minimum * (1 + 1e-14));
        EXPECT_GE(mirrored.slope(other.step_length), 0.1 * mirrored.slope(0.));
      }
}
