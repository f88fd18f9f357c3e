// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/friction_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  void
  FrictionParameters::add_parameters(ParameterHandler  &prm,
                                     const unsigned int dim)
  {
    add_choice(
      prm,
      "Friction",
      kind,
      {{FrictionKind::rate_and_state, "rate and state"},
       {FrictionKind::velocity_strengthening, "velocity strengthening"},
       {FrictionKind::coulomb, "Coulomb"},
       {FrictionKind::frictionless, "frictionless"},
       {FrictionKind::welded, "welded"},
       {FrictionKind::prescribed_slip_rate, "prescribed slip rate"}},
      "What resists the slip: mu = mu0 + a ln(V/V0) + b ln(V0 theta/L) (rate "
      "and state); mu0 + a ln(V/V0) (velocity strengthening); mu0, a threshold "
      "(Coulomb); nothing (frictionless); there is no slip (welded); or the "
      "slip rate is given (prescribed slip rate). Entries that a kind does not "
      "use have no effect.");
    rate_and_state.add_parameters(prm);
    add_choice(prm,
               "State law",
               state_law,
               {{StateLaw::aging, "aging"}, {StateLaw::slip, "slip"}},
               "Evolution of the state theta: the aging law (Dieterich) or "
               "the slip law (Ruina).");
    add_choice(prm,
               "Regularisation",
               regularisation,
               {{Regularisation::truncated, "truncated"},
                {Regularisation::arcsinh, "arcsinh"}},
               "Friction coefficient as V tends to 0: a max(0, ln(V/Vmin)), or "
               "a asinh(V/(2 Vmin)).");
    add_field(prm,
              "Initial state",
              initial_state,
              NumberRange().above(0),
              "State theta at the start, in s.");
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      add_field(prm,
                std::string("Slip rate along ") + "xy"[axis],
                slip_rate[axis],
                NumberRange(),
                std::string("The prescribed slip rate, that of the upper side "
                            "relative to the lower one along ") +
                  "xy"[axis] + ", in m/s.");
    add_number(prm,
               "Slip rate ramp length",
               slip_rate_ramp_length,
               NumberRange().at_least(0),
               "Time in which the prescribed slip rate grows smoothly from "
               "zero, by half a cosine, in s; 0: it is there from the start.");
  }



  bool
  FrictionParameters::has_state() const
  {
    switch (kind)
      {
        case FrictionKind::rate_and_state:
          return true;
        case FrictionKind::velocity_strengthening:
        case FrictionKind::coulomb:
        case FrictionKind::frictionless:
        case FrictionKind::welded:
        case FrictionKind::prescribed_slip_rate:
          return false;
      }
    AssertThrow(false, ExcInternalError());
    return false;
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  FrictionParameters::prescribed_slip_rates(
    const std::vector<Point<dim>> &points,
    const std::string             &section) const
  {
    std::vector<Tensor<1, dim - 1>> rates(points.size());
    if (kind == FrictionKind::prescribed_slip_rate)
      for (unsigned int axis = 0; axis + 1 < dim; ++axis)
        {
          const std::vector<double> values =
            slip_rate[axis].values(points, section);
          for (unsigned int k = 0; k < points.size(); ++k)
            rates[k][axis] = values[k];
        }
    return rates;
  }



  template <int dim>
  void
  FrictionParameters::check(const std::vector<Point<dim>> &points,
                            const std::string             &section) const
  {
    switch (kind)
      {
        case FrictionKind::rate_and_state:
          rate_and_state.values(points, section);
          initial_state.values(points, section);
          break;
        case FrictionKind::velocity_strengthening:
        case FrictionKind::coulomb:
          rate_and_state.values(points, section);
          break;
        case FrictionKind::frictionless:
        case FrictionKind::welded:
        case FrictionKind::prescribed_slip_rate:
          prescribed_slip_rates(points, section);
          break;
      }
  }



#define STICKSLIP_INSTANTIATE(dim)                               \
  template std::vector<Tensor<1, dim - 1>>                       \
  FrictionParameters::prescribed_slip_rates<dim>(                \
    const std::vector<Point<dim>> &, const std::string &) const; \
  template void FrictionParameters::check<dim>(                  \
    const std::vector<Point<dim>> &, const std::string &) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
