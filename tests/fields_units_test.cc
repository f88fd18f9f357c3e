// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/expression_units.h>
#include <stickslip/parameters/point_list.h>
#include <stickslip/parameters/units.h>

#include <sstream>

#include "error_message.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  double
  si(const std::string &text)
  {
    const std::optional<Quantity> quantity = read_quantity(text);
    EXPECT_TRUE(quantity) << text;
    return quantity ? quantity->value : 0.;
  }
} // namespace



TEST(Units, PowersOfTenAreExact)
{
  EXPECT_EQ(si("30 GPa"), 30e9);
  EXPECT_EQ(si("0.1 mm"), 0.1e-3);
  EXPECT_EQ(si("8.1 um"), 8.1e-6);
  EXPECT_EQ(si("41.2 MPa"), 41.2e6);
  EXPECT_EQ(si("1.7e-3 km"), 1.7);
  EXPECT_EQ(si("2.67 g/cm^3"), 2670.);
  EXPECT_EQ(si("1e18 Pa s"), 1e18);
  EXPECT_EQ(si("3.464 km/s"), 3464.);
  EXPECT_EQ(si("-20km"), -20e3);
  EXPECT_EQ(si("  7 \t m "), 7.);
  EXPECT_EQ(si("5e-9"), 5e-9);
  EXPECT_EQ(si("0.3"), 0.3);
}



TEST(Units, YearsHave365Days)
{
  EXPECT_EQ(si("1 yr"), 31536000.);
  EXPECT_EQ(si("100 years"), 3153600000.);
  EXPECT_EQ(si("3 kyr"), 3e3 * 31536000.);
  EXPECT_EQ(si("2 h"), 7200.);
  EXPECT_EQ(si("1 d"), 86400.);
  EXPECT_DOUBLE_EQ(si("35 mm/yr"), 0.035 / 31536000.);
  EXPECT_DOUBLE_EQ(si("35 mm yr^-1"), 0.035 / 31536000.);
  EXPECT_DOUBLE_EQ(si("3.14159265358979 rad"), 3.14159265358979 * 180 / M_PI);
}



TEST(Units, OthersAreNoQuantities)
{
  for (const char *text : {"",
                           "km",
                           "5 mpa",
                           "41.2 MPaa",
                           "5 m/",
                           "5 /m",
                           "5 m^",
                           "5 m^2.5",
                           "5 m^22",
                           "5 m + 1",
                           "5 6",
                           "0x10",
                           "inf",
                           "nan",
                           ". m",
                           "+ m",
                           "x km"})
    EXPECT_FALSE(read_quantity(text)) << text;
  EXPECT_EQ(unknown_unit("41.2 MPaa"), "MPaa");
  EXPECT_EQ(unknown_unit("5 %"), "%");
  EXPECT_EQ(unknown_unit("5 km"), "");
  EXPECT_EQ(unknown_unit("5 * x"), "");
  EXPECT_EQ(unknown_unit("x + 1"), "");
  EXPECT_EQ(units_like("Pa"), "Pa, kPa, MPa, GPa or bar");
}



TEST(Units, DimensionsMustFit)
{
  const NumberRange pressure = NumberRange().above(0).in("Pa");
  EXPECT_TRUE(pressure.match("5"));
  EXPECT_TRUE(pressure.match("5 MPa"));
  EXPECT_TRUE(pressure.match("5 kg m^-1 s^-2"));
  EXPECT_FALSE(pressure.match("5 km"));
  EXPECT_FALSE(pressure.match("-5 MPa"));
  EXPECT_FALSE(pressure.match("1e400 Pa"));
  EXPECT_NE(pressure.mistaken_unit("5 km").find("MPa"), std::string::npos);
  EXPECT_EQ(pressure.mistaken_unit("5 GPa"), "");

  const NumberRange plain = NumberRange().at_least(0);
  EXPECT_TRUE(plain.match("0.5"));
  EXPECT_TRUE(plain.match("3 mm/m"));
  EXPECT_FALSE(plain.match("3 m"));
  EXPECT_FALSE(NumberRange().whole().match("3 m/m"));

  EXPECT_EQ(NumberRange::values("-20 km, 3, 5 cm"),
            (std::vector<double>{-20e3, 3., 0.05}));
  EXPECT_TRUE(NumberRange().in("m").times(3).match("-20 km, 3, 5 cm"));
}



TEST(Units, PointsHaveThem)
{
  EXPECT_TRUE(PointList().match("0 0, 40 km -2 km, 1e3 5 km"));
  EXPECT_FALSE(PointList().match("0 0, 40 km -2 MPa"));
  EXPECT_FALSE(PointList().match("0 0 m m"));
  EXPECT_FALSE(PointList().match("km 0 0"));
  const auto points = PointList::values("0 0, 40 km -2 km, 1e3 5 km");
  EXPECT_EQ(points[1], Point<2>(40e3, -2e3));
  EXPECT_EQ(points[2], Point<2>(1e3, 5e3));
}



TEST(Units, MultiplyInExpressions)
{
  const auto value = [](const std::string &text, const double x) {
    return Expression<2>(text, true).value(Point<2>(x, 0.), 2.);
  };
  EXPECT_EQ(value("if(x < 5 km, 30 GPa, 40 GPa)", 4e3), 30e9);
  EXPECT_EQ(value("if(x < 5 km, 30 GPa, 40 GPa)", 6e3), 40e9);
  EXPECT_EQ(value("(1 + t) MPa", 0.), 3e6);
  EXPECT_EQ(value("1e-9 m/s * (t > 1 s)", 0.), 1e-9);
  EXPECT_EQ(value("max(1 h, 1 d)", 0.), 86400.);
  EXPECT_EQ(value("min(1 mm, 1 m)", 0.), 1e-3);
}



TEST(Units, FieldsHaveThem)
{
  SpatialField field;
  field.describe("Young modulus", NumberRange().above(0).in("Pa"));
  field.set("30 GPa");
  EXPECT_TRUE(field.is_constant());
  EXPECT_EQ(field.constant(), 30e9);
  EXPECT_EQ(field.text(), "3e+10");
  expect_one_sentence_with(message_of([&]() { field.set("5 km"); }),
                           {"'km'", "Pa, kPa, MPa, GPa"});
  expect_one_sentence_with(message_of([&]() { field.set("5 MPaa"); }),
                           {"'MPaa' is no unit"});
}



TEST(AutomaticNumber, IsWrittenAndReadAsAWord)
{
  AutomaticNumber  number = 0.5;
  ParameterHandler prm;
  add_number(prm, "Number", number, NumberRange().above(0).in("s"), "It is.");
  EXPECT_EQ(prm.get("Number"), "auto");
  number.derive(3.);
  EXPECT_EQ(number, 3.);
  prm.set("Number", std::string("2 h"));
  EXPECT_EQ(number, 7200.);
  number.derive(3.);
  EXPECT_EQ(number, 7200.);
  prm.set("Number", std::string("auto"));
  number.derive(3.);
  EXPECT_EQ(number, 3.);
}



namespace
{
  std::string
  mistake(const std::string &expression, const std::string &unit = "Pa")
  {
    const auto of_entry = read_unit(unit);
    return mistake_in_units(expression,
                            of_entry ? of_entry->dimensions : Dimensions(),
                            "!");
  }
} // namespace



TEST(UnitsInExpressions, ThoseThatFitAreTaken)
{
  for (const char *text : {"30 GPa",
                           "if(x < 5 km, 30 GPa, 40 GPa)",
                           "x < 5 km ? 30 GPa : 40e9",
                           "30 GPa + 1e4 * (x - 5 km)",
                           "26e3 * (5 km - y)",
                           "2670 * 9.81 * (1 km - y)",
                           "(26 MPa / (1 km)) * (5 km - y)",
                           "30 GPa * exp(-(x / 5 km)^2)",
                           "30 GPa * (1 + 0.1 * sin(2 * pi * x / (3 km)))",
                           "(x > 5 km) * 30 GPa + (x <= 5 km) * 40 GPa",
                           "(x > 1 km && y < 2 m) * 30 GPa",
                           "max(30 GPa, 1e9 * x, 2 bar)",
                           "-1 * (x - 5 km) kPa",
                           "1e-3 * x MPa",
                           "sqrt((30 GPa) * (1 Pa))",
                           "(1 kg) / ((2 m) * (3 s) * (4 s))",
                           "abs(-3 MPa) + avg(1 Pa, 2 Pa)",
                           "if((x-1 km)^2 + y^2 < (3 km)^2, 1 GPa, 2 GPa)",
                           "1e9 * 3 km",
                           "1e10"})
    EXPECT_EQ(mistake(text), "") << text;
  EXPECT_EQ(mistake("35 mm/yr", "m/s"), "");
  EXPECT_EQ(mistake("(3 km) / (2 s)", "m/s"), "");
  EXPECT_EQ(mistake("0.3 m/s * sin(t / 5)", "m/s"), "");
  EXPECT_EQ(mistake("if(t < 5 yr, 1, 2)", "m/s"), "");
  EXPECT_EQ(mistake("if(abs(x) < 5 km, 0.01, 0.02)", ""), "");
  EXPECT_EQ(mistake("(3 km) / (2 m)", ""), "");
  EXPECT_EQ(mistake("(x - 1 km)^2 + y^2 < (3 km)^2", ""), "");
  EXPECT_EQ(mistake_in_units("abs(x) - 5 km", {}, ""), "");
}



TEST(UnitsInExpressions, OthersAreRefused)
{
  const auto expect = [](const std::string &text,
                         const std::string &words,
                         const std::string &unit = "Pa") {
    EXPECT_NE(mistake(text, unit).find(words), std::string::npos)
      << text << ": " << mistake(text, unit);
  };
  expect("if(x < 5 km, 30 GPa, 2 km)", "in Pa and in m cannot be added");
  expect("if(x < 5 km, 3 m, 2 km)", "values are in m!");
  expect("x < 5 km ? 30 GPa : 2 km", "values are in m!");
  expect("x < 5 km ? 2 km : 30 GPa", "values are in m!");
  expect("x < 5 MPa", "in m and in Pa");
  expect("if(t < 5 km, 1, 2)", "in s and in m");
  expect("30 GPa + 5 km", "in Pa and in m");
  expect("30 GPa + x", "in Pa and in m");
  expect("30 GPa * (x - 5 km)", "values are in kg s^-2!");
  expect("(30 GPa) * (1 km)", "values are in kg s^-2!");
  expect("max(1 GPa, 2 km, 3)", "in Pa and in m");
  expect("1e9 + 5 km", "values are in m!");
  expect("-(5 km)", "values are in m!");
  expect("(x > 5 km) * 3 km", "values are in m!");
  expect("sqrt((3 m) * (2 m))", "values are in m!");
  expect("exp(5 km) * 1 GPa", "takes a number without a unit");
  expect("sin(30 deg) * 1 GPa", "without a unit has one in degrees");
  expect("30 GPa * 2^(3 m)", "without a unit");
  expect("9.81 m/s^2 * 2", "power of the unit 'm/s'");
  expect("2 km ^ 2", "power of the unit 'km'");
  expect("35 mm/yr", "values are in m/s!");
  expect("(5 km)", "values are in m!", "");
  expect("if(x>0, 5 s, 1)", "values are in s!", "m/s");
}
