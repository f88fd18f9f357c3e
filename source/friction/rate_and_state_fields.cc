// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/rate_and_state_fields.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  RateAndStateFields::add_parameters(ParameterHandler &prm)
  {
    add_field(prm,
              "a",
              a,
              NumberRange().above(0),
              "Direct effect a of the slip rate in mu = mu0 + a ln(V/V0) + b "
              "ln(V0 theta/L), without unit.");
    add_field(prm,
              "b",
              b,
              NumberRange().at_least(0),
              "Evolution effect b of the state, without unit. The fault can "
              "be unstable only if b > a.");
    add_field(prm,
              "Reference friction coefficient",
              reference_friction,
              NumberRange().at_least(0),
              "Friction coefficient mu0 at the reference slip rate, without "
              "unit.");
    add_field(prm,
              "Reference slip rate",
              reference_slip_rate,
              NumberRange().above(0),
              "Reference slip rate V0, in m/s.");
    add_field(prm,
              "Characteristic slip",
              characteristic_slip,
              NumberRange().above(0),
              "Slip L over which the state evolves, in m.");
  }



  template <int dim>
  std::vector<RateAndStateParameters>
  RateAndStateFields::values(const std::vector<Point<dim>> &points,
                             const std::string             &section) const
  {
    const std::vector<double> a_values = a.values(points, section);
    const std::vector<double> b_values = b.values(points, section);
    const std::vector<double> mu_0 = reference_friction.values(points, section);
    const std::vector<double> V_0 = reference_slip_rate.values(points, section);
    const std::vector<double> L   = characteristic_slip.values(points, section);
    std::vector<RateAndStateParameters> result;
    result.reserve(points.size());
    for (unsigned int k = 0; k < points.size(); ++k)
      result.push_back({a_values[k], b_values[k], mu_0[k], V_0[k], L[k]});
    return result;
  }



  RateAndStateParameters
  RateAndStateFields::constants() const
  {
    return {a.constant(),
            b.constant(),
            reference_friction.constant(),
            reference_slip_rate.constant(),
            characteristic_slip.constant()};
  }



  template std::vector<RateAndStateParameters>
  RateAndStateFields::values(const std::vector<Point<2>> &,
                             const std::string &) const;
  template std::vector<RateAndStateParameters>
  RateAndStateFields::values(const std::vector<Point<3>> &,
                             const std::string &) const;
} // namespace StickSlip
