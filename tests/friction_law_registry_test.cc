// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/coulomb.h>
#include <stickslip/friction/friction_parameters.h>
#include <stickslip/friction/law_registry.h>
#include <stickslip/friction/rate_and_state.h>

#include <stdexcept>


using namespace StickSlip;

namespace
{
  /** A parameter that is as it should be. */
  LawParameter
  exponent()
  {
    return LawParameter::field(
      "Exponent", "Exponent n", "1", NumberRange().above(0).at_most(1), 0.5);
  }



  /** A kind whose law is Coulomb's, with the mean of some parameters as its
   * coefficient. */
  LawKind
  kind_with(const std::vector<LawParameter> &listed,
            const std::vector<LawParameter> &read)
  {
    LawKind kind  = {"new", "a formula", listed};
    kind.make_law = [read](const LawValues &values) {
      double sum = 0;
      for (const LawParameter &parameter : read)
        sum += values[parameter] / read.size();
      return std::make_shared<const CoulombLaw>(sum);
    };
    return kind;
  }



  /** Complaint of a registry of some kinds. */
  std::string
  mistake(const std::vector<LawKind> &kinds)
  {
    try
      {
        LawRegistry registry(kinds);
      }
    catch (const std::logic_error &error)
      {
        return error.what();
      }
    return "";
  }



  std::string
  mistake(const LawParameter &parameter)
  {
    return mistake({kind_with({parameter}, {parameter})});
  }



  const std::string prefix = "The kind of friction 'new': ";
} // namespace



TEST(LawRegistry, TakesKindsThatLackNothing)
{
  EXPECT_EQ(mistake(exponent()), "");
  EXPECT_EQ(mistake({kind_of_law<CoulombLaw>(),
                     kind_with({exponent()}, {exponent()}),
                     kind_of_law<RateAndStateLaw>()}),
            "");
}



TEST(LawRegistry, RefusesAParameterThatIsNotListed)
{
  EXPECT_EQ(mistake({kind_with({}, {exponent()})}),
            prefix + "the parameter 'Exponent' is read, but not listed.");
}



TEST(LawRegistry, RefusesAParameterThatIsNotRead)
{
  const LawParameter mu_0 = CommonParameters::reference_friction();
  EXPECT_EQ(mistake({kind_with({mu_0, exponent()}, {mu_0})}),
            prefix + "the parameter 'Exponent' is listed, but not read.");
}



TEST(LawRegistry, RefusesAParameterOfWhichSomethingIsNotSaid)
{
  LawParameter parameter  = exponent();
  parameter.documentation = "";
  EXPECT_EQ(mistake(parameter),
            prefix + "the parameter 'Exponent' has no documentation.");
  parameter      = exponent();
  parameter.unit = "";
  EXPECT_EQ(mistake(parameter),
            prefix + "the parameter 'Exponent' has no unit; a number without "
                     "unit has the unit '1'.");
  parameter       = exponent();
  parameter.entry = "";
  EXPECT_EQ(mistake(parameter), prefix + "the parameter '' has no name.");
  parameter               = exponent();
  parameter.default_value = 2;
  EXPECT_EQ(mistake(parameter),
            prefix + "the parameter 'Exponent' has the default value 2, but "
                     "must be a number > 0 and <= 1.");
}



TEST(LawRegistry, RefusesTwoOfOneName)
{
  const LawKind kind = kind_with({exponent()}, {exponent()});
  EXPECT_EQ(mistake({kind, kind}), prefix + "there are two of this name.");

  LawKind      other      = kind;
  LawParameter parameter  = exponent();
  parameter.documentation = "Exponent of something else";
  other.name              = "other";
  other.parameters        = {parameter};
  EXPECT_EQ(mistake({other, kind}),
            prefix + "the parameter 'Exponent' is not the same as that of "
                     "another kind.");
}



TEST(LawRegistry, RefusesAKindOfWhichSomethingIsNotSaid)
{
  LawKind kind = kind_with({exponent()}, {exponent()});
  kind.formula = "";
  EXPECT_EQ(mistake({kind}), prefix + "there is no formula.");
  kind.name = "";
  EXPECT_EQ(mistake({kind}), "The kind of friction '': there is no name.");
}



TEST(LawRegistry, RefusesALawThatDependsOnAStateItDoesNotHave)
{
  LawKind kind   = kind_of_law<RateAndStateLaw>();
  kind.name      = "new";
  kind.has_state = false;
  EXPECT_EQ(mistake({kind}),
            prefix + "the law depends on the state, but has_state is false.");
  kind           = kind_with({exponent()}, {exponent()});
  kind.has_state = true;
  EXPECT_EQ(mistake({kind}),
            prefix +
              "the law does not depend on the state, but has_state is true.");
}



TEST(LawRegistry, HasTheParametersOfAllKindsOnce)
{
  std::vector<std::string> entries;
  for (const LawParameter &parameter : law_registry().parameters())
    entries.push_back(parameter.entry);
  EXPECT_EQ(entries,
            std::vector<std::string>({"a",
                                      "b",
                                      "Reference friction coefficient",
                                      "Reference slip rate",
                                      "Characteristic slip",
                                      "Regularisation",
                                      "State law",
                                      "Initial state",
                                      "Initial slip rate along x",
                                      "Initial slip rate along y",
                                      "Initial shear stress along x",
                                      "Initial shear stress along y",
                                      "Slip rate along x",
                                      "Slip rate along y",
                                      "Slip rate ramp length"}));
}



TEST(LawRegistry, KindsAreAskedWhatTheyAre)
{
  const LawRegistry &registry = law_registry();
  EXPECT_TRUE(registry.kind("rate and state").has_state);
  EXPECT_FALSE(registry.kind("velocity strengthening").has_state);
  EXPECT_TRUE(registry.kind("Coulomb").needs_normal_stress);
  EXPECT_FALSE(registry.kind("frictionless").needs_normal_stress);
  EXPECT_TRUE(registry.kind("frictionless").make_law);
  EXPECT_FALSE(registry.kind("welded").make_law);
  EXPECT_FALSE(registry.kind("prescribed slip rate").make_law);
}



TEST(LawRegistry, LawsAreMadeFromTheirEntries)
{
  FrictionParameters friction;
  friction["a"].set("0.01 + 0.001*x");
  friction["Characteristic slip"].set("1e-4*(1 + x)");
  const auto values =
    friction.law_values<2>({Point<2>(1, 0), Point<2>(2, 0)}, "Faults/fault");
  ASSERT_EQ(values.size(), 2u);
  EXPECT_DOUBLE_EQ(values[1][CommonParameters::characteristic_slip()], 3e-4);
  const auto law = std::dynamic_pointer_cast<const RateAndStateLaw>(
    friction.kind().make_law(values[0]));
  ASSERT_TRUE(law);
  EXPECT_DOUBLE_EQ(law->get_parameters().a, 0.011);
  EXPECT_EQ(law->get_parameters().b, 0.015);
  EXPECT_EQ(law->get_regularisation(), Regularisation::truncated);
}
