// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/input_error.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/lithostatic_stress.h>

#include <algorithm>
#include <array>
#include <cmath>
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
      for (const unsigned int side : {fault, fault + 1})
        {
          const BodyParameters<dim> &body = scene.bodies[side];
          if (body.geometry.rigid)
            continue;
          const auto material = body.material.template function<dim>();
          for (unsigned int k = 0; k < points.size(); ++k)
            damping[k] +=
              1. /
              material(body.geometry.within_sides(points[k])).shear_impedance();
        }
      for (double &value : damping)
        value = 1. / value;
      return damping;
    }
  } // namespace



  template <int dim>
  NodeLaws
  make_node_laws(const SceneParameters<dim> &scene, const JumpBasis<dim> &basis)
  {
    NodeLaws result;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const FaultParameters         &fault = scene.faults[f];
        const std::vector<Point<dim>> &points =
          basis.faults()[f].slave_surface.points;
        const std::vector<RateAndStateParameters> parameters =
          fault.rate_and_state.values(points, fault.section());
        const std::vector<double> damping = radiation_damping(scene, f, points);
        std::map<std::array<double, 6>, unsigned int> known;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const RateAndStateParameters &p = parameters[i];
            const auto [place, is_new] =
              known.emplace(std::array<double, 6>{{p.a,
                                                   p.b,
                                                   p.reference_friction,
                                                   p.reference_slip_rate,
                                                   p.characteristic_slip,
                                                   damping[i]}},
                            result.laws.size());
            result.of_node.push_back(place->second);
            if (is_new)
              result.laws.push_back(
                {std::make_shared<const RateAndStateLaw>(p,
                                                         fault.regularisation),
                 fault.state_law,
                 p.characteristic_slip,
                 p.b,
                 p.a,
                 damping[i]});
          }
      }
    return result;
  }



  template <int dim>
  std::vector<double>
  make_normal_stress(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium,
                     unsigned int                  &n_in_tension)
  {
    std::vector<double> stress = equilibrium.contact_pressure;
    unsigned int        k      = 0;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const FaultParameters         &fault = scene.faults[f];
        const std::vector<Point<dim>> &points =
          basis.faults()[f].slave_surface.points;
        std::vector<double> given;
        if (fault.normal_stress_source == NormalStressSource::function)
          given = fault.normal_stress.values(points, fault.section());
        else if (fault.normal_stress_source == NormalStressSource::lithostatic)
          given = lithostatic_stress(scene, f, points);
        const unsigned int first = k;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            if (!given.empty())
              stress[k] = given[i];
            if (stress[k] < 0.)
              {
                stress[k] = 0.;
                ++n_in_tension;
              }
            ++k;
          }
        if (fault.normal_stress_source != NormalStressSource::function &&
            std::none_of(stress.begin() + first,
                         stress.begin() + k,
                         [](const double sigma) { return sigma > 0.; }))
          throw InputError(
            fault.section() +
            "/Normal stress: nothing presses this fault together; it must be "
            "'function', or there must be gravity or a boundary traction that "
            "does.");
      }
    return stress;
  }



  template <int dim>
  SystemState<dim>
  make_initial_state(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium)
  {
    SystemState<dim> state;
    state.displacement = equilibrium.displacement;
    state.velocity     = equilibrium.displacement;
    state.velocity     = 0.;
    if (scene.time.inertia == Inertia::dynamic)
      state.acceleration = state.velocity;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      for (const double theta : scene.faults[f].initial_state.values(
             basis.faults()[f].slave_surface.points, scene.faults[f].section()))
        state.alpha.push_back(std::log(theta));
    state.slip.resize(state.alpha.size());
    state.slip_rate.resize(state.alpha.size());
    state.balancing_traction = equilibrium.shear_traction;
    return state;
  }



#define STICKSLIP_INSTANTIATE(dim)                                               \
  template NodeLaws            make_node_laws<dim>(const SceneParameters<dim> &, \
                                        const JumpBasis<dim> &);      \
  template std::vector<double> make_normal_stress<dim>(                          \
    const SceneParameters<dim> &,                                                \
    const JumpBasis<dim> &,                                                      \
    const InitialEquilibrium<dim> &,                                             \
    unsigned int &);                                                             \
  template SystemState<dim> make_initial_state<dim>(                             \
    const SceneParameters<dim> &,                                                \
    const JumpBasis<dim> &,                                                      \
    const InitialEquilibrium<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
