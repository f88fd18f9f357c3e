// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/coulomb.h>
#include <stickslip/simulation/node_laws.h>

#include <algorithm>
#include <array>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** The radiation damping of a fault at some points of it, Pa s/m: the
     * slip rates of the two sides for a unit of traction that they radiate add
     * up; a rigid body does not yield. */
    template <int dim>
    std::vector<double>
    radiation_damping(const SceneParameters<dim>    &scene,
                      const unsigned int             fault,
                      const std::vector<Point<dim>> &points)
    {
      std::vector<double> damping(points.size(), 0.);
      if (scene.time.inertia != Inertia::quasi_dynamic)
        return damping;
      for (const std::vector<BodySide> &side :
           scene.topology.faults()[fault].sides)
        for (const BodySide &part : side)
          {
            const BodyParameters<dim> &body = scene.bodies[part.body];
            if (body.geometry.rigid)
              continue;
            const auto material = body.material.template function<dim>();
            for (unsigned int k = 0; k < points.size(); ++k)
              if (scene.nearest_body(side, points[k]) == part.body)
                damping[k] +=
                  1. / material(body.geometry.within_sides(points[k]))
                         .shear_impedance();
          }
      for (double &value : damping)
        value = 1. / value;
      return damping;
    }



    /** All numbers of a law, those of friction and the radiation damping. Laws
     * of one kind are the same where these are. */
    using Numbers = std::array<double, 6>;

    static_assert(sizeof(RateAndStateParameters) == 5 * sizeof(double),
                  "Each parameter of friction must be among the numbers.");

    Numbers
    numbers(const RateAndStateParameters &p, const double damping)
    {
      return {{p.a,
               p.b,
               p.reference_friction,
               p.reference_slip_rate,
               p.characteristic_slip,
               damping}};
    }



    /** The law of one kind of friction with the parameters of one node. */
    FaultLaw
    make_law(const FrictionParameters &friction, RateAndStateParameters p)
    {
      FaultLaw law;
      law.has_state           = friction.has_state();
      law.state_law           = friction.state_law;
      law.characteristic_slip = p.characteristic_slip;
      law.is_prescribed       = friction.has_prescribed_slip();
      switch (friction.kind)
        {
          case FrictionKind::velocity_strengthening:
            p.b = 0.;
            [[fallthrough]];
          case FrictionKind::rate_and_state:
            law.friction =
              std::make_shared<const RateAndStateLaw>(p,
                                                      friction.regularisation);
            break;
          case FrictionKind::coulomb:
            law.friction =
              std::make_shared<const CoulombLaw>(p.reference_friction);
            break;
          case FrictionKind::frictionless:
          case FrictionKind::welded:
          case FrictionKind::prescribed_slip_rate:
            law.friction = std::make_shared<const CoulombLaw>(0.);
            break;
        }
      AssertThrow(law.friction != nullptr, ExcInternalError());
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
        const std::vector<Point<dim>> &points =
          basis.faults()[f].slave_surface.points;
        const std::vector<double> damping = radiation_damping(scene, f, points);
        const unsigned int        first   = result.of_node.size();
        result.of_node.resize(first + points.size());
        for (const FaultPart &part : scene.faults[f].parts(points))
          {
            std::map<Numbers, unsigned int>           known;
            const std::vector<RateAndStateParameters> parameters =
              part.friction->rate_and_state.values(part.select(points),
                                                   part.section);
            for (unsigned int i = 0; i < parameters.size(); ++i)
              {
                const auto [place, is_new] =
                  known.emplace(numbers(parameters[i],
                                        damping[part.positions[i]]),
                                result.laws.size());
                result.of_node[first + part.positions[i]] = place->second;
                if (!is_new)
                  continue;
                result.laws.push_back(make_law(*part.friction, parameters[i]));
                result.laws.back().radiation_damping =
                  damping[part.positions[i]];
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
                  SlipRate<dim>{rates[i], part.friction->slip_rate_ramp_length};
            }
          return known;
        };
      }
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                    \
  template NodeLaws make_node_laws<dim>(const SceneParameters<dim> &, \
                                        const JumpBasis<dim> &);      \
  template std::vector<SlipRates<dim>> make_slip_rates<dim>(          \
    const SceneParameters<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
