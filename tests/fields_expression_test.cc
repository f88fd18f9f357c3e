// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/parameters/expression.h>

#include <cmath>

using namespace StickSlip;

namespace
{
  double
  value(const std::string &text, const double x = 0.)
  {
    return Expression<2>(text, false).value(Point<2>(x, 0));
  }



  /** Message about an expression that cannot be read. */
  std::string
  mistake(const std::string &text)
  {
    try
      {
        Expression<2> expression(text, true);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }



  const std::string hint = " (it must be one expression in x,y,t)";
} // namespace



TEST(Expression, HasTheFunctionsThatAreDocumented)
{
  EXPECT_EQ(value("if(abs(x) < 1, 0.005, 0.02)", -0.5), 0.005);
  EXPECT_EQ(value("if(abs(x) < 1, 0.005, 0.02)", 1.), 0.02);
  EXPECT_EQ(value("if(0.4, 1, 2)"), 2.);
  EXPECT_EQ(value("if(x, 1, 2)", 0.5), 1.);
  EXPECT_EQ(value("x > -1 && x < 1"), 1.);
  EXPECT_EQ(value("x < -1 || x > 1"), 0.);
  EXPECT_EQ(value("x > 0 ? 1 : 2", 1.), 1.);
  EXPECT_EQ(value("pi"), numbers::PI);
  EXPECT_EQ(value("log(x) - ln(x)", 3.), 0.);
  EXPECT_EQ(value("log10(x)", 100.), 2.);
  EXPECT_EQ(value("int(x)", 1.5), 2.);
  EXPECT_EQ(value("int(x)", -1.6), -2.);
  EXPECT_EQ(value("ceil(x)", 1.2), 2.);
  EXPECT_EQ(value("floor(x)", 1.8), 1.);
  EXPECT_EQ(value("pow(x, 3) - x^3", 2.), 0.);
  EXPECT_EQ(value("sec(x)", 0.3), 1. / std::cos(0.3));
  EXPECT_EQ(value("csc(x)", 0.3), 1. / std::sin(0.3));
  EXPECT_EQ(value("cot(x)", 0.3), 1. / std::tan(0.3));
  EXPECT_EQ(value("erf(x)", 0.3), std::erf(0.3));
  EXPECT_EQ(value("erfc(x)", 0.3), std::erfc(0.3));
  EXPECT_EQ(value("sin (x) + max \t (1, x)", 2.), std::sin(2.) + 2.);
}



TEST(Expression, IsAFunctionOfPositionAndTime)
{
  const Expression<3> sum("x + 10*y + 100*z + 1000*t", true);
  const Expression<3> copy = sum;
  EXPECT_EQ(sum.value(Point<3>(1, 2, 3), 4.), 4321.);
  EXPECT_EQ(copy.value(Point<3>(4, 3, 2), 1.), 1234.);
  EXPECT_EQ(sum.value(Point<3>(1, 2, 3), 4.), 4321.);
  EXPECT_THROW(Expression<2>("z", true), InputError);
  EXPECT_THROW(Expression<2>("t", false), InputError);
}



TEST(Expression, SaysWhereAMistakeIs)
{
  EXPECT_EQ(mistake("1 + q*x"), "Unexpected token \"q\" at character 5" + hint);
  EXPECT_EQ(mistake("sin  (x) + q"),
            "Unexpected token \"q\" at character 12" + hint);
  EXPECT_EQ(mistake("1e-4*("),
            "Unexpected end of expression at the end" + hint);
  EXPECT_EQ(mistake("x +* 2"),
            "Unexpected operator \"*\" at character 4" + hint);
  EXPECT_EQ(mistake("0,5"), "more than one value" + hint);
  EXPECT_EQ(mistake("1; 2"), "more than one value" + hint);
  EXPECT_EQ(mistake(""), "it is empty" + hint);
}



TEST(Expression, MustBeFiniteWhereThatIsChecked)
{
  const Expression<2> inverse("1/x", true);
  EXPECT_EQ(inverse.finite_value(Point<2>(2, 0)), 0.5);
  EXPECT_TRUE(std::isinf(inverse.value(Point<2>(0, 1))));
  try
    {
      inverse.finite_value(Point<2>(0, 1), 3.);
      ADD_FAILURE();
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "its value at (0, 1), t = 3 is not a finite number");
    }
}
