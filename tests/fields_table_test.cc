// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/parameters/spatial_field.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "error_message.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Reading a table with this content must fail with these parts.
  void
  expect_table_error(const std::string              &content,
                     const std::vector<std::string> &parts)
  {
    const TemporaryFolder folder;
    const std::string     file = folder.write("table.txt", content);
    expect_one_sentence_with(message_of([&]() { GridTable table(file); }),
                             parts);
  }



  SpatialField
  make_field(const std::string &text, const NumberRange &range = NumberRange())
  {
    SpatialField field;
    field.describe("a", range);
    field.set(text);
    return field;
  }



  double
  bilinear(const double x, const double y)
  {
    return 3. - 2. * x + 0.5 * y + 4. * x * y;
  }



  // The rows of a function on an uneven grid, in disorder.
  std::string
  shuffled_rows(const std::vector<std::vector<double>> &points,
                const std::vector<double>              &values)
  {
    std::vector<std::string> rows;
    for (unsigned int r = 0; r < points.size(); ++r)
      {
        std::string row;
        for (const double x : points[r])
          row += shortest_form(x) + "\t";
        rows.push_back(row + shortest_form(values[r]) + "  # a comment\n");
      }
    std::shuffle(rows.begin(), rows.end(), std::mt19937(7));
    std::string text;
    for (const std::string &row : rows)
      text += row + "\n";
    return text;
  }



  const std::vector<double> x_grid = {-1., -0.3, 0.1, 2.};
  const std::vector<double> y_grid = {0., 0.25, 1.};
} // namespace



TEST(GridTable, InterpolatesABilinearFunctionExactly)
{
  std::vector<std::vector<double>> points;
  std::vector<double>              values;
  for (const double x : x_grid)
    for (const double y : y_grid)
      {
        // The columns of this table are y and x.
        points.push_back({y, x});
        values.push_back(bilinear(x, y));
      }
  const TemporaryFolder folder;
  const GridTable       table(
    folder.write("t.txt",
                 "# first a comment\n\ny x\n" + shuffled_rows(points, values)));
  EXPECT_EQ(table.axes(), (std::vector<unsigned int>{1, 0}));

  std::mt19937                           generator(3);
  std::uniform_real_distribution<double> random(0., 1.);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const double x = -1. + 3. * random(generator), y = random(generator);
      EXPECT_NEAR(table.value(Point<2>(x, y)), bilinear(x, y), 1e-13);
      EXPECT_NEAR(table.value(Point<3>(x, y, 77.)), bilinear(x, y), 1e-13);
    }
  // The values on the grid come back in every bit.
  for (unsigned int r = 0; r < points.size(); ++r)
    EXPECT_EQ(table.value(Point<2>(points[r][1], points[r][0])), values[r]);
}



TEST(GridTable, GoesOnWithTheValuesAtItsEnds)
{
  const TemporaryFolder folder;
  const GridTable       line(folder.write("x.txt", "x\n2 20\n1 10\n4 0\n"));
  EXPECT_EQ(line.value(Point<2>(-9., 5.)), 10.);
  EXPECT_EQ(line.value(Point<2>(1.5, -5.)), 15.);
  EXPECT_EQ(line.value(Point<2>(3., 0.)), 10.);
  EXPECT_EQ(line.value(Point<2>(1e9, 0.)), 0.);

  const GridTable plane(
    folder.write("xz.txt", "x z\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n"));
  EXPECT_EQ(plane.value(Point<3>(0.5, 9., -3.)), 1.5);
  EXPECT_EQ(plane.value(Point<3>(-1., 9., 0.5)), 2.);
  EXPECT_EQ(plane.value(Point<3>(5., 9., 5.)), 4.);
}



TEST(GridTable, InterpolatesATrilinearFunctionExactly)
{
  const auto f = [](const double x, const double y, const double z) {
    return 1. + x - y * z + 3. * x * y * z;
  };
  std::vector<std::vector<double>> points;
  std::vector<double>              values;
  for (const double x : x_grid)
    for (const double y : y_grid)
      for (const double z : {-2., 1.})
        {
          points.push_back({z, x, y});
          values.push_back(f(x, y, z));
        }
  const TemporaryFolder folder;
  const GridTable       table(
    folder.write("t.txt", "z x y\n" + shuffled_rows(points, values)));
  for (const double x : {-0.9, 0., 1.7})
    for (const double y : {0.1, 0.9})
      for (const double z : {-1.5, 0.5})
        EXPECT_NEAR(table.value(Point<3>(x, y, z)), f(x, y, z), 1e-13);
}



TEST(GridTable, TheFirstLineMayHaveUnits)
{
  const TemporaryFolder folder;
  const GridTable       table(
    folder.write("t.txt",
                 "# layers\n x(km)  y (m) value ( kPa ) # of the top\n"
                       "0.1 1 7\n0.1 2 8\n4.1 1 9\n4.1 2 10\n"));
  EXPECT_EQ(table.unit(), "kPa");
  // Exactly as numbers with a unit.
  EXPECT_EQ(table.value(Point<2>(100., 1.)), 7e3);
  EXPECT_EQ(table.value(Point<2>(4100., 2.)), 10e3);
  EXPECT_DOUBLE_EQ(table.value(Point<2>(2100., 1.5)), 8.5e3);

  const GridTable plain(folder.write("p.txt", "x value\n1 10\n2 20\n"));
  EXPECT_EQ(plain.unit(), "");
  EXPECT_EQ(plain.value(Point<2>(2., 0.)), 20.);

  expect_table_error("x (GPa)\n0 1\n1 2\n",
                     {"line 1", "'GPa' is a unit of something else", "km"});
  expect_table_error("x (kmm)\n0 1\n1 2\n", {"line 1", "'kmm' is no unit"});
  expect_table_error("x value (m^)\n0 1\n1 2\n", {"'m^' is no unit"});
  expect_table_error("value x\n0 1\n1 2\n", {"'value' is no coordinate"});
  expect_table_error("x value y\n0 1 1\n", {"'y' stands behind 'value'"});
  expect_table_error("x (km\n0 1\n1 2\n", {"line 1", "cannot be read"});
  expect_table_error("(km) x\n0 1\n1 2\n", {"line 1", "cannot be read"});
}



TEST(GridTable, MistakesAreNamedWithFileAndLine)
{
  expect_one_sentence_with(message_of(
                             []() { GridTable table("nowhere/none.txt"); }),
                           {"nowhere/none.txt", "does not exist"});
  expect_table_error("", {"table.txt", "no values"});
  expect_table_error("# only this\nx y\n", {"table.txt", "no values"});
  expect_table_error("0 1\n1 2\n",
                     {"table.txt, line 1", "'0' is no coordinate"});
  expect_table_error("\nx x\n", {"line 2", "x is named twice"});
  expect_table_error("xy\n", {"line 1", "'xy' is no coordinate"});
  expect_table_error("x\n0 1\n1\n",
                     {"line 3", "1 columns", "must be 2", "x and the value"});
  expect_table_error("x y\n0 1\n",
                     {"line 2", "2 columns", "x y and the value"});
  expect_table_error("x\n0 1 2\n", {"line 2", "3 columns", "must be 2"});
  expect_table_error("x\n0 1\n1 one\n", {"line 3", "'one' is not a number"});
  expect_table_error("x\n0 1\ninf 2\n", {"line 3", "'inf' is not a number"});
  expect_table_error("x\n0 1\n1,5 2\n", {"line 3", "'1,5' is not a number"});
  expect_table_error("x\n0 1\n1 2\n# here\n0.0 1\n",
                     {"line 5", "x = 0 is given", "first in line 2"});
  expect_table_error("x y\n0 0 1\n0 1 1\n1 1 1\n",
                     {"table.txt:", "no value at x = 1, y = 0"});
  // Points that lie on no grid; one of all their coordinates would be huge.
  std::ostringstream scattered;
  scattered << "x y z\n";
  for (unsigned int i = 0; i < 3000; ++i)
    scattered << i << ' ' << i << ' ' << i << " 1\n";
  expect_table_error(scattered.str(), {"no value at x = 0, y = 0, z = 1"});
  expect_table_error("x y\n0 1 1\n1 1 1\n",
                     {"table.txt:", "only one value of y", "at least two"});
}



TEST(SpatialField, IsANumberAnExpressionOrATable)
{
  SpatialField field = make_field(" 2e-5 ");
  EXPECT_TRUE(field.is_constant());
  EXPECT_EQ(field.constant(), 2e-5);
  EXPECT_EQ(field.text(), "2e-05");

  field.set("1 + x*y");
  EXPECT_FALSE(field.is_constant());
  EXPECT_EQ(field.text(), "1 + x*y");
  EXPECT_EQ(field.values<2>({Point<2>(2, 3), Point<2>(0, 1)}, "S"),
            (std::vector<double>{7., 1.}));
  EXPECT_EQ(make_field("z^2").values<3>({Point<3>(2, 3, 4)}, "S"),
            (std::vector<double>{16.}));

  const TemporaryFolder folder;
  const std::string     file = folder.write("t.txt", "x\n0 1\n1 2\n");
  field.set("table " + file);
  EXPECT_EQ(field.text(), "table " + file);
  EXPECT_EQ(field.values<2>({Point<2>(0.5, 3)}, "S"),
            (std::vector<double>{1.5}));
  // A text set again does not read the file again.
  folder.write("t.txt", "nonsense");
  EXPECT_NO_THROW(field.set(field.text()));
  // An error changes nothing.
  EXPECT_THROW(field.set("table none.txt"), InputError);
  EXPECT_EQ(field.text(), "table " + file);

  field = 0.1 + 0.2;
  EXPECT_TRUE(field.is_constant());
  EXPECT_EQ(field.text(), shortest_form(0.1 + 0.2));
}



TEST(SpatialField, MistakesNameEntryValueAndPosition)
{
  const std::vector<Point<2>> points = {Point<2>(0., 1.), Point<2>(-0.5, 1.)};
  const auto message = [&](const std::string &text, const NumberRange &range) {
    const SpatialField field = make_field(text, range);
    return message_of([&]() { field.values(points, "Faults/main"); });
  };
  expect_one_sentence_with(message("x", NumberRange().at_least(0)),
                           {"'Faults/main/a' = 'x'",
                            "is -0.5 at (-0.5, 1) m",
                            "a number >= 0 everywhere"});
  expect_one_sentence_with(message("1/x", NumberRange()),
                           {"is inf at (0, 1) m"});
  expect_one_sentence_with(message("sqrt(x)", NumberRange()),
                           {"nan at (-0.5, 1) m"});
  expect_one_sentence_with(message("0.1*speed", NumberRange()),
                           {"'Faults/main/a' = '0.1*speed'",
                            "cannot be used",
                            "speed"});
  expect_one_sentence_with(message("t", NumberRange()),
                           {"cannot be used", "x,y)"});
  expect_one_sentence_with(message("0,5", NumberRange()),
                           {"more than one value"});
  expect_one_sentence_with(message_of([]() { make_field("table"); }),
                           {"name of a file"});

  const TemporaryFolder folder;
  const std::string file = folder.write("u.txt", "x value (km)\n0 1\n1 2\n");
  expect_one_sentence_with(
    message_of([&]() { make_field("table " + file, NumberRange().in("Pa")); }),
    {"u.txt", "'km' is a unit of something else", "GPa"});
  EXPECT_EQ(make_field("table " + file, NumberRange().in("m"))
              .values<2>({Point<2>(0.5, 0.)}, "S"),
            (std::vector<double>{1500.}));
  const SpatialField table =
    make_field("table " + folder.write("t.txt", "z\n0 1\n1 2\n"));
  expect_one_sentence_with(message_of([&]() { table.values(points, "S"); }),
                           {"'S/a' = 'table ", "depends on z", "x and y"});
  EXPECT_EQ(table.values<3>({Point<3>(9, 9, 0.25)}, "S"),
            (std::vector<double>{1.25}));
}



TEST(SpatialField, PathsOfTablesBeginInTheGivenFolder)
{
  EXPECT_EQ(SpatialField::with_absolute_path("table b/../t 1.txt", "/f/g"),
            "table /f/g/t 1.txt");
  EXPECT_EQ(SpatialField::with_absolute_path("table\t/h/t.txt", "/f"),
            "table /h/t.txt");
  EXPECT_EQ(SpatialField::with_absolute_path("table t.txt", ""),
            "table " + (std::filesystem::current_path() / "t.txt").string());
  for (const std::string text : {"1.5", "x*y", "table", "tables t.txt"})
    EXPECT_EQ(SpatialField::with_absolute_path(text, "/f"), text);
}
