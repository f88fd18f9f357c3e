// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/expression.h>
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
