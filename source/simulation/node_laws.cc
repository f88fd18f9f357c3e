// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/coulomb.h>
#include <stickslip/simulation/fault_rigidity.h>
#include <stickslip/simulation/node_laws.h>

#include <algorithm>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** The shear traction over the slip rate of the waves that a fault radiates
     * from some points of it, Pa s/m: the slip rates of the two sides for a
     * unit of traction add up; a rigid body does not yield. */
    template <int dim>
    std::vector<double>
    radiated_traction(const SceneParameters<dim>    &scene,
                      const unsigned int             fault,
                      const std::vector<Point<dim>> &points)
    {
      if (scene.time.inertia == Inertia::quasi_static)
        return std::vector<double>(points.size(), 0.);
      std::vector<double> traction =
        sum_over_sides(scene, fault, points, [](const Material &material) {
          return 1. / material.shear_impedance();
        });
      for (double &value : traction)
        value = 1. / value;
      return traction;
    }



    /** The law of a kind of friction with the values of one node. */
    FaultLaw
    make_law(const LawKind &kind, const LawValues &values)
    {
      FaultLaw law;
      if (!kind.make_law)
        {
          // The slip rate is known, and friction has no say.
          law.friction      = std::make_shared<const CoulombLaw>(0.);
          law.is_prescribed = true;
          return law;
        }
      law.friction = kind.make_law(values);
      if (kind.has_state)
        law.state_law = state_laws()
                          .at(static_cast<unsigned int>(
                            values[CommonParameters::state_law()]))
                          .law;
      law.characteristic_slip = values[CommonParameters::characteristic_slip()];
      return law;
    }
  } // namespace



  template <int dim>
  NodeLaws
  make_node_laws(const SceneParameters<dim> &scene, const JumpBasis<dim> &basis)
  {
    NodeLaws result;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const std::vector<Point<dim>> &points = basis.faults()[f].slave.points;
        const std::vector<double>      radiated =
          radiated_traction(scene, f, points);
        const unsigned int first = result.of_node.size();
        result.of_node.resize(first + points.size());
        for (const FaultPart &part : scene.faults[f].parts(points))
          {
            // Laws of one kind are the same where all of these are.
            std::map<std::pair<std::vector<double>, double>, unsigned int>
                                         known;
            const LawKind               &kind = part.friction->kind();
            const std::vector<LawValues> values =
              part.friction->law_values(part.select(points), part.section);
            for (unsigned int i = 0; i < values.size(); ++i)
              {
                const double eta = radiated[part.positions[i]];
                const auto [place, is_new] =
                  known.emplace(std::make_pair(values[i].all(), eta),
                                result.laws.size());
                result.of_node[first + part.positions[i]] = place->second;
                if (!is_new)
                  continue;
                result.laws.push_back(make_law(kind, values[i]));
                result.laws.back().shear_impedance = 2. * eta;
                if (scene.time.inertia == Inertia::quasi_dynamic)
                  result.laws.back().radiation_damping = eta;
                result.laws.back().is_frozen_open =
                  part.friction->opening.open_state == OpenState::frozen;
              }
          }
      }
    return result;
  }



  template <int dim>
  std::vector<SlipRates<dim>>
  make_slip_rates(const SceneParameters<dim> &scene)
  {
    std::vector<SlipRates<dim>> result;
    for (const FaultParameters &fault : scene.faults)
      {
        result.emplace_back();
        if (!fault.has_prescribed_slip() &&
            std::none_of(fault.regions.begin(),
                         fault.regions.end(),
                         [](const FrictionRegion &region) {
                           return region.friction.has_prescribed_slip();
                         }))
          continue;
        result.back() = [&fault](const std::vector<Point<dim>> &points) {
          std::vector<std::optional<SlipRate<dim>>> known(points.size());
          for (const FaultPart &part : fault.parts(points))
            {
              if (!part.friction->has_prescribed_slip())
                continue;
              const std::vector<Tensor<1, dim - 1>> rates =
                part.friction->prescribed_slip_rates(part.select(points),
                                                     part.section);
              for (unsigned int i = 0; i < rates.size(); ++i)
                known[part.positions[i]] =
                  SlipRate<dim>{rates[i],
                                part.friction->slip_rate_ramp_length()};
            }
          return known;
        };
      }
    return result;
  }



  template decltype(make_node_laws<2>)  make_node_laws<2>;
  template decltype(make_node_laws<3>)  make_node_laws<3>;
  template decltype(make_slip_rates<2>) make_slip_rates<2>;
  template decltype(make_slip_rates<3>) make_slip_rates<3>;
} // namespace StickSlip
