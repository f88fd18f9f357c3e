// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "opening_iterations.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(LongOpening, IterationsAreLevelOverFiveRefinements)
{
  for (const unsigned int upper_cells : {10, 14})
    for (const double tau : {1e-1, 1e-3, 1e-5})
      {
        std::vector<std::vector<unsigned int>> counts;
        for (const unsigned int passes : {1, 2, 3, 4, 5})
          counts.push_back(expect_few_iterations<2>(
            std::to_string(upper_cells) + " cells, " + std::to_string(passes),
            {make_body<2>(1., {{10, 2}}, passes),
             make_body<2>(1., {{upper_cells, 2}}, passes)},
            tau));
        expect_level(counts);
      }
}



TEST(LongOpening, IterationsAreLevelOverOneToEightFaults)
{
  for (const double tau : {1e-1, 1e-3, 1e-5})
    for (const bool match : {true, false})
      {
        std::vector<std::vector<unsigned int>> counts;
        for (const unsigned int n_faults : {1, 2, 4, 8})
          {
            std::vector<BodyGeometry<2>> bodies;
            for (unsigned int b = 0; b <= n_faults; ++b)
              bodies.push_back(
                make_body<2>(1., {{match || b % 2 == 0 ? 10u : 14u, 2}}, 3));
            counts.push_back(expect_few_iterations<2>(
              std::to_string(n_faults) + " faults", bodies, tau));
          }
        expect_level(counts);
      }
}



TEST(LongOpening, IterationsAreLevelInThreeDimensions)
{
  for (const double tau : {1e-1, 1e-3, 1e-5})
    for (const unsigned int upper_cells : {5, 7})
      {
        std::vector<std::vector<unsigned int>> counts;
        for (const unsigned int passes : {1, 2, 3})
          counts.push_back(expect_few_iterations<3>(
            "three dimensions, " + std::to_string(upper_cells) + " cells, " +
              std::to_string(passes),
            {make_body<3>(1., {{5, 5, 2}}, passes),
             make_body<3>(1., {{upper_cells, upper_cells, 2}}, passes)},
            tau));
        expect_level(counts);
      }
}
