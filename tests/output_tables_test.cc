// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/event_catalogue.h>
#include <stickslip/output/fault_statistics.h>
#include <stickslip/output/time_series.h>

#include <cmath>
#include <sstream>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Three nodes, of which the last has left the contact.
  FaultSnapshot<3>
  known_fault()
  {
    FaultSnapshot<3> fault;
    fault.name   = "main";
    fault.points = {Point<3>(-1, 0, 0), Point<3>(0.5, 0, 0), Point<3>(2, 0, 0)};
    fault.weights        = {1, 3, 0};
    fault.slip           = {Tensor<1, 2>({4, 9}),
                            Tensor<1, 2>({-8, 9}),
                            Tensor<1, 2>({1e9, 0})};
    fault.slip_rate      = {Tensor<1, 2>({3e-6, -4e-6}),
                            Tensor<1, 2>({0, 1e-6}),
                            Tensor<1, 2>({1, 1})};
    fault.shear_traction = {Tensor<1, 2>({100, 7}),
                            Tensor<1, 2>({300, 7}),
                            Tensor<1, 2>({1e9, 0})};
    fault.normal_stress  = {1, 2, 3};
    fault.state          = {10, 20, 1e9};
    return fault;
  }



  std::vector<FaultSnapshot<3>>
  faults_named(const std::vector<std::string> &names)
  {
    std::vector<FaultSnapshot<3>> faults;
    for (const std::string &name : names)
      {
        faults.push_back(known_fault());
        faults.back().name = name;
      }
    return faults;
  }



  // A fault of three nodes that slips with the given rates.
  FaultSnapshot<2>
  slipping_fault(const std::vector<double> &rates, const double slip)
  {
    FaultSnapshot<2> fault;
    for (unsigned int p = 0; p < 3; ++p)
      {
        fault.points.emplace_back(-1. + p, 0.);
        fault.weights.push_back(p == 1 ? 2. : 1.);
        fault.slip_rate.push_back(Tensor<1, 1>({rates[p]}));
        fault.slip.push_back(Tensor<1, 1>({slip}));
        fault.shear_traction.push_back(Tensor<1, 1>());
        fault.normal_stress.push_back(0);
        fault.state.push_back(1);
      }
    return fault;
  }



  // The nodes of such a fault, on faces that are level.
  FaultLayout<2>
  level_shape()
  {
    FaultLayout<2> shape;
    shape.surface.points = slipping_fault({0, 0, 0}, 0).points;
    shape.surface.faces  = {{{0, 1}}, {{1, 2}}};
    shape.surface.normal = Tensor<1, 2>({0, -1});
    shape.axes.assign(3, Tensor<2, 2>(unit_symmetric_tensor<2>()));
    shape.rigidity.assign(3, 3.);
    return shape;
  }



  FaultSnapshot<2>
  evenly_slipping_fault(const double rate, const double slip)
  {
    return slipping_fault({rate, rate, rate}, slip);
  }



  std::vector<std::string>
  split(const std::string &line, const char separator)
  {
    std::vector<std::string> items;
    std::istringstream       stream(line);
    for (std::string item; std::getline(stream, item, separator);)
      items.push_back(item);
    return items;
  }
} // namespace



TEST(FaultStatistics, WeighsNodesAndLeavesOutThoseOffContact)
{
  const FaultStatistics statistics = fault_statistics(known_fault());
  EXPECT_DOUBLE_EQ(statistics.max_slip_rate, 5e-6);
  EXPECT_DOUBLE_EQ(statistics.min_slip_rate, 1e-6);
  EXPECT_DOUBLE_EQ(statistics.mean_slip_rate, 2e-6);
  EXPECT_DOUBLE_EQ(statistics.mean_slip, -5);
  EXPECT_DOUBLE_EQ(statistics.mean_state, 17.5);
  EXPECT_DOUBLE_EQ(statistics.mean_shear_traction, 250);
  EXPECT_EQ(statistics.fastest_node, 0u);
}



TEST(FaultStatistics, AreNotNumbersWithoutContact)
{
  FaultSnapshot<3> fault = known_fault();
  fault.weights          = {0, 0, 0};
  EXPECT_TRUE(std::isnan(fault_statistics(fault).mean_slip_rate));
  EXPECT_TRUE(std::isnan(fault_statistics(fault).max_slip_rate));
}



TEST(TimeSeries, HasTheColumnsAndAllDigits)
{
  const TemporaryFolder folder;
  {
    const std::vector<FaultSnapshot<3>> faults =
      faults_named({"main", "upper-2"});
    TimeSeries<3> series(folder.file("time_series.csv"), faults);
    StepRecord    step;
    step.step                  = 7;
    step.time                  = 1. / 3;
    step.step_size             = 0.1;
    step.rate_state_iterations = 4;
    step.tnnmg_iterations      = 5;
    step.multigrid_cycles      = 15;
    step.fault_error           = 0.5;
    step.body_error            = 0.25;
    series.add(step, {known_fault(), known_fault()});
  }
  const std::vector<std::string> lines =
    split(content_of(folder.file("time_series.csv")), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(
    lines[0],
    "step,time,step_size,rate_state_iterations,tnnmg_iterations,"
    "multigrid_cycles,fault_error,body_error,main.max_slip_rate,"
    "main.mean_slip_rate,main.min_slip_rate,main.mean_slip,main.mean_state,"
    "main.mean_shear_traction,upper-2.max_slip_rate,"
    "upper-2.mean_slip_rate,upper-2.min_slip_rate,upper-2.mean_slip,"
    "upper-2.mean_state,upper-2.mean_shear_traction");
  const std::vector<std::string> row = split(lines[1], ',');
  ASSERT_EQ(row.size(), 20u);
  EXPECT_EQ(row[0], "7");
  EXPECT_EQ(std::stod(row[1]), 1. / 3);
  EXPECT_EQ(std::stod(row[2]), 0.1);
  EXPECT_EQ(row[3] + row[4] + row[5], "4515");
  EXPECT_EQ(row[6] + row[7], "0.50.25");
  EXPECT_DOUBLE_EQ(std::stod(row[8]), 5e-6);
  EXPECT_DOUBLE_EQ(std::stod(row[11]), -5);
  EXPECT_EQ(row[19], row[13]);
}



TEST(TimeSeries, HasTheGapsOfFaultsThatBend)
{
  const TemporaryFolder         folder;
  std::vector<FaultSnapshot<3>> faults = faults_named({"level", "bent"});
  faults[1].largest_gap                = 0.25;
  {
    TimeSeries<3> series(folder.file("a.csv"), faults);
    faults[1].largest_gap = 0.5;
    series.add(StepRecord(), faults);
  }
  const std::vector<std::string> lines =
    split(content_of(folder.file("a.csv")), '\n');
  ASSERT_EQ(lines.size(), 2u);
  const std::vector<std::string> titles = split(lines[0], ',');
  const std::vector<std::string> row    = split(lines[1], ',');
  ASSERT_EQ(titles.size(), 21u);
  EXPECT_EQ(titles.back(), "bent.largest_gap");
  ASSERT_EQ(row.size(), 21u);
  EXPECT_EQ(std::stod(row.back()), 0.5);
}



TEST(TimeSeries, RowsReachTheFileInTheEnd)
{
  const TemporaryFolder folder;
  TimeSeries<3>         series(folder.file("a.csv"), faults_named({"main"}));
  const auto            n_rows = [&]() {
    return split(content_of(folder.file("a.csv")), '\n').size();
  };
  EXPECT_EQ(n_rows(), 1u);
  series.add(StepRecord(), {known_fault()});
  // A checkpoint goes on behind all rows.
  const auto size = series.state().size;
  EXPECT_EQ(size, content_of(folder.file("a.csv")).size());
  EXPECT_EQ(n_rows(), 2u);
  series.add(StepRecord(), {known_fault()});
  series.finish();
  EXPECT_EQ(n_rows(), 3u);
  EXPECT_THROW(TimeSeries<3>(folder.file("no/a.csv"), {}), InputError);
}



TEST(EventCatalogue, InterpolatesInTheLogarithmOfTheSlipRate)
{
  const TemporaryFolder folder;
  EventCatalogue<2>     catalogue(
    folder.file("events.csv"), {"main"}, {level_shape()}, 1e-3, 0.1);
  // Rises tenfold per second from 1e-5, falls tenfold per half second: crosses
  // 1e-3 and 1e-4 between the steps.
  const auto add =
    [&](const double time, const double rate, const double slip) {
      catalogue.add(time, {evenly_slipping_fault(rate, slip)});
    };
  add(0.5, std::pow(10, -4.5), 0);
  add(1.5, std::pow(10, -3.5), 1);
  add(2.5, std::pow(10, -2.5), 3);
  add(3., 1e-2, 4);
  EXPECT_TRUE(catalogue.entries().empty());
  add(3.25, std::pow(10, -2.5), 5);
  add(3.75, std::pow(10, -3.5), 6); // below the start, above the end
  add(4.25, std::pow(10, -4.5), 8);

  ASSERT_EQ(catalogue.entries().size(), 1u);
  const SlipEvent &event = catalogue.entries()[0];
  EXPECT_EQ(event.fault, "main");
  EXPECT_NEAR(event.start, 2., 1e-12);
  EXPECT_NEAR(event.end, 4., 1e-12);
  EXPECT_EQ(event.peak_time, 3.);
  EXPECT_DOUBLE_EQ(event.peak_mean_slip_rate, 1e-2);
  EXPECT_NEAR(event.mean_slip, 7. - 2., 1e-12);

  // The event is in the file already.
  const std::vector<std::string> lines =
    split(content_of(folder.file("events.csv")), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "fault,start,peak_time,end,peak_mean_slip_rate,peak_slip_rate,"
            "mean_slip,nucleation_x,moment,peak_moment_rate,stress_drop,"
            "ruptured_area");
  const std::vector<std::string> row = split(lines[1], ',');
  ASSERT_EQ(row.size(), 12u);
  // Four metres that slip by five, from start to end, at a rigidity of 3 Pa.
  EXPECT_NEAR(std::stod(row[8]), 60., 1e-10);
  EXPECT_NEAR(std::stod(row[9]), 3. * 4. * 1e-2, 1e-12);
  EXPECT_EQ(std::stod(row[10]), 0.);
  EXPECT_EQ(std::stod(row[11]), 4.);
  EXPECT_EQ(row[0], "main");
  EXPECT_EQ(std::stod(row[1]), event.start);
  EXPECT_EQ(std::stod(row[3]), event.end);
}



TEST(EventCatalogue, GoesOnWithinAnEvent)
{
  const TemporaryFolder folder;
  const auto            file_of = [&](const std::string &name) {
    return folder.file(name + ".csv");
  };
  EventCatalogue<2> whole(
    file_of("whole"), {"main"}, {level_shape()}, 1e-3, 0.1),
    begun(file_of("begun"), {"main"}, {level_shape()}, 1e-3, 0.1),
    resumed(file_of("resumed"), {"main"}, {level_shape()}, 1e-3, 0.1);
  const std::vector<double> rates = {
    1e-5, 1e-2, 1e-5, 1e-4, 3e-2, 1e-2, 2e-3, 1e-5};
  // The second event is at its peak.
  constexpr unsigned int n_begun = 5;
  for (unsigned int i = 0; i < rates.size(); ++i)
    {
      if (i == n_begun)
        resumed.resume(begun.state());
      for (EventCatalogue<2> *catalogue :
           {&whole, i < n_begun ? &begun : &resumed})
        catalogue->add(i, {evenly_slipping_fault(rates[i], i * i)});
    }
  EXPECT_EQ(whole.entries().size(), 2u);
  EXPECT_EQ(content_of(file_of("resumed")), content_of(file_of("whole")));
}



TEST(EventCatalogue, FindsWhereAnEventNucleatedAndItsFastestNode)
{
  const TemporaryFolder folder;
  EventCatalogue<2>     catalogue(
    folder.file("events.csv"), {"main"}, {level_shape()}, 1e-3, 0.5);
  double     time = 0;
  const auto add  = [&](const std::vector<double> &rates) {
    catalogue.add(time += 1, {slipping_fault(rates, 0)});
  };
  // The right node is fast for a while, without an event.
  add({0, 0, 0});
  add({0, 0, 2e-3});
  add({0, 0, 1e-5});
  // Then the middle one, and by the time of the event the left one.
  add({1e-5, 1.2e-3, 1e-5});
  add({5e-2, 2e-2, 1e-5});
  add({1e-3, 3e-2, 1e-2});
  add({0, 0, 0});

  ASSERT_EQ(catalogue.entries().size(), 1u);
  const SlipEvent &event = catalogue.entries()[0];
  EXPECT_EQ(event.nucleation, std::vector<double>{0});
  EXPECT_EQ(event.peak_slip_rate, 5e-2);
  EXPECT_DOUBLE_EQ(event.peak_mean_slip_rate, (5e-2 + 4e-2 + 1e-5) / 4);
  EXPECT_EQ(event.peak_time, 5);
  EXPECT_GT(event.start, 4);
  EXPECT_LT(event.start, 5);
  // From 1.8e-2 to rest, whose logarithm stands for the smallest number.
  EXPECT_GT(event.end, 6);
  EXPECT_LT(event.end, 6.1);
}



TEST(EventCatalogue, KeepsFaultsApartAndWritesAnOpenEventAtTheEnd)
{
  const TemporaryFolder folder;
  EventCatalogue<2>     catalogue(folder.file("events.csv"),
                              {"lower", "upper"},
                              {level_shape(), level_shape()},
                              1e-3,
                              0.5);
  const auto            add =
    [&](const double time, const double lower, const double upper) {
      catalogue.add(time,
                    {evenly_slipping_fault(lower, 10 * time),
                     evenly_slipping_fault(upper, 20 * time)});
    };
  // Two events of the lower fault; one of the upper, which lasts.
  add(0, 1e-4, 1e-4);
  add(1, 1e-2, 1e-4);
  add(2, 7e-4, 1e-4); // between end and start threshold: still the first
  add(3, 2e-3, 1e-4);
  add(4, 1e-4, 1e-2);
  add(5, 1e-1, 1e-3);
  add(6, 1e-5, 2e-3);
  ASSERT_EQ(catalogue.entries().size(), 2u);
  EXPECT_EQ(catalogue.entries()[0].fault, "lower");
  EXPECT_NEAR(catalogue.entries()[0].start, 0.5, 1e-12);
  EXPECT_NEAR(catalogue.entries()[1].start, 4. + 1. / 3, 1e-12);
  EXPECT_DOUBLE_EQ(catalogue.entries()[1].peak_mean_slip_rate, 1e-1);

  catalogue.finish();
  catalogue.finish();
  ASSERT_EQ(catalogue.entries().size(), 3u);
  const SlipEvent &last = catalogue.entries()[2];
  EXPECT_EQ(last.fault, "upper");
  EXPECT_NEAR(last.start, 3.5, 1e-12);
  EXPECT_TRUE(std::isnan(last.end));
  EXPECT_EQ(last.peak_time, 4);
  EXPECT_NEAR(last.mean_slip, 20 * 2.5, 1e-12);
  const std::vector<std::string> lines =
    split(content_of(folder.file("events.csv")), '\n');
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(split(lines[3], ',')[3], "nan");
}



TEST(EventCatalogue, AnEventMayBeUnderWayAtTheStart)
{
  const TemporaryFolder folder;
  EventCatalogue<2>     catalogue(
    folder.file("events.csv"), {"main"}, {level_shape()}, 1e-3, 0.5);
  catalogue.add(2, {evenly_slipping_fault(1, 0)});
  catalogue.add(3, {evenly_slipping_fault(1e-6, 1)});
  ASSERT_EQ(catalogue.entries().size(), 1u);
  EXPECT_EQ(catalogue.entries()[0].start, 2);
  EXPECT_EQ(catalogue.entries()[0].nucleation, std::vector<double>{-1});
}
