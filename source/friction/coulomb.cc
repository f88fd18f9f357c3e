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



  double
  CoulombLaw::coefficient(const double, const double) const
  {
    return mu;
  }



  double
  CoulombLaw::derivative(const double, const double) const
  {
    return 0.;
  }



  double
  CoulombLaw::potential(const double V, const double) const
  {
    return mu * V;
  }



  double
  CoulombLaw::minimiser(const double c,
                        const double r,
                        const double k,
                        const double) const
  {
    return std::max(0., (r - k * mu) / c);
  }



  FrictionlessLaw::FrictionlessLaw(const LawValues &)
    : CoulombLaw(0.)
  {}



  LawKind
  FrictionlessLaw::kind()
  {
    LawKind kind             = {"frictionless", "nothing", {}};
    kind.needs_normal_stress = false;
    return kind;
  }
} // namespace StickSlip
