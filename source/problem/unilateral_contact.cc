// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/magnitude.h>
#include <stickslip/base/time_resolution.h>
#include <stickslip/problem/unilateral_contact.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  template <int dim>
  UnilateralContact<dim>::UnilateralContact(
    const FaultNodes<dim>          &faults,
    const std::vector<NodeOpening> &nodes,
    const std::vector<double>      &offset)
    : faults(&faults)
    , nodes(nodes)
    , offset(offset)
  {
    if (is_needed())
      {
        AssertDimension(nodes.size(), faults.size());
        AssertDimension(offset.size(), faults.size());
      }
  }



  template <int dim>
  std::vector<double>
  UnilateralContact<dim>::bounds(const SystemState<dim> &from,
                                 const GapPath          &path) const
  {
    std::vector<double> result(faults->size(), 0.);
    for (unsigned int k = 0; k < result.size(); ++k)
      if (const double gap = from.gap[k] + path.of_start * from.opening_rate[k];
          may_open(k) && gap != 0.)
        result[k] = -gap / path.of_end;
    return result;
  }



  template <int dim>
  std::vector<double>
  UnilateralContact<dim>::cohesion(const SystemState<dim> &from) const
  {
    std::vector<double> result(faults->size(), 0.);
    for (unsigned int k = 0; k < result.size(); ++k)
      if (may_open(k) && from.is_bonded[k])
        result[k] = nodes[k].cohesion;
    return result;
  }



  template <int dim>
  void
  UnilateralContact<dim>::add_prestress(NodalVector            &rhs,
                                        const SystemState<dim> &from,
                                        const GapPath          &path) const
  {
    for (const unsigned int k : faults->owned_contact())
      if (may_open(k))
        rhs.local_element(faults->node(k) * dim + dim - 1) -=
          faults->opening_sign(k) * path.n_times * faults->weights()[k] *
          prestress(from, k);
  }



  template <int dim>
  std::vector<bool>
  UnilateralContact<dim>::touching(const std::vector<double> &opening_rates,
                                   const std::vector<double> &bounds) const
  {
    std::vector<bool> result(faults->size(), false);
    for (unsigned int k = 0; k < result.size(); ++k)
      result[k] = may_open(k) && opening_rates[k] == bounds[k];
    return result;
  }



  template <int dim>
  void
  UnilateralContact<dim>::add_landed(std::vector<bool>         &touching,
                                     const SystemState<dim>    &from,
                                     const double               time,
                                     const std::vector<double> &opening_rates,
                                     const GapPath             &path) const
  {
    constexpr double least_part = 1e-6;

    const double shortest = time_resolution(time);
    for (unsigned int k = 0; k < touching.size(); ++k)
      if (may_open(k) && from.gap[k] > 0. && opening_rates[k] < 0.)
        {
          const double way = path.of_start * from.opening_rate[k] +
                             path.of_end * opening_rates[k];
          const double left = from.gap[k] + way;
          touching[k] = touching[k] || left <= least_part * std::abs(way) ||
                        left <= shortest * std::abs(opening_rates[k]);
        }
  }



  template <int dim>
  bool
  UnilateralContact<dim>::has_landed(const SystemState<dim> &state,
                                     const unsigned int      k) const
  {
    const double since = state.touching_since[k];
    return may_open(k) && state.gap[k] == 0. && since > 0. &&
           since > state.time - state.last_step - time_resolution(state.time);
  }



  template <int dim>
  std::vector<double>
  UnilateralContact<dim>::contact_pressure(const SystemState<dim>    &from,
                                           const std::vector<double> &reaction,
                                           const std::vector<bool>   &touching,
                                           const GapPath &path) const
  {
    std::vector<double> result = reaction;
    for (unsigned int k = 0; k < result.size(); ++k)
      {
        result[k] /= path.n_times;
        if (may_open(k))
          result[k] = (touching[k] ? result[k] : 0.) - prestress(from, k);
      }
    return result;
  }



  template <int dim>
  void
  UnilateralContact<dim>::complete(SystemState<dim>          &to,
                                   const SystemState<dim>    &from,
                                   const double               tau,
                                   const std::vector<double> &opening_rates,
                                   const std::vector<bool>   &touching,
                                   const GapPath             &path) const
  {
    to.gap            = from.gap;
    to.opening_rate   = from.opening_rate;
    to.is_bonded      = from.is_bonded;
    to.touching_since = from.touching_since;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (may_open(k))
        {
          // An open node has a gap, whatever rounding leaves of it.
          to.gap[k] =
            touching[k] ?
              0. :
              std::max(from.gap[k] + path.of_start * from.opening_rate[k] +
                         path.of_end * opening_rates[k],
                       std::numeric_limits<double>::min());
          to.opening_rate[k] = (to.gap[k] - from.gap[k]) / tau;

          const NodeOpening &node  = nodes[k];
          const bool         slips = from.is_bonded[k] && node.cohesion > 0. &&
                             magnitude(to.slip_rate[k]) > 0.;
          if (!touching[k] || slips)
            {
              to.is_bonded[k]      = 0;
              to.touching_since[k] = to.time;
            }
          else if (node.bond_healing_time > 0. &&
                   to.time - to.touching_since[k] >= node.bond_healing_time)
            to.is_bonded[k] = 1;
        }
  }



  template <int dim>
  ContactEnergy
  UnilateralContact<dim>::energy(const SystemState<dim> &to,
                                 const SystemState<dim> &from,
                                 const GapPath          &path) const
  {
    ContactEnergy result;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (may_open(k))
        {
          const double growth =
            faults->weights()[k] * (to.gap[k] - from.gap[k]);
          const double mean =
            path.n_times > 1. ?
              to.contact_pressure[k] :
              0.5 * (to.contact_pressure[k] + from.contact_pressure[k]);
          result.lost -= (mean + offset[k]) * growth;
          result.of_offset -= offset[k] * growth;
        }
    return result;
  }



  template class UnilateralContact<2>;
  template class UnilateralContact<3>;
} // namespace StickSlip
