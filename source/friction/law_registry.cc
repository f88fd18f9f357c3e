// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/coulomb.h>
#include <stickslip/friction/law_registry.h>
#include <stickslip/friction/rate_and_state.h>

#include <algorithm>
#include <stdexcept>

namespace StickSlip
{
  namespace
  {
    /** Kinds whose slip rate is known. */
    LawKind
    welded_kind()
    {
      return {"welded", "there is no slip", {}, false, false};
    }



    LawKind
    prescribed_slip_rate_kind()
    {
      return {"prescribed slip rate",
              "the slip rate is given",
              {CommonParameters::slip_rate(0),
               CommonParameters::slip_rate(1),
               CommonParameters::slip_rate_ramp_length()},
              false,
              false};
    }
  } // namespace



  const LawRegistry &
  law_registry()
  {
    // The kinds of friction, in the order in which they are documented.
    static const LawRegistry registry(
      {kind_of_law<RateAndStateLaw>(),
       RateAndStateLaw::velocity_strengthening_kind(),
       kind_of_law<CoulombLaw>(),
       CoulombLaw::frictionless_kind(),
       welded_kind(),
       prescribed_slip_rate_kind()});
    return registry;
  }



  namespace
  {
    [[noreturn]] void
    refuse(const std::string &kind, const std::string &mistake)
    {
      throw std::logic_error("The kind of friction '" + kind + "': " + mistake +
                             ".");
    }



    /** The law with the default values of some parameters. */
    std::shared_ptr<const FrictionLaw>
    default_law(const LawKind                   &kind,
                const std::vector<LawParameter> &parameters)
    {
      std::vector<double> values;
      for (const LawParameter &parameter : parameters)
        values.push_back(parameter.default_value);
      return kind.make_law(LawValues(parameters, values));
    }



    /** Check that the law reads all parameters that its kind lists. */
    void
    check_that_all_are_read(const LawKind &kind)
    {
      for (unsigned int i = 0; i < kind.parameters.size(); ++i)
        {
          std::vector<LawParameter> others = kind.parameters;
          others.erase(others.begin() + i);
          bool is_read = false;
          try
            {
              default_law(kind, others);
            }
          catch (const std::logic_error &)
            {
              is_read = true;
            }
          if (!is_read)
            refuse(kind.name,
                   "the parameter '" + kind.parameters[i].entry +
                     "' is listed, but not read");
        }
    }



    void
    check_law(const LawKind &kind)
    {
      std::shared_ptr<const FrictionLaw> law;
      try
        {
          law = default_law(kind, kind.parameters);
        }
      catch (const std::logic_error &error)
        {
          refuse(kind.name, error.what());
        }
      check_that_all_are_read(kind);
      const bool depends_on_state = law->node_data(0.) != law->node_data(1.);
      if (depends_on_state && !kind.has_state)
        refuse(kind.name,
               "the law depends on the state, but has_state is false");
      if (!depends_on_state && kind.has_state)
        refuse(kind.name,
               "the law does not depend on the state, but has_state is true");
    }
  } // namespace



  LawRegistry::LawRegistry(const std::vector<LawKind> &kinds)
  {
    for (LawKind kind : kinds)
      {
        if (kind.name.empty())
          refuse(kind.name, "there is no name");
        if (kind.formula.empty())
          refuse(kind.name, "there is no formula");
        if (std::any_of(known_kinds.begin(),
                        known_kinds.end(),
                        [&kind](const LawKind &other) {
                          return other.name == kind.name;
                        }))
          refuse(kind.name, "there are two of this name");
        for (const LawParameter &parameter : kind.parameters)
          add(parameter, kind.name);
        if (kind.make_law)
          {
            check_law(kind);
            const LawParameter slip = CommonParameters::characteristic_slip();
            add(slip, kind.name);
            if (std::find(kind.parameters.begin(),
                          kind.parameters.end(),
                          slip) == kind.parameters.end())
              kind.parameters.push_back(slip);
          }
        if (kind.has_state)
          {
            add(CommonParameters::state_law(), kind.name);
            add(CommonParameters::initial_state(), kind.name);
            kind.parameters.push_back(CommonParameters::state_law());
          }
        if (kind.make_law)
          for (const auto &parameter : {CommonParameters::initial_slip_rate,
                                        CommonParameters::initial_shear_stress})
            for (unsigned int axis = 0; axis < 2; ++axis)
              add(parameter(axis), kind.name);
        known_kinds.push_back(kind);
      }
  }



  void
  LawRegistry::add(const LawParameter &parameter, const std::string &kind)
  {
    if (const std::string mistake = parameter.mistake(); !mistake.empty())
      refuse(kind, "the parameter '" + parameter.entry + "' " + mistake);
    const auto place = std::find_if(known_parameters.begin(),
                                    known_parameters.end(),
                                    [&parameter](const LawParameter &other) {
                                      return other.entry == parameter.entry;
                                    });
    if (place == known_parameters.end())
      known_parameters.push_back(parameter);
    else if (!(*place == parameter))
      refuse(kind,
             "the parameter '" + parameter.entry +
               "' is not the same as that of another kind");
  }



  const LawKind &
  LawRegistry::kind(const std::string &name) const
  {
    const auto place =
      std::find_if(known_kinds.begin(),
                   known_kinds.end(),
                   [&name](const LawKind &kind) { return kind.name == name; });
    AssertThrow(place != known_kinds.end(), ExcMessage("No kind is " + name));
    return *place;
  }
} // namespace StickSlip
