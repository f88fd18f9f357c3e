// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/magnitude.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/simulation/initial_balance.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** Slip rate, m/s, faster than what any scene begins with. */
    constexpr double fast = 1.;



    /** True where nothing but friction can hold a node. */
    template <int dim>
    bool
    needs_friction(const FaultNodes<dim>  &faults,
                   const NodeLaws         &laws,
                   const SystemState<dim> &state,
                   const unsigned int      k)
    {
      return faults.in_contact(k) && !laws[k].is_prescribed &&
             magnitude(state.slip_rate[k]) == 0. &&
             (state.is_bonded.empty() || !state.is_bonded[k]) &&
             k < state.balancing_traction.size();
    }



    double
    coefficient(const FaultLaw &law, const double alpha, const double V)
    {
      return law.friction->coefficient(V, law.friction->node_data(alpha));
    }
  } // namespace



  template <int dim>
  InitialBalance
  initial_balance(const FaultNodes<dim>  &faults,
                  const NodeLaws         &laws,
                  const SystemState<dim> &state,
                  const unsigned int      fault)
  {
    InitialBalance balance;
    double         shear_force = 0., normal_force = 0.;
    for (unsigned int k = faults.first_of_fault()[fault];
         k < faults.first_of_fault()[fault + 1];
         ++k)
      {
        if (!needs_friction(faults, laws, state, k))
          continue;
        const double traction = magnitude(state.balancing_traction[k]);
        shear_force += faults.weights()[k] * traction;
        normal_force += faults.weights()[k] * state.normal_stress[k];
        if (!(state.normal_stress[k] > 0.))
          continue;
        const double ratio = traction / state.normal_stress[k];
        if (!balance.is_known || ratio > balance.greatest)
          {
            balance.greatest = ratio;
            balance.node     = k;
          }
        balance.least =
          balance.is_known ? std::min(balance.least, ratio) : ratio;
        balance.is_known = true;
      }
    balance.mean = normal_force > 0. ? shear_force / normal_force :
                                       std::numeric_limits<double>::infinity();
    return balance;
  }



  template <int dim>
  std::vector<std::string>
  what_friction_does_not_hold(const SceneParameters<dim>    &scene,
                              const FaultNodes<dim>         &faults,
                              const std::vector<Point<dim>> &points,
                              const NodeLaws                &laws,
                              const SystemState<dim>        &state)
  {
    std::vector<std::string> sentences;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const InitialBalance balance = initial_balance(faults, laws, state, f);
        if (!balance.is_known)
          continue;
        std::ostringstream text;
        text.precision(3);
        const auto place = [&](const unsigned int k) {
          text << " at (";
          for (unsigned int d = 0; d < dim; ++d)
            text << (d == 0 ? "" : ", ") << points[k][d];
          text << ") m";
        };
        const unsigned int k     = balance.node;
        const FaultLaw    &law   = laws[k];
        const double       alpha = state.alpha.empty() ? 0. : state.alpha[k];
        // Friction that does not grow with the slip rate lets single nodes
        // slip, which their neighbours hold.
        const double not_held =
          law.friction->rate_scale() > 0. ? balance.greatest : balance.mean;
        if (not_held > coefficient(law, alpha, fast))
          {
            text << "'" << scene.faults[f].section()
                 << "': at the start the shear stress is up to "
                 << balance.greatest << " of the normal stress,";
            place(k);
            text << ", which friction does not hold at slip rates of up to "
                 << fast
                 << " m/s, so that the first steps may fail: stresses, "
                    "friction or 'Initial state' are hardly meant so.";
            sentences.push_back(text.str());
            continue;
          }
        for (unsigned int n = faults.first_of_fault()[f];
             n < faults.first_of_fault()[f + 1];
             ++n)
          if (needs_friction(faults, laws, state, n) &&
              state.normal_stress[n] > 0. &&
              laws[n].friction->rate_scale() > 0. &&
              coefficient(laws[n],
                          state.alpha.empty() ? 0. : state.alpha[n],
                          fast) <= 0.)
            {
              text << "'" << scene.faults[f].section()
                   << "/Initial state': leaves no friction at slip rates of up "
                      "to "
                   << fast << " m/s,";
              place(n);
              text << ", so that the first steps may fail.";
              sentences.push_back(text.str());
              break;
            }
      }
    return sentences;
  }



  template decltype(initial_balance<2>) initial_balance<2>;
  template decltype(initial_balance<3>) initial_balance<3>;
  template decltype(what_friction_does_not_hold<2>)
    what_friction_does_not_hold<2>;
  template decltype(what_friction_does_not_hold<3>)
    what_friction_does_not_hold<3>;
} // namespace StickSlip
