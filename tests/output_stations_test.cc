// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/output/station_files.h>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  StationTable
  table_of(const std::string &name, const bool is_on_fault)
  {
    StationTable table;
    table.station      = {name, is_on_fault ? "main" : "plus", {7500., 0.}};
    table.is_on_fault  = is_on_fault;
    table.element_size = 24.9999999991;
    table.columns      = {{"slip", "m", "Slip"}, {"state", "log10 s", "State"}};
    return table;
  }
} // namespace



TEST(StationList, TakesNamesPlacesAndPointsApart)
{
  const StationList pattern;
  const std::string text = "fltst_dp075: main 7.5 km 0, far : plus 0 -16e3 2";
  ASSERT_TRUE(pattern.match(text));
  const std::vector<Station> stations = StationList::values(text);
  ASSERT_EQ(stations.size(), 2u);
  EXPECT_EQ(stations[0].name, "fltst_dp075");
  EXPECT_EQ(stations[0].place, "main");
  EXPECT_EQ(stations[0].position, (std::vector<double>{7500., 0.}));
  EXPECT_EQ(stations[1].name, "far");
  EXPECT_EQ(stations[1].place, "plus");
  EXPECT_EQ(stations[1].position, (std::vector<double>{0., -16e3, 2.}));

  // Text of parameters.prm says the same.
  const std::string again = StationList::text(stations);
  ASSERT_TRUE(pattern.match(again)) << again;
  EXPECT_EQ(StationList::text(StationList::values(again)), again);
  EXPECT_TRUE(pattern.match(""));
  EXPECT_TRUE(StationList::values("").empty());

  for (const std::string mistake : {"main 0 0",
                                    "a: main 0",
                                    "a: main 0 0 0 0",
                                    "a: 0 0",
                                    "a b: main 0 0",
                                    ": main 0 0",
                                    "a: main 0 1 GPa",
                                    "a: main x 0",
                                    "../a: main 0 0"})
    EXPECT_FALSE(pattern.match(mistake)) << mistake;
}



TEST(StationFiles, HaveTheFormOfTheBenchmarks)
{
  const TemporaryFolder           folder;
  const OutputDirectory           directory(folder.file("run"));
  const std::vector<StationTable> tables = {table_of("dp075", true),
                                            table_of("far", false)};
  std::vector<FileState>          states;
  {
    StationFiles files(directory, tables, "SEAS Benchmark BP1-QD");
    files.add(0., {{0., 3.9030899869919438}, {1., 2.}});
    states = files.state();
    files.add(5e9, {{1., 1.}, {1., 1.}});
  }
  {
    // As where a run goes on from a checkpoint.
    StationFiles files(directory, tables, states);
    files.add(6307200000.125, {{-3.25, -307.65}, {1e-9, 0.}});
  }
  const std::string beginning =
    "# problem=SEAS Benchmark BP1-QD\n# code=stickslip\n# element_size=25 m\n";
  const std::string columns = "# Column #1 = Time (s)\n# Column #2 = Slip (m)\n"
                              "# Column #3 = State (log10 s)\nt slip state\n";
  EXPECT_EQ(content_of(folder.file("run/stations/dp075.dat")),
            beginning + "# location= on fault main, 7500 0 m\n" + columns +
              "0.0000000000000E+00 0.000000E+00 3.903090E+00\n"
              "6.3072000001250E+09 -3.250000E+00 -3.076500E+02\n");
  EXPECT_EQ(content_of(folder.file("run/stations/far.dat")),
            beginning + "# location= in body plus, 7500 0 m\n" + columns +
              "0.0000000000000E+00 1.000000E+00 2.000000E+00\n"
              "6.3072000001250E+09 1.000000E-09 0.000000E+00\n");
}
