// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/coulomb.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  CoulombLaw::CoulombLaw(const double coefficient)
    : mu(coefficient)
  {
    AssertThrow(mu >= 0. && std::isfinite(mu),
                dealii::ExcMessage("A friction coefficient must be a number "
                                   "that is not negative."));
  }



  CoulombLaw::CoulombLaw(const LawValues &values)
    : CoulombLaw(values[CommonParameters::reference_friction()])
  {}



  LawKind
  CoulombLaw::kind()
  {
    return {"Coulomb",
            "mu0, a threshold",
            {CommonParameters::reference_friction()}};
  }



  LawKind
  CoulombLaw::frictionless_kind()
  {
    return {"frictionless", "nothing", {}, false, false, [](const LawValues &) {
              return std::make_shared<const CoulombLaw>(0.);
            }};
  }
} // namespace StickSlip
