// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/contact_states.h>
#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/opening_catalogue.h>
#include <stickslip/output/time_series.h>

#include <cmath>
#include <sstream>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Four nodes on a slope of 3 to 4, at 0, 5, 10 and 15 m along it, the last
   * one off contact. */
  FaultSnapshot<2>
  fault_with_gaps(const std::vector<double> &gaps)
  {
    FaultSnapshot<2> fault;
    fault.name    = "main";
    fault.weights = {2, 4, 3, 0};
    for (unsigned int p = 0; p < 4; ++p)
      fault.points.emplace_back(4. * p, 3. * p);
    fault.slip.resize(4);
    fault.slip_rate.resize(4);
    fault.shear_traction.resize(4);
    fault.state.assign(4, 1.);
    fault.gap = gaps;
    fault.gap.resize(4, 1e3);
    fault.opening_rate.assign(4, 0.);
    fault.is_bonded.assign(4, 0);
    return fault;
  }



  FaultLayout<2>
  sloping_shape()
  {
    FaultLayout<2> shape;
    shape.surface.points = fault_with_gaps({}).points;
    shape.surface.faces  = {{{0, 1}}, {{1, 2}}, {{2, 3}}};
    shape.surface.face_normals.resize(3);
    shape.axes.assign(4, Tensor<2, 2>({{0.8, -0.6}, {0.6, 0.8}}));
    return shape;
  }



  /** A body that is thrown up at speed 2 from a fault at rest, under gravity 1:
   * its gap is zero before t = 1 and after t = 5. */
  double
  thrown(const double t)
  {
    return std::max(0., 2 * (t - 1) - (t - 1) * (t - 1) / 2);
  }



  std::vector<std::string>
  lines_of(const std::string &file_name)
  {
    std::vector<std::string> lines;
    std::istringstream       stream(content_of(file_name));
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    return lines;
  }
} // namespace



TEST(OpeningStatistics, CountOpenNodesOppositeTheOtherSide)
{
  const OpeningStatistics some =
    opening_statistics(fault_with_gaps({1e-300, 0, 2}));
  EXPECT_EQ(some.largest_gap, 2);
  EXPECT_EQ(some.widest_node, 2u);
  EXPECT_EQ(some.open_area, 5);
  const OpeningStatistics none = opening_statistics(fault_with_gaps({0, 0, 0}));
  EXPECT_EQ(none.largest_gap, 0);
  EXPECT_EQ(none.open_area, 0);
}



TEST(ContactStates, AreThoseOfTheNodes)
{
  FaultSnapshot<2> fault = fault_with_gaps({0, 0, 0, 0});
  fault.slip_rate        = {Tensor<1, 1>({1e-3}),
                            Tensor<1, 1>({-1.1e-3}),
                            Tensor<1, 1>({0}),
                            Tensor<1, 1>({0})};
  using State            = ContactState;
  EXPECT_EQ(contact_states(fault, 1e-3),
            (std::vector<State>{
              State::stuck, State::slipping, State::stuck, State::open}));
  fault.gap       = {1e-300, 0, 0, 0};
  fault.is_bonded = {0, 1, 1, 1};
  EXPECT_EQ(contact_states(fault, 1e-3),
            (std::vector<State>{
              State::open, State::bonded, State::bonded, State::open}));
  fault.gap.clear();
  fault.is_bonded.clear();
  EXPECT_TRUE(contact_states(fault, 1e-3).empty());
}



TEST(TimeSeries, HasGapAndOpenAreaOfFaultsThatMayOpen)
{
  const TemporaryFolder         folder;
  std::vector<FaultSnapshot<2>> faults(2, fault_with_gaps({0, 0, 0}));
  faults[0].name = "bilateral";
  faults[0].gap.clear();
  // Known of bends; what is open now counts.
  faults[1].largest_gap = 0.25;
  {
    TimeSeries<2> series(folder.file("a.csv"), faults);
    faults[1].gap = {1e-3, 0, 2e-3, 7};
    series.add(StepRecord(), faults);
  }
  const std::vector<std::string> lines = lines_of(folder.file("a.csv"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].substr(lines[0].rfind(",main.mean_shear_traction")),
            ",main.mean_shear_traction,main.largest_gap,main.open_area");
  EXPECT_EQ(lines[0].find("bilateral.largest_gap"), std::string::npos);
  const std::string end = ",0.002,5";
  EXPECT_EQ(lines[1].substr(lines[1].size() - end.size()), end);
}



TEST(OpeningCatalogue, FindsTimesOfALevelOfTheGap)
{
  const TemporaryFolder folder;
  constexpr double      threshold = 0.02, tau = 0.3;
  OpeningCatalogue<2>   catalogue(folder.file("a.csv"),
                                {sloping_shape()},
                                threshold);
  // The left node opens first, the middle one a little later and wider.
  for (double t = 0; t < 8; t += tau)
    catalogue.add(t,
                  {fault_with_gaps(
                    {thrown(t), 1.5 * std::max(0., thrown(t) - 0.5), 0})});
  ASSERT_EQ(catalogue.entries().size(), 1u);
  const Opening &opening = catalogue.entries()[0];
  EXPECT_EQ(opening.fault, "main");
  // Steps end at 0.9 and 1.2, and at 5.1 and before that at 4.8.
  const double rise = thrown(1.2);
  EXPECT_NEAR(opening.opens, 0.9 + 0.3 * threshold / rise, 1e-12);
  const double fall = thrown(4.8);
  EXPECT_NEAR(opening.closes, 5.1 - 0.3 * threshold / 2 / fall, 1e-12);
  // Steps are nearest to the highest point at t = 3, where the gap is 2.
  EXPECT_NEAR(opening.peak_time, 3, 1e-12);
  EXPECT_NEAR(opening.largest_gap, 1.5 * 1.5, 1e-12);
  EXPECT_EQ(opening.largest_open_area, 6);
  EXPECT_EQ(opening.begins_at, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(opening.widest_at, (std::vector<double>{4, 3, 5}));

  const std::vector<std::string> lines = lines_of(folder.file("a.csv"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "fault,opens,peak_time,closes,largest_gap,largest_open_area,"
            "begins_x,begins_y,begins_arc_length,"
            "widest_x,widest_y,widest_arc_length");
  EXPECT_EQ(lines[1].substr(lines[1].size() - 14), ",6,0,0,0,4,3,5");
}



TEST(OpeningCatalogue, TimesAreThoseOfTheLevel)
{
  const TemporaryFolder folder;
  constexpr double      threshold = 0.02;
  // Times at which 2 s - s^2 / 2 is the level.
  const double opens  = 1 + 2 - std::sqrt(4 - 2 * threshold),
               closes = 1 + 2 + std::sqrt(4 - threshold);
  // The gap reaches the level in the first step, and after some.
  for (const unsigned int n : {50, 1200, 4800})
    {
      const double        tau = 6. / n;
      OpeningCatalogue<2> catalogue(folder.file("a.csv"),
                                    {sloping_shape()},
                                    threshold);
      for (unsigned int i = 0; i <= n; ++i)
        catalogue.add(tau * i, {fault_with_gaps({0, thrown(tau * i), 0})});
      ASSERT_EQ(catalogue.entries().size(), 1u);
      // Linear interpolation of a curvature of 1 at a slope of nearly 2.
      const double limit = n == 50 ? tau : 1.1 * tau * tau / 16;
      EXPECT_NEAR(catalogue.entries()[0].opens, opens, limit);
      EXPECT_NEAR(catalogue.entries()[0].closes, closes, limit);
    }
}



TEST(OpeningCatalogue, BouncesBelowTheLevelAreNoOpenings)
{
  const TemporaryFolder folder;
  OpeningCatalogue<2>   catalogue(folder.file("a.csv"), {sloping_shape()}, 0.1);
  double                time = 0;
  const auto            add  = [&](const double gap) {
    catalogue.add(time += 1, {fault_with_gaps({gap, 0, 0})});
  };
  // Before, within and after an opening.
  for (const double gap :
       {0., 0.1, 0., 0.09, 0., 1., 0.05, 0.11, 0.06, 2., 0.05, 0.04, 0.1, 0.})
    add(gap);
  ASSERT_EQ(catalogue.entries().size(), 1u);
  EXPECT_EQ(catalogue.entries()[0].largest_gap, 2);
  EXPECT_DOUBLE_EQ(catalogue.entries()[0].opens, 5.1);
  EXPECT_DOUBLE_EQ(catalogue.entries()[0].closes, 11);
  // One node opens once more, from a gap that has not vanished.
  add(0.05);
  add(0.15);
  add(0.);
  ASSERT_EQ(catalogue.entries().size(), 2u);
  EXPECT_DOUBLE_EQ(catalogue.entries()[1].opens, 15.5);
  EXPECT_DOUBLE_EQ(catalogue.entries()[1].closes, 16 + 2. / 3);
}



TEST(OpeningCatalogue, GoesOnWithinAnOpening)
{
  const TemporaryFolder folder;
  const auto            file_of = [&](const std::string &name) {
    return folder.file(name + ".csv");
  };
  const std::vector<FaultLayout<2>> shapes(2, sloping_shape());
  OpeningCatalogue<2>               whole(file_of("whole"), shapes, 1e-3),
    begun(file_of("begun"), shapes, 1e-3),
    resumed(file_of("resumed"), shapes, 1e-3);
  const std::vector<double> gaps = {0, 0.3, 0, 0.2, 0.5, 0.4, 0.1, 0, 0};
  for (unsigned int i = 0; i < gaps.size(); ++i)
    {
      // The second opening is at its widest.
      if (i == 5)
        resumed.resume(begun.state());
      // A fault that may not open between them.
      FaultSnapshot<2> bilateral = fault_with_gaps({});
      bilateral.gap.clear();
      for (OpeningCatalogue<2> *catalogue : {&whole, i < 5 ? &begun : &resumed})
        catalogue->add(0.7 * i, {bilateral, fault_with_gaps({0, gaps[i], 0})});
    }
  EXPECT_EQ(whole.entries().size(), 2u);
  EXPECT_EQ(content_of(file_of("resumed")), content_of(file_of("whole")));
}



TEST(OpeningCatalogue, WritesWhatIsOpenAtTheEndAndMayBeginOpen)
{
  const TemporaryFolder folder;
  // The default is 1e-8 of 15 m.
  OpeningCatalogue<2> catalogue(folder.file("a.csv"), {sloping_shape()}, 0);
  catalogue.add(2, {fault_with_gaps({0, 0, 1})});
  catalogue.add(3, {fault_with_gaps({0, 0, 1.4e-7})});
  EXPECT_TRUE(catalogue.entries().empty());
  catalogue.add(4, {fault_with_gaps({0, 0, 0.7e-7})});
  ASSERT_EQ(catalogue.entries().size(), 1u);
  EXPECT_EQ(catalogue.entries()[0].opens, 2);
  catalogue.add(5, {fault_with_gaps({0, 0, 1.6e-7})});
  catalogue.finish();
  catalogue.finish();
  ASSERT_EQ(catalogue.entries().size(), 2u);
  EXPECT_TRUE(std::isnan(catalogue.entries()[1].closes));
  EXPECT_NE(lines_of(folder.file("a.csv")).back().find(",5,nan,"),
            std::string::npos);
  EXPECT_THROW(OpeningCatalogue<2>(folder.file("no/a.csv"), {}, 0), InputError);
}
